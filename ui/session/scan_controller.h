// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <atomic>
#include <memory>
#include <thread>

#include "channels/event.h"
#include "channels/values/bus_scan.h"
#include "eni/project/project_builder.h"
#include "support/result.h"
#include "ui/session/bus_connection.h"

namespace syncline::ui {

/// Scans a bus in the background on a link of its own and builds a project of what it finds.
class ScanController final : public QObject {
  Q_OBJECT

 public:
  /// `describe` may be empty.
  ScanController(BusScanner scanner, SlaveDescriber describe, QStringList esi_folders, QObject* parent = nullptr);
  ~ScanController() override;

  /// No-op while a scan runs.
  void start(const QString& link);
  /// Ends the scan within a cycle; failed() with kCancelled follows.
  void cancel();
  [[nodiscard]] bool isRunning() const { return running_; }

 Q_SIGNALS:
  void started(const QString& link);
  void progress(int done, int found);
  /// What a user has to know while the scan runs: a running machine is touched.
  void eventArrived(const syncline::Event& event);
  void finished(const QString& link, const syncline::eni::BuiltProject& built);
  void failed(const QString& link, const syncline::Error& error);

 private:
  Result<eni::BuiltProject> run(const QString& link);
  void tell(const Event& event);
  void deliver(const QString& link, Result<eni::BuiltProject> result);

  BusScanner scanner_;
  SlaveDescriber describe_;
  QStringList esi_folders_;
  std::thread worker_;
  std::atomic<bool> cancelled_{false};
  bool running_ = false;
};

}  // namespace syncline::ui
