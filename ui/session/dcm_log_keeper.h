// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "record/dcm_log_session.h"
#include "support/result.h"

namespace syncline {
struct CycleSample;
struct NetworkConfig;
}  // namespace syncline

namespace syncline::ui {

class NetworkRun;

/// The log of the master synchronisation of one network (setting master.dc.log): a file of its own for each run that
/// keeps one, beside the project, in the manual's columns. A thread of its own writes.
class DcmLogKeeper final : public QObject {
  Q_OBJECT

 public:
  /// `name`: what the files' names begin with, asked when a log begins.
  DcmLogKeeper(NetworkRun& run, std::function<QString()> name, QObject* parent = nullptr);
  ~DcmLogKeeper() override;

  /// Something is on its way to the disk.
  [[nodiscard]] bool isWriting() const { return writer_ != nullptr || ending_ != nullptr; }
  /// Ends and waits for the disk: for closing the window.
  void finish();

 Q_SIGNALS:
  void began(const QString& path);
  /// The file lies there whole, or `error` says why not. Also where it could not begin.
  void ended(const QString& path, const std::optional<syncline::Error>& error);

 private:
  class Writer;
  void follow();
  void start(const NetworkConfig& config);
  void stop();
  void add(const std::vector<CycleSample>& samples);
  void waitForDisk();
  void onFinished(const Writer* of);

  NetworkRun& run_;
  std::function<QString()> name_;
  std::unique_ptr<Writer> writer_, ending_;
  std::optional<DcmLogSession> log_;  // into `writer_`
  std::thread ender_;
};

}  // namespace syncline::ui
