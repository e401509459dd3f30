// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// Installs the translation of a language ("de"; "" = the desktop's) and the matching number format.
/// False when there is none: the window then speaks English.
bool installTranslation(const QString& language);

}  // namespace syncline::ui
