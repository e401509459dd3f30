// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// What is shown, in signs that every keyboard has: a hyphen for the minus, u for micro, a space that may break. What
/// is searched and what is searched for are compared in it.
[[nodiscard]] inline QString asTyped(QString text) {
  return text.replace(QChar(0x2212), u'-')
      .replace(QChar(0x00B5), u'u')
      .replace(QChar(0x03BC), u'u')
      .replace(QChar(0x00A0), u' ');
}

}  // namespace syncline::ui
