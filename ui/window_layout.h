// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>

class QDockWidget;
class QMainWindow;

namespace syncline::ui {

class WindowCentre;
class WindowMemory;

/// Where the panels of the window stand: as usual, or as they were left.
class WindowLayout {
 public:
  struct Parts {
    QDockWidget* explorer = nullptr;
    QDockWidget* catalogue = nullptr;  // at the right, hidden until it is wanted
    QList<QDockWidget*> below;         // one behind the other, the first one in front
    WindowCentre* centre = nullptr;
  };
  WindowLayout(QMainWindow& window, WindowMemory& memory, Parts parts);

  /// All panels in their usual places and sizes; the window has its own size already.
  void reset();
  /// As it was left, where it was left by this version: after a change of panels the usual layout is better than half
  /// of an old one.
  void recall();
  /// For the next start.
  void remember();

 private:
  QMainWindow& window_;
  WindowMemory& memory_;
  Parts parts_;
};

}  // namespace syncline::ui
