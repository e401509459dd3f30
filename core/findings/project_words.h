// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "findings/joined_words.h"
#include "findings/project_data_words.h"
#include "findings/project_master_words.h"
#include "findings/project_slaves_words.h"
#include "findings/recovered_words.h"

namespace syncline::words {

/// What is wrong with a project, and what could not be recovered of an ENI.
inline constexpr auto kProject = joined(kProjectMaster, kProjectSlaves, kProjectData, kRecovered);

}  // namespace syncline::words
