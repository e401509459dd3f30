// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

class QDockWidget;
class QMainWindow;

namespace syncline::ui {

class CataloguePanel;
class ExplorerPanel;
class SlaveCommands;
class Workspace;

/// Building a machine in the window: the catalogue with its panel and the commands for slaves, tied to the explorer. It
/// ties them and does nothing itself.
class MachineBuilding final : public QObject {
  Q_OBJECT

 public:
  /// `commit`: takes what the fields hold; false where that cannot be.
  MachineBuilding(Workspace& workspace, QMainWindow& window, std::function<bool()> commit);

  [[nodiscard]] SlaveCommands& commands() { return *commands_; }
  /// The panel of the catalogue, in a dock that stands nowhere yet.
  [[nodiscard]] QDockWidget* dock() { return dock_; }
  void tieTo(ExplorerPanel& explorer);

 private:
  void report(const QString& text);
  void showWhetherSlavesStay();

  Workspace& workspace_;
  QMainWindow& window_;
  SlaveCommands* commands_;
  CataloguePanel* panel_;
  QDockWidget* dock_;
};

}  // namespace syncline::ui
