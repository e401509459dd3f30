// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QWidget>

class QLabel;
class QTabWidget;

namespace syncline::ui {

class Page;
class Pill;
class Workspace;

/// The centre of the window: the tabs of the selected node.
class DeviceEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceEditor(Workspace& workspace, QWidget* parent = nullptr);

  void showNode(int slave);
  [[nodiscard]] int node() const { return slave_; }
  [[nodiscard]] QTabWidget* tabs() { return tabs_; }
  [[nodiscard]] const QList<Page*>& pages() const { return pages_; }

  /// Takes what was typed into fields and not taken yet; false when one holds what cannot be a value.
  bool commitFields();
  void revertFields();

 private:
  void refresh();
  void showLive();
  void chooseTabs();

  Workspace& workspace_;
  QLabel *title_, *subtitle_;
  Pill* state_;
  QTabWidget* tabs_;
  QList<Page*> pages_;
  int slave_ = -1;
};

}  // namespace syncline::ui
