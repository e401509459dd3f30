// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <memory>
#include <vector>

#include "channels/image_contents.h"
#include "config/network_config.h"
#include "config/project.h"
#include "record/run_note.h"
#include "record/run_session.h"
#include "support/result.h"
#include "ui/session/bus_connection.h"
#include "ui/session/variable_watch.h"

namespace syncline {
class FrameRing;
class RunRecord;
struct KeptTrigger;
class RequestDesk;
}  // namespace syncline

namespace syncline::ui {

/// What a run was begun with, and what was applied to it since.
struct RunOrigin {
  Project project;
  QString path;  // its file when it was begun; "" where it had none
  NetworkConfig config;
};

/// The running master of one network as the window sees it: commands go in, and on one tick the channels are drained
/// into the run's record and into signals, whichever network is in work. A thread of the master's runs the cycles; on a
/// virtual clock a test may, too, by advance().
class NetworkRun final : public QObject {
  Q_OBJECT

 public:
  using Phase = RunSession::Phase;
  using Sign = RunSession::Sign;

  explicit NetworkRun(MasterOpener opener, QObject* parent = nullptr);
  /// As shutDown() ends it.
  ~NetworkRun() override;

  void setPatience(const RunSession::Patience& patience) { session_.set_patience(patience); }

  /// Opens the link and brings the bus to OP in the background.
  Status goOnline(const QString& link, RunOrigin origin);
  void goOffline();
  /// Ends at once and waits for the thread, as long as Patience says: for closing the window.
  void shutDown();
  void requestState(AlState state);
  void clearStatistics();
  /// Figures and faults of the overview begin anew.
  void arm();
  /// What the user writes at a moment of the run; nothing without one.
  void addNote(const RunNote& note);
  /// What a trigger has found, to be kept with the run.
  void keepTrigger(const KeptTrigger& kept);
  /// Gives the running master synchronisation the parameters of another origin, which is what runs as soon as the
  /// master has taken them (applied()). What it refuses comes as an event, and what runs stays. Nothing while one is
  /// under way.
  void apply(RunOrigin origin);
  /// Given to the master, who has not answered yet.
  [[nodiscard]] bool applying() const { return applying_ != nullptr; }

  /// What stands in the process image now, at most 0.1 s old; null when nothing runs. Valid until the next call.
  [[nodiscard]] const ImageContents* image();
  /// Holds 1 to 64 bits of the outputs at a value; what became of it comes as an event.
  void forceOutput(std::uint32_t bit_offset, std::uint32_t bit_size, std::uint64_t value);
  void releaseOutput(std::uint32_t bit_offset, std::uint32_t bit_size);
  void releaseAllOutputs();

  /// Which variables the samples hold from now on, those that the running configuration has; in later runs, too. A run
  /// keeps WatchLists::kMostVariables in all: kNotSupported where these are more, and it goes on with those before.
  Status watch(std::vector<VariableName> names);

  /// Runs `duration` of machine time at once and drains the channels; virtual clock only.
  void advance(Nanoseconds duration);
  /// Whether a virtual clock runs by itself; tests switch it off before going online and call advance().
  void setAutoAdvance(bool on) { auto_advance_ = on; }

  [[nodiscard]] Phase phase() const { return session_.phase(); }
  /// The run that was the last one left a master behind that did not end.
  [[nodiscard]] bool givenUp() const { return given_up_; }
  [[nodiscard]] bool isVirtual() const { return session_.is_virtual(); }
  [[nodiscard]] const QString& link() const { return link_; }
  /// Of the run that goes on, or was the last one.
  [[nodiscard]] const RunOrigin& origin() const { return origin_; }
  [[nodiscard]] const Snapshot& snapshot() const { return session_.snapshot(); }
  /// The run that goes on, or was the last one; null before the first.
  [[nodiscard]] const RunRecord* record() const { return record_.get(); }
  [[nodiscard]] std::uint64_t droppedSamples() const;
  /// Where its raw frames go for who opens it; null when offline.
  [[nodiscard]] std::shared_ptr<FrameRing> frames() const;
  /// Where requests on single slaves go in; null when offline. Use SlaveRequests.
  [[nodiscard]] RequestDesk* requests() const;

 Q_SIGNALS:
  void phaseChanged();
  void signSeen(syncline::RunSession::Sign sign);
  /// Another run has begun: the record before is gone when this returns.
  void recordChanged();
  void applyingChanged();
  /// origin() is another one: the machine has taken it.
  void applied();
  void snapshotChanged();
  void samplesArrived(const std::vector<syncline::CycleSample>& samples);
  void eventArrived(const syncline::Event& event);
  void noteAdded(const syncline::RunNote& note);
  void triggerKept();
  /// Other variables than before: samples of a list after the latest of the record's may come.
  void watchChanged(const std::vector<syncline::WatchedVariable>& variables);
  /// All channels have been looked at, whether there was something or not.
  void drained();

 private:
  struct Applying;
  void send(MasterCommand command);
  void tellDeaf();
  void tick();
  void hearHeart();
  void drain();
  void takeAnswers();
  void close(std::chrono::milliseconds patience);
  void tellPhase();

  MasterOpener opener_;
  QTimer tick_;
  Phase told_phase_ = Phase::kOffline;  // by phaseChanged()
  bool given_up_ = false;
  bool auto_advance_ = true;
  QString link_;
  RunOrigin origin_;
  std::unique_ptr<Applying> applying_;
  std::unique_ptr<RunRecord> record_;
  std::vector<VariableName> watched_;
  ImageContents image_;
  RunSession session_;  // has a master as long as it is not offline; last: its end is that of the rest
};

}  // namespace syncline::ui
