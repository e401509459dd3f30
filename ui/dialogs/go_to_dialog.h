// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QPointer>
#include <optional>
#include <vector>

#include "ui/dialogs/go_to_search.h"

class QAction;
class QLineEdit;
class QListWidget;
class QMenu;
class QMenuBar;

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::ui {

/// The way to anything by a few letters: slaves by name, position, address or type, settings of the master and of every
/// slave by label or key, objects of every slave by index or name, actions of the window.
class GoToDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `node`: the selected one, whose settings and objects come first. The project must outlive it.
  /// `menus`: whose commands are offered. Goes with its end.
  GoToDialog(const Project& project, int node, const QMenuBar& menus, QWidget* parent);

 Q_SIGNALS:
  void nodeWanted(int slave);
  void keyWanted(const QString& key);
  void objectWanted(int slave, syncline::coe::ObjectAddress object);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  struct Goal {
    QString text{}, detail{};
    QString found_by{};  // in lower case
    int slave = -2;      // -1 = the master
    QString key{};
    QPointer<QAction> action{};
    std::optional<coe::ObjectAddress> object{};
  };
  void addNodes(const Project& project);
  void addSettings(const Project& project, int node);
  void addActions(const QMenu& menu);
  void addGoal(Goal goal);
  void showMatches();
  void showOfSlaves(const QStringList& words);
  void addItem(const QString& text, const QString& detail, std::size_t goal);
  void go();

  GoToSearch search_;
  std::vector<Goal> goals_;
  std::size_t fixed_ = 0;  // of them; those of slaves that were found come behind
  QLineEdit* words_;
  QListWidget* list_;
};

}  // namespace syncline::ui
