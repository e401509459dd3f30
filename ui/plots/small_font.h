// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>

namespace syncline::ui {

/// Of the marks of an axis, in a widget with `font`.
[[nodiscard]] QFont smallFont(const QFont& font);

}  // namespace syncline::ui
