// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "record/black_box.h"

namespace syncline::ui {

/// What a black box holds and where, lines of plain text; why it ended early.
[[nodiscard]] QString blackBoxText(const BlackBox::Report& report);

}  // namespace syncline::ui
