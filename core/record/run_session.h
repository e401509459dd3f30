// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "channels/background_master.h"
#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/snapshot.h"

namespace syncline {

struct MasterChannels;

/// What the channels of a run held since they were looked at before.
struct RunNews {
  std::vector<CycleSample> samples;
  std::vector<Event> events;
  const Snapshot* snapshot = nullptr;  // a newer one; as old as the samples, or older

  /// Gives it to a recorder of the run, the samples before the snapshot that came with them, and the events before it,
  /// too: it shows what came of them.
  template <class Recorder>
  void feed(Recorder& recorder) const {
    recorder.add(samples);
    for (const auto& event : events) recorder.add(event);
    if (snapshot != nullptr) recorder.add(*snapshot);
  }
};

/// One run of a configuration by a background master, from the command that begins it until the master has ended, as
/// its owner drives it: commands go in, and drain() takes out what came. Who calls it, a timer of the window or a loop
/// of the command line (core/engine/run_network), is its owner's matter. For the thread that drains.
class RunSession {
 public:
  /// kSilent: started or online, but its thread gives no sign of life; what it told before is not true any more.
  enum class Phase : std::uint8_t { kOffline, kStarting, kOnline, kSilent, kStopping };
  /// What becomes of the master's thread.
  enum class Sign : std::uint8_t {
    kSilent,   // it has given no sign of life for some time
    kAlive,    // it has given one again
    kGivenUp,  // it did not end when it should: what it does is not known, nor the state of its slaves
  };
  /// By the clock on the wall: the master's may be what stands still.
  struct Patience {
    std::chrono::milliseconds silence{2000};  // without a sign of life, and it is silent
    std::chrono::milliseconds stop{3000};     // its end is waited for so long
  };

  RunSession() = default;
  /// As end() with the patience that was set.
  ~RunSession();
  RunSession(const RunSession&) = delete;
  RunSession& operator=(const RunSession&) = delete;

  void set_patience(const Patience& patience) { patience_ = patience; }
  [[nodiscard]] const Patience& patience() const { return patience_; }

  /// From now on the master of this session, which must have none. Nothing is told to it yet: who wants its raw frames
  /// opens their ring now.
  void take(std::unique_ptr<BackgroundMaster> master);
  /// Null: there is none.
  [[nodiscard]] BackgroundMaster* master() const { return master_.get(); }
  [[nodiscard]] MasterChannels& channels() const;
  [[nodiscard]] bool is_virtual() const { return master_ && master_->is_virtual(); }
  /// False: nobody takes commands any more.
  [[nodiscard]] bool send(MasterCommand command);

  /// Tells the master what to run, the variables first, which then are in the samples from the first cycle on; the
  /// phase is kStarting. False as send().
  [[nodiscard]] bool go_online(const NetworkConfig& config, AlState target, const WatchCommand& watch);
  /// A thread of the master's carries it out from here on; without that step() and run_for() of the master do.
  void start();
  /// Takes what the channels hold. Valid until the next call; its owner may move out of it.
  RunNews& drain();
  /// What an event means for the phase; told by the owner, behind whatever he does with the event himself.
  void follow(const Event& event);
  /// The master has told that the run is over: it is to be ended.
  [[nodiscard]] bool over() const { return over_; }
  /// Of a master with a thread of its own. Once: it has fallen silent, and its snapshot is forgotten, or is alive
  /// again.
  [[nodiscard]] std::optional<Sign> listen();

  /// The phase is kStopping. `cancel`: what is under way is broken off. False as send().
  bool go_offline(bool cancel);
  /// Carries that out here, unless a thread does.
  void run_down();
  /// How long it has been kStopping is more than the patience for it.
  [[nodiscard]] bool is_overdue() const;
  /// The master takes its slaves to INIT and its thread is waited for, in a thread beside this one; the phase is
  /// kOffline, without a snapshot. False when it has not ended within `patience`: then it is left alone there, alive as
  /// long as its thread is, and ends when that does. One that has no thread of its own ends at once.
  bool end(std::chrono::milliseconds patience);

  [[nodiscard]] Phase phase() const { return phase_; }
  /// The newest one; empty before the first.
  [[nodiscard]] const Snapshot& snapshot() const { return snapshot_; }

 private:
  using WallClock = std::chrono::steady_clock;

  std::unique_ptr<BackgroundMaster> master_;
  Patience patience_;
  Phase phase_ = Phase::kOffline, phase_before_silence_ = Phase::kOffline;
  bool over_ = false;
  Snapshot snapshot_;
  RunNews news_;
  std::uint64_t heard_ = 0;  // of the master's heart
  WallClock::time_point heard_at_, stopping_since_;
};

}  // namespace syncline
