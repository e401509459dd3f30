// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "reports/acceptance.h"

namespace syncline::ui {

/// The words of core/reports in the window's language.
[[nodiscard]] QString criterionText(reports::Criterion::Kind kind);
[[nodiscard]] QString verdictText(reports::Verdict verdict);
[[nodiscard]] QString acceptanceText(reports::Verdict verdict);
[[nodiscard]] QString requiredText(const reports::Criterion& criterion);
[[nodiscard]] QString foundText(const reports::Criterion& criterion);

}  // namespace syncline::ui
