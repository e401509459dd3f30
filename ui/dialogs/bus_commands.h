// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace syncline::ui {

class Workspace;

/// Scan, go online and offline, with the choice of the link where one is needed.
class BusCommands final : public QObject {
  Q_OBJECT

 public:
  BusCommands(Workspace& workspace, QWidget& window);

  /// Asks for the link, then scans.
  void scan();
  void scanLink(const QString& link);
  /// Goes online; asks for the link when none was chosen.
  void goOnline();
  void goOffline();
  /// Offers to end EEPROM writes that a killed program has left half done; nothing happens when there are none.
  void offerRepairs();
  /// Scans the demonstration machine, watches its sync window, and goes online.
  void startDemo();
  void startDemo(const QString& link);

 private:
  void start();

  Workspace& workspace_;
  QWidget& window_;
  bool demo_ = false;
};

}  // namespace syncline::ui
