// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

class QAction;
class QLabel;
class QMenu;
class QTabWidget;

namespace syncline::coe {
struct ObjectAddress;
}  // namespace syncline::coe

namespace syncline::ui {

class EniPage;
struct Message;
class Page;
class Pill;
class Segments;
class SlaveStateBar;
class SlaveObjectsPage;
class SlaveStateCommands;
class ValueLabel;
class Workspace;

/// The centre of the window: the tabs of the selected node, all of them, those that configure or those that diagnose.
class DeviceEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceEditor(Workspace& workspace, QWidget* parent = nullptr);

  /// Of any slave, for menus.
  [[nodiscard]] SlaveStateCommands& states() { return *commands_; }

  enum class Mode { kAll, kConfiguration, kDiagnosis };
  [[nodiscard]] Mode mode() const { return mode_; }
  /// Remembered. Nothing changes while a field holds what cannot be a value.
  void setMode(Mode mode);
  /// For menus.
  [[nodiscard]] const QList<QAction*>& modeActions() const;

  void showNode(int slave);
  [[nodiscard]] int node() const { return slave_; }
  [[nodiscard]] QTabWidget* tabs() { return tabs_; }
  [[nodiscard]] const QList<Page*>& pages() const { return pages_; }

  /// Goes to the field of a setting ("slave.3.alias"), on whatever page it is; shows expert settings and all pages for
  /// it. False: there is no such field.
  bool showKey(const QString& key);

  /// Goes to the page of the ENI and marks there what depends on a setting.
  void showInEni(const QString& key);

  /// Goes to a page of the shown node by its object name; nothing where the node has none.
  void showPage(const char* object_name);
  /// Goes to an object of the shown slave, as its ESI describes it.
  void showObject(coe::ObjectAddress object);

  /// Takes what was typed into fields and not taken yet; false when one holds what cannot be a value.
  bool commitFields();
  void revertFields();

 Q_SIGNALS:
  /// The buttons of the ENI's page.
  void compareWanted();
  void exportWanted();
  void findingMenuOpens(QMenu& menu, const syncline::ui::Message& about);
  /// Another node has to be shown for a field.
  void nodeWanted(int slave);

 private:
  void refresh();
  void showNotes();
  void showLive();
  void chooseTabs(QString front = {});
  [[nodiscard]] Segments* buildModes();
  void buildEniKey();
  [[nodiscard]] bool isShown(const Page& page) const;
  /// Brings a page to the front, whatever the mode.
  void reveal(Page* page);

  Workspace& workspace_;
  QLabel* title_;
  ValueLabel* subtitle_;
  Pill* state_;
  SlaveStateCommands* commands_;
  SlaveStateBar* state_bar_;
  Segments* modes_;
  Mode mode_ = Mode::kAll;
  QTabWidget* tabs_;
  QList<Page*> pages_;
  EniPage* eni_ = nullptr;
  SlaveObjectsPage* objects_ = nullptr;
  int slave_ = -1;
  QString front_of_master_, front_of_slaves_;  // titles of the pages that were in front last
};

}  // namespace syncline::ui
