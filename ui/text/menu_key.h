// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// A menu's text as it stands on a button or in a list, without its key: "&Scan…" and "扫描(&S)…" lose it; Qt's own way
/// leaves "(S)" standing.
[[nodiscard]] QString withoutMenuKey(QString text);

}  // namespace syncline::ui
