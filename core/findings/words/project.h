// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "findings/words/joined.h"
#include "findings/words/project_data.h"
#include "findings/words/project_master.h"
#include "findings/words/project_slaves.h"
#include "findings/words/recovered.h"

namespace syncline::words {

/// What is wrong with a project, and what could not be recovered of an ENI.
inline constexpr auto kProject = joined(kProjectMaster, kProjectSlaves, kProjectData, kRecovered);

}  // namespace syncline::words
