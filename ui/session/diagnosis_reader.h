// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

#include "protocol/diagnosis_log.h"

namespace syncline::ui {

class SlaveRequests;
struct RequestOutcome;

/// Reads the diagnosis history of a running slave (object 0x10F3), in the background of what people ask meanwhile. One
/// at a time. Nothing in the slave changes by it.
class DiagnosisReader final : public QObject {
  Q_OBJECT

 public:
  explicit DiagnosisReader(SlaveRequests& requests, QObject* parent = nullptr);

  /// `slave`: position in the running configuration. Ends one that runs.
  void start(std::uint16_t slave);
  void cancel();
  [[nodiscard]] bool isRunning() const { return running_; }

 Q_SIGNALS:
  void read(const syncline::DiagnosisLog& log);
  /// The slave has no such object.
  void absent();
  void failed(const QString& why);

 private:
  /// A slave that tells faster than it is read is shown as it was at the last of these.
  static constexpr int kRounds = 3;

  void ask(std::uint8_t sub_index, std::function<void(const RequestOutcome&)> what);
  void takeLast(const RequestOutcome& outcome);
  void readHeader();
  void readMessages();
  void lookAgain();
  void finish();
  void fail(const QString& why);

  SlaveRequests& requests_;
  DiagnosisHeader header_;
  std::vector<std::pair<std::uint8_t, std::vector<std::uint8_t>>> messages_;
  std::size_t open_ = 0;
  int rounds_ = 0;
  std::uint16_t slave_ = 0;
  bool running_ = false;
};

}  // namespace syncline::ui
