// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/small_font.h"

#include <algorithm>

namespace syncline::ui {

QFont smallFont(const QFont& font) {
  auto small = font;
  small.setPointSizeF(std::max(small.pointSizeF() * 0.85, 7.0));
  return small;
}

}  // namespace syncline::ui
