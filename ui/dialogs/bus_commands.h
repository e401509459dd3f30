// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QWidget;

namespace syncline {
struct Error;
}  // namespace syncline

namespace syncline::ui {

class Workspace;
struct ScanOutcome;

/// Scan, go online and offline, with the choice of the link where one is needed.
class BusCommands final : public QObject {
  Q_OBJECT

 public:
  BusCommands(Workspace& workspace, QWidget& window);

  /// Asks for the link, then scans.
  void scan();
  /// Asks before a running machine is taken offline. What is found goes into an empty project, or beside the present
  /// one.
  void scanLink(const QString& link);
  /// Goes online; asks for the link when none was chosen.
  void goOnline();
  void goOffline();
  /// Asks on which bus the machine is to run from now on.
  void chooseLink();
  /// Asks, then takes the machine offline and starts it with the project as it is now.
  void restart();
  /// The start that is under way, or was the last one, was such a restart: whoever looked at a page looks on.
  [[nodiscard]] bool restarted() const { return restarted_; }
  /// Offers to end EEPROM writes that a killed program has left half done; nothing happens when there are none.
  void offerRepairs();
  /// Scans the demonstration machine in place of the project, watches its sync window, and goes online.
  void startDemo();
  void startDemo(const QString& link);

 private:
  void chooseLink(const QString& action, const std::function<void()>& then);
  void start();
  /// Why the bus did not do it, and another one where that is the way on.
  void tell(const QString& what, const QString& link, const Error& error, const std::function<void()>& other_bus);
  void tellOfScan(const QString& link, const Error& error);
  void onFound(const QString& link, const ScanOutcome& outcome);
  void showFound(const QString& link, const ScanOutcome& outcome);

  Workspace& workspace_;
  QWidget& window_;
  bool demo_ = false;
  bool restarted_ = false;
};

}  // namespace syncline::ui
