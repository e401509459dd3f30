// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/types.h"
#include "trace/signals.h"

/// Triggers, as an oscilloscope has them: moments of a run at which a signal, an event or a finding does what was asked
/// for, each with the time before and after it.
namespace syncline {

struct Event;
struct Finding;
class SampleStore;

struct Trigger {
  enum class Kind : std::uint8_t {
    kLevel,    // the signal crosses `level`
    kWindow,   // the signal leaves or enters [low, high]
    kEvent,    // an event of `code`
    kFinding,  // a finding of `code` that has a moment at which it began
  };
  /// How the picture follows; an evaluator only knows that a single one ends with its first episode.
  enum class Mode : std::uint8_t { kAutomatic, kNormal, kSingle };
  enum class Edge : std::uint8_t { kUp, kDown, kEither };  // of a level

  Kind kind = Kind::kLevel;
  Mode mode = Mode::kNormal;
  Signal signal = Signal::kDeviation;  // of those that are drawn, not SignalInfo::Form::kCell
  int slave = -1;                      // whose signal, where it is one of slaves; of events and findings -1: of any
  std::string variable{};              // its name, where the signal is that of a watched one
  Edge edge = Edge::kUp;
  bool magnitude = false;           // of the absolute value of the signal
  bool enters = false;              // of a window: comes in; else goes out
  double level = 1000;              // in the signal's unit
  double low = -1000, high = 1000;  // inside are both
  std::string code{};               // of event_finding(): "event-slave-lost"; of a finding: "frames-lost"
  Nanoseconds hold_off = kSecond;   // after an episode's moment no other one begins; 0: each counts
  Nanoseconds pre = kSecond, post = kSecond;
  bool operator==(const Trigger&) const = default;
};

/// Whatever their modes, they find the same; a single one is done with the first of it.
[[nodiscard]] bool finds_the_same(Trigger one, const Trigger& other);

struct TriggerEpisode {
  Nanoseconds time = 0;                // host clock
  std::optional<std::uint64_t> cycle;  // in which it was; nothing where it is not kept any more
  int slave = -1;                      // the signal's or the event's
  double value = 0;                    // of the sample that fired; of events and findings 0
  Nanoseconds from = 0, to = 0;        // with what was asked for before and after, also where the run does not reach
  std::uint64_t left_out = 0;          // further ones within the hold-off
  bool operator==(const TriggerEpisode&) const = default;
};

/// Finds the episodes of one run, in the order of time: every sample that the store keeps is looked at once, however
/// often and in whatever portions it is asked, so that a run and its recording have the same. A crossing is between two
/// neighbouring samples that both have a value: after a gap nothing has been crossed. Values are those of the store:
/// exact up to 2^24, above that to seven digits. For one thread.
class TriggerWatch {
 public:
  static constexpr std::size_t kMostEpisodes = 256;  // without a hold-off each cycle may be one
  static constexpr Nanoseconds kAll = std::numeric_limits<Nanoseconds>::max();

  /// `from`: host clock; what was before does not count.
  explicit TriggerWatch(Trigger trigger, Nanoseconds from = std::numeric_limits<Nanoseconds>::min());

  /// The next samples, those of `portion` ns of the run at most; true: there are no more now.
  bool look(const SampleStore& store, Nanoseconds portion = kAll);
  /// In the order of their coming; the cycle is taken from the store.
  void hear(const Event& event, const SampleStore& store);
  /// All that is found by now, as often as one likes: a finding fires once for each moment at which it began.
  void hear(std::span<const Finding> findings, const SampleStore& store);

  [[nodiscard]] const Trigger& trigger() const { return trigger_; }
  /// The latest; of kMostEpisodes the earlier half goes when another one comes.
  [[nodiscard]] const std::vector<TriggerEpisode>& episodes() const { return episodes_; }
  /// All, with those that were forgotten for later ones.
  [[nodiscard]] std::uint64_t count() const { return forgotten_ + episodes_.size(); }
  /// Within the hold-offs of all episodes.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }
  /// A single one that has fired.
  [[nodiscard]] bool done() const { return trigger_.mode == Trigger::Mode::kSingle && !episodes_.empty(); }

  enum class State : std::uint8_t { kFilling, kWaiting, kTriggered, kHoldingOff, kDone };
  /// At `now`, of a run that began at `begin`. Filling: the time before a trigger is not there in full yet; one that
  /// comes counts all the same.
  [[nodiscard]] State state(Nanoseconds begin, Nanoseconds now) const;

 private:
  void take(Nanoseconds time, float value, Nanoseconds longest_gap, const SampleStore& store);
  [[nodiscard]] bool fires(double before, double now) const;
  void fire(Nanoseconds time, int slave, double value, const SampleStore& store);

  Trigger trigger_;
  Nanoseconds next_;  // samples from here on have not been looked at
  Nanoseconds begin_;
  std::optional<double> before_;
  Nanoseconds before_time_ = 0;
  std::set<std::pair<Nanoseconds, int>> found_;  // moments of findings that were heard, and of which slave
  std::vector<TriggerEpisode> episodes_;
  std::uint64_t forgotten_ = 0, left_out_ = 0;
};

}  // namespace syncline
