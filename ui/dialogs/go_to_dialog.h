// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QPointer>
#include <vector>

#include "config/project.h"

class QAction;
class QLineEdit;
class QListWidget;

namespace syncline::ui {

/// The way to anything by a few letters: slaves by name, position, address or type, settings of the selected node and
/// of the master by label or key, actions of the window.
class GoToDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `node`: the selected one, whose settings are offered.
  GoToDialog(const Project& project, int node, const QList<QAction*>& actions, QWidget* parent);

 Q_SIGNALS:
  void nodeWanted(int slave);
  void keyWanted(const QString& key);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  struct Goal {
    QString text{}, detail{};
    QString found_by{};  // in lower case
    int slave = -2;      // -1 = the master
    QString key{};
    QPointer<QAction> action{};
  };
  void addNodes(const Project& project);
  void addSettings(const Project& project, int node);
  void addActions(const QList<QAction*>& actions);
  void addGoal(Goal goal);
  void showMatches();
  void go();

  std::vector<Goal> goals_;
  QLineEdit* words_;
  QListWidget* list_;
};

}  // namespace syncline::ui
