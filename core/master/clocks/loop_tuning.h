// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "master/exchange/frame_exchange.h"

namespace syncline {

struct NetworkConfig;
struct Snapshot;

/// What the time control loop of a clock is told when the clock begins to lead (ESC data sheet I, 9.1.4), one frame
/// more a step. Each step is repeated until it is answered, also by a slave that was away meanwhile. Cyclic thread;
/// allocates nothing once it was made.
class LoopTuning final : private SendStamp {
 public:
  LoopTuning(const NetworkConfig& config, const Snapshot& snapshot);
  LoopTuning(const LoopTuning&) = delete;
  LoopTuning& operator=(const LoopTuning&) = delete;

  /// The slave's clock averages 2^depth differences from now on (0x0934); depth 0 to 15.
  void set_depth(std::uint16_t position, std::uint8_t depth);
  /// Whoever is told nothing more runs on with the last message, however wrong that was. So the clock is told a time
  /// once more that its average hardly takes, its own; what remains is the rate that it has learned. The depth of the
  /// average is afterwards what it was, or `depth`.
  void settle(std::uint16_t position, std::optional<std::uint8_t> depth = {});
  /// Somebody who is there is to be told something.
  [[nodiscard]] bool pending() const;
  /// The next step. Waits for the answer until `deadline`. Errors of the link.
  Status step(FrameExchange& exchange, Nanoseconds deadline);

 private:
  enum class Step : std::uint8_t { kAskDepth, kHold, kTell, kSetDepth };
  struct Job {
    std::uint16_t position = 0;
    Step step = Step::kAskDepth;
    std::uint8_t depth = 0;  // at the end; known behind kAskDepth
    int tries = 0;           // of this step
    Nanoseconds ahead = 0;   // its clock, of the host's
  };
  [[nodiscard]] bool is_there(const Job& job) const;
  Job& job_of(std::uint16_t position);
  void prepare(const Job& job);
  [[nodiscard]] bool take(Job& job);
  void stamp(Nanoseconds send_time) override;

  const NetworkConfig& config_;
  const Snapshot& snapshot_;
  std::vector<Job> jobs_;
  std::array<std::uint8_t, 1> depth_{};
  std::array<std::uint8_t, 4> time_{};
  Datagram depth_access_, time_access_;
  PendingFrame frame_;
  bool tells_ = false;  // the frame, the clock its time
  Nanoseconds stamped_at_ = 0, ahead_ = 0;
};

}  // namespace syncline
