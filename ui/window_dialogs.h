// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "protocol/coe.h"
#include "ui/session/comparison.h"

class QMainWindow;

namespace syncline::ui {

class FileCommands;
class Workspace;

/// The windows beside the main one that look at the whole project: comparison, a new machine, the search.
class WindowDialogs final : public QObject {
  Q_OBJECT

 public:
  WindowDialogs(Workspace& workspace, FileCommands& files, QMainWindow& window);

  void compare(const ComparedSide& left, const ComparedSide& right);
  /// Until it is finished, nothing of the window is touched.
  void makeNewMachine();
  /// `node`: the one that is selected, -1 the master.
  void search(int node);

 Q_SIGNALS:
  void placeWanted(int node, const QString& key);
  void nodeWanted(int node);
  void keyWanted(const QString& key);
  void objectWanted(int slave, syncline::coe::ObjectAddress object);

 private:
  Workspace& workspace_;
  FileCommands& files_;
  QMainWindow& window_;
};

}  // namespace syncline::ui
