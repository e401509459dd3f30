// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QList>
#include <QObject>

#include "ui/window_layout.h"

class QDockWidget;
class QMainWindow;

namespace syncline::ui {

class ExplorerPanel;
class FindingsPanel;
class MessagesPanel;
class TriggerPanel;
class WindowCentre;
class Workspace;

/// The docks of the window with their panels: what they are called and when they can be used. Who hears of what the
/// panels say is not theirs.
class WindowDocks final : public QObject {
  Q_OBJECT

 public:
  /// `catalogue`: a dock of somebody else, which stands hidden at the right.
  WindowDocks(Workspace& workspace, QMainWindow& window, QDockWidget& catalogue);

  [[nodiscard]] ExplorerPanel& explorer() { return *explorer_; }
  [[nodiscard]] MessagesPanel& messages() { return *messages_; }
  [[nodiscard]] FindingsPanel& findings() { return *findings_; }
  [[nodiscard]] TriggerPanel& trigger() { return *trigger_; }
  /// In front of the others of its place.
  void showTrigger();
  /// Each shows or hides a dock.
  [[nodiscard]] QList<QAction*> toggles() const;
  [[nodiscard]] WindowLayout::Parts parts(WindowCentre& centre) const;

 private:
  QDockWidget* dock(const char* name, const QString& title, QWidget& panel, Qt::DockWidgetArea area);
  void showFindingCount();
  void showRecording();

  Workspace& workspace_;
  QMainWindow& window_;
  ExplorerPanel* explorer_;
  MessagesPanel* messages_;
  FindingsPanel* findings_;
  TriggerPanel* trigger_;
  QDockWidget *explorer_dock_, *catalogue_dock_, *messages_dock_, *findings_dock_, *trigger_dock_;
};

}  // namespace syncline::ui
