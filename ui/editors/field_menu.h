// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QString>

namespace syncline::ui {

/// The key for what depends on the field that has the focus; in its context menu, too.
inline constexpr QKeyCombination kShowInEniKey = Qt::CTRL | Qt::Key_I;

[[nodiscard]] QString showInEniText();

}  // namespace syncline::ui
