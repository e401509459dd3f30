// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <functional>

class QAction;
class QWidget;

namespace syncline::ui {

class Workspace;

/// What is done to the networks of a machine: another one comes in work, one is added, one is removed.
class NetworkCommands final : public QObject {
  Q_OBJECT

 public:
  /// `commit`: hands in what is being typed; false: a field holds what cannot be a value.
  NetworkCommands(Workspace& workspace, QWidget& window, std::function<bool()> commit);

  /// For the menu.
  [[nodiscard]] QList<QAction*> all() const { return {next_, add_, remove_, all_offline_}; }
  /// Also while networks run; refused while a recording is shown, a bus is scanned or a slave is being written to.
  void choose(int network);

 Q_SIGNALS:
  /// Why what was wanted is not done now, a sentence.
  void refused(const QString& why);

 private:
  void update();
  [[nodiscard]] QString whyNot() const;
  [[nodiscard]] bool may();
  void add();
  void remove();

  Workspace& workspace_;
  QWidget& window_;
  std::function<bool()> commit_;
  QAction *next_, *add_, *remove_, *all_offline_;
};

}  // namespace syncline::ui
