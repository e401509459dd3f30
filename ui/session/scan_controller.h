// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <atomic>
#include <memory>
#include <thread>

#include "channels/event.h"
#include "eni/project/project_builder.h"
#include "support/result.h"
#include "ui/session/bus_connection.h"

namespace syncline::ui {

/// What a scan gave.
struct ScanOutcome {
  eni::BuiltProject built;
  /// Nothing was written to the bus, because `running` slaves are beyond INIT: EEPROMs that belong to their PDI, clocks
  /// and object dictionaries were not read.
  bool looked_only = false;
  std::size_t running = 0;
};

/// Scans a bus in the background on a link of its own and builds a project of what it finds.
class ScanController final : public QObject {
  Q_OBJECT

 public:
  /// `describe` may be empty.
  ScanController(BusScanner scanner, SlaveDescriber describe, QStringList esi_folders, QObject* parent = nullptr);
  ~ScanController() override;

  /// A running machine is only looked at, unless somebody has said that it may be touched.
  enum class Depth { kLookFirst, kTouch };
  /// No-op while a scan runs.
  void start(const QString& link, Depth depth = Depth::kLookFirst);
  /// Ends the scan within a cycle; failed() with kCancelled follows.
  void cancel();
  [[nodiscard]] bool isRunning() const { return running_; }

 Q_SIGNALS:
  void started(const QString& link);
  void progress(int done, int found);
  /// What a user has to know while the scan runs: a running machine is touched.
  void eventArrived(const syncline::Event& event);
  void finished(const QString& link, const syncline::ui::ScanOutcome& outcome);
  void failed(const QString& link, const syncline::Error& error);

 private:
  Result<ScanOutcome> run(const QString& link, Depth depth);
  void tell(const Event& event);
  void deliver(const QString& link, Result<ScanOutcome> result);

  BusScanner scanner_;
  SlaveDescriber describe_;
  QStringList esi_folders_;
  std::thread worker_;
  std::atomic<bool> cancelled_{false};
  bool running_ = false;
};

}  // namespace syncline::ui
