// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

#include "channels/request_desk.h"
#include "ui/session/network_run.h"

namespace syncline::ui {

/// The run of the network in work: whoever shows the running machine looks here, and hears of that one alone. When
/// another network comes in work everything is another: record, phase and snapshot are told as changed.
class LiveSession final : public QObject {
  Q_OBJECT

 public:
  using Phase = NetworkRun::Phase;

  /// `run` must live until another one is shown.
  explicit LiveSession(NetworkRun& run, QObject* parent = nullptr);

  /// Another one in its place; tellShown() says so to all.
  void show(NetworkRun& run);
  void tellShown();
  [[nodiscard]] NetworkRun& run() { return *run_; }

  // As NetworkRun has them.
  Status goOnline(const QString& link, RunOrigin origin) { return run_->goOnline(link, std::move(origin)); }
  void goOffline() { run_->goOffline(); }
  void shutDown() { run_->shutDown(); }
  void requestState(AlState state) { run_->requestState(state); }
  void clearStatistics() { run_->clearStatistics(); }
  void arm() { run_->arm(); }
  [[nodiscard]] const ImageContents* image() { return run_->image(); }
  void forceOutput(std::uint32_t bit_offset, std::uint32_t bit_size, std::uint64_t value) {
    run_->forceOutput(bit_offset, bit_size, value);
  }
  void releaseOutput(std::uint32_t bit_offset, std::uint32_t bit_size) { run_->releaseOutput(bit_offset, bit_size); }
  void releaseAllOutputs() { run_->releaseAllOutputs(); }
  void advance(Nanoseconds duration) { run_->advance(duration); }
  /// Of all that are shown from now on.
  void setAutoAdvance(bool on);
  [[nodiscard]] Phase phase() const { return run_->phase(); }
  [[nodiscard]] bool isVirtual() const { return run_->isVirtual(); }
  [[nodiscard]] const QString& link() const { return run_->link(); }
  [[nodiscard]] const RunOrigin& origin() const { return run_->origin(); }
  [[nodiscard]] const Snapshot& snapshot() const { return run_->snapshot(); }
  [[nodiscard]] const RunRecord* record() const { return run_->record(); }
  [[nodiscard]] std::uint64_t droppedSamples() const { return run_->droppedSamples(); }
  [[nodiscard]] RequestDesk* requests() const { return run_->requests(); }

 Q_SIGNALS:
  void phaseChanged();
  void recordChanged();
  void applyingChanged();
  void applied();
  void snapshotChanged();
  void samplesArrived(const std::vector<syncline::CycleSample>& samples);
  void eventArrived(const syncline::Event& event);
  void drained();

 private:
  void listen();

  NetworkRun* run_;
  bool auto_advance_ = true;
};

}  // namespace syncline::ui
