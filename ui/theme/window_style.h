// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QProxyStyle>

namespace syncline::ui::theme {

/// Fusion, in which the chosen tab of a row of tabs has a line in the colour of a selection along its outer edge: by
/// its ground alone it cannot be told where all grounds are black, and hardly elsewhere.
class WindowStyle final : public QProxyStyle {
  Q_OBJECT

 public:
  WindowStyle();

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
};

}  // namespace syncline::ui::theme
