// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "link/arrival_forecast.h"
#include "support/result.h"

namespace syncline::sim {
class SimBus;
}  // namespace syncline::sim

namespace syncline {

class Clock;
class RawPort;

/// What a simulated segment has served.
struct ResponderCounters {
  /// Service times are counted in buckets of this width; the last bucket takes all above.
  static constexpr Nanoseconds kBucket = 500;
  static constexpr std::size_t kBuckets = 4'000;

  std::uint64_t frames = 0, bytes = 0;
  std::uint64_t lost = 0;           // came in and did not leave again: cable, fault, not an EtherCAT frame
  std::uint64_t dropped = 0;        // by the kernel, because we were too slow
  Nanoseconds longest_service = 0;  // executing one frame, without the way through the kernel
  std::vector<std::uint32_t> service = std::vector<std::uint32_t>(kBuckets);

  /// Service time that `share` (0..1) of the frames did not exceed; 0 without frames.
  [[nodiscard]] Nanoseconds service_quantile(double share) const;
};

/// Lets a simulated segment answer on a network adapter in real time: what arrives is executed at its
/// arrival time and leaves again when it would have come back through the segment's wires. Between frames
/// the devices' applications, clocks and watchdogs go on. One thread.
class BusResponder {
 public:
  struct Options {
    /// After a frame the thread looks for the next one this long before it sleeps: waking up costs more than
    /// executing. Bursts and scans profit; where the next frame mostly comes later, as in a bus cycle, it does not
    /// look, but is awake when a master that sends in cycles sends its next (a tenth of the cycle at most). A reply
    /// that is due within 60 us is waited for awake, too. 0 always sleeps.
    Nanoseconds spin = 100 * kMicrosecond;
  };
  /// All three outlive the responder; `clock` is the one on which bus and port run.
  BusResponder(sim::SimBus& bus, RawPort& port, Clock& clock, Options options)
      : bus_(bus), port_(port), clock_(clock), options_(options) {}

  /// Serves until `end` (absolute; 0: for ever) or until `stop`, which a signal handler may set. kLinkIo.
  Status serve(Nanoseconds end, const std::atomic<bool>& stop);
  [[nodiscard]] const ResponderCounters& counters();

 private:
  struct Reply {
    Nanoseconds due = 0;
    std::size_t length = 0;
    std::array<std::uint8_t, 1518> bytes{};
  };

  Result<bool> take_frame();
  void learn(Nanoseconds now);
  Status send_due();
  /// It is worth the processor to look for a frame now.
  [[nodiscard]] bool looks(Nanoseconds now) const;
  /// How long nothing happens at most.
  [[nodiscard]] Nanoseconds idle_time(Nanoseconds now, Nanoseconds end) const;

  sim::SimBus& bus_;
  RawPort& port_;
  Clock& clock_;
  Options options_;
  ResponderCounters counters_;
  std::deque<Reply> replies_;  // on their way through the segment, in order
  Nanoseconds bus_time_ = 0;   // the segment has been executed up to here
  Nanoseconds wire_free_ = 0;  // end of the frame in front
  Nanoseconds last_frame_ = 0;
  ArrivalForecast forecast_;
  double luck_ = 1;  // share of the frames of late that came while we would have looked
};

}  // namespace syncline
