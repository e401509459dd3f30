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
  [[nodiscard]] QList<QAction*> all() const { return {next_, add_, remove_}; }
  /// Refused, with a reason in the status bar, while a machine runs or a recording is shown.
  void choose(int network);

 private:
  void update();
  [[nodiscard]] bool may();
  void add();
  void remove();

  Workspace& workspace_;
  QWidget& window_;
  std::function<bool()> commit_;
  QAction *next_, *add_, *remove_;
};

}  // namespace syncline::ui
