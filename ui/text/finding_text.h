// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>

#include "findings/finding.h"

namespace syncline::ui {

/// What was seen and why, in the user's language.
[[nodiscard]] QString findingText(const RunFinding& finding);
/// What to do; empty where nothing is to be done.
[[nodiscard]] QString findingAdvice(const RunFinding& finding);

/// Key of the setting that would mend it, "slave.3.dc.sync0.shift_us"; empty where there is none.
[[nodiscard]] QString findingKey(const RunFinding& finding);

/// The sentences and phrases that translations know.
[[nodiscard]] std::span<const char* const> translatableFindings();

}  // namespace syncline::ui
