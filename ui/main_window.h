// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMainWindow>
#include <memory>

class QToolButton;

namespace syncline::ui {

class Actions;
class BusCommands;
class ColumnMemory;
class DeviceEditor;
class ExplorerPanel;
class FileCommands;
class LiveStrip;
class FindingsPanel;
struct Message;
class MessagesPanel;
class OverviewPanel;
class RecordingCommands;
class MachineBuilding;
class NetworkCommands;
class TemplateCommands;
class WindowCentre;
class WindowDialogs;
class WindowDocks;
class WindowOverlay;
class WindowLayout;
class Workspace;

/// The window: layout, actions, and who is connected to whom. The work is done in session and dialogs.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Workspace& workspace, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] FileCommands& files() { return *files_; }
  [[nodiscard]] TemplateCommands& templates() { return *templates_; }
  [[nodiscard]] BusCommands& bus() { return *bus_; }
  [[nodiscard]] RecordingCommands& recordings() { return *recordings_; }
  [[nodiscard]] WindowOverlay& overlay() { return *overlay_; }
  [[nodiscard]] DeviceEditor& editor() { return *editor_; }
  [[nodiscard]] MachineBuilding& building() { return *building_; }
  [[nodiscard]] ExplorerPanel& explorer() { return *explorer_; }
  [[nodiscard]] LiveStrip& liveStrip() { return *strip_; }
  void selectNode(int slave) { goTo(slave, {}); }
  [[nodiscard]] WindowLayout& panels() { return *layout_; }

  /// What is looked at, for a window that comes in place of this one.
  struct Place {
    int node = -1;
    QString page;  // object name
    bool overview = false;
  };
  [[nodiscard]] Place place() const;
  void goToPlace(const Place& place);

 Q_SIGNALS:
  /// Another language was chosen: a window that is made from now on speaks it.
  void languageChosen();

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildCentre();
  void connectDocks();
  void buildMenus();
  void connectActions();
  bool commitFields();
  void connectSession();
  void updateTitle();
  void updateActions();
  void updateRecordingActions();
  void showRun();
  void showRecord();
  void showLimits();
  void showOverview(bool overview);
  void goToMoment(qint64 moment);
  void selectMoment(qint64 moment);
  void goToMessage(const Message& message);
  void updateTheme();
  void goTo(int slave, const QString& key);
  void showWhetherItGoesOn();
  void takeUp();

  Workspace& workspace_;
  Actions* actions_;
  FileCommands* files_;
  TemplateCommands* templates_;
  NetworkCommands* networks_;
  WindowDialogs* dialogs_;
  BusCommands* bus_;
  RecordingCommands* recordings_;
  MachineBuilding* building_;
  WindowCentre* centre_ = nullptr;
  DeviceEditor* editor_ = nullptr;
  OverviewPanel* overview_ = nullptr;
  MessagesPanel* messages_ = nullptr;
  FindingsPanel* findings_ = nullptr;
  LiveStrip* strip_ = nullptr;
  ExplorerPanel* explorer_ = nullptr;
  WindowDocks* docks_ = nullptr;
  WindowOverlay* overlay_ = nullptr;
  QToolButton* state_button_ = nullptr;
  std::unique_ptr<WindowLayout> layout_;
  ColumnMemory* columns_ = nullptr;  // from the first show on
  bool laid_out_ = false;
};

}  // namespace syncline::ui
