// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "master/exchange/frame_exchange.h"

namespace syncline {

class Bus;

/// The drift burst: many frames that hand the reference clock's time to all others before there is a bus cycle, so
/// that the time control loops learn their quartzes. The frames of a cycle travel one behind the other.
class DcBurst : private SendStamp {
 public:
  struct Plan {
    std::uint32_t address = 0;  // of the reference clock's 0x0910
    bool by_place = true;       // ARMW and APWR, else FRMW and FPWR
    bool steer = false;         // bus shift: the reference clock is told the host's time
    bool wide = false;          // 8 bytes of system time instead of 4
    std::uint32_t total = 10'000, bulk = 12;
    bool ends_early = true;
    Nanoseconds cycle = kMillisecond;
  };
  struct Outcome {
    std::uint32_t frames = 0;
    /// A host time and the reference clock's system time then.
    Nanoseconds host_time = 0, reference_time = 0;
    bool answered = false;  // the reference clock showed its time
    bool settled = false;   // all clocks were near each other at the end
  };

  DcBurst(Bus& bus, const Plan& plan);
  DcBurst(const DcBurst&) = delete;
  DcBurst& operator=(const DcBurst&) = delete;

  /// Ends when the clocks have settled, else behind twice the planned frames; at once behind `total` frames when it is
  /// not to end early. kCancelled, link errors.
  Result<Outcome> run();

 private:
  struct Slot {
    std::array<std::uint8_t, 8> time{}, steer{};
    std::array<std::uint8_t, 4> deviation{};
    Datagram read, steer_write, window;
    PendingFrame frame;
    Nanoseconds on_wire = 0;  // when its first byte leaves
  };

  Status exchange_bulk(std::uint32_t frames);
  void fill(Slot& slot, bool with_window);
  void take(const Slot& slot);
  [[nodiscard]] bool settled(std::uint32_t minimum);
  void stamp(Nanoseconds send_time) override;

  Bus& bus_;
  Plan plan_;
  std::vector<Slot> slots_;
  Slot* sending_ = nullptr;
  Nanoseconds wire_free_ = 0;
  std::optional<Nanoseconds> anchor_;  // reference minus host at the first frame
  std::optional<std::uint32_t> deviation_;
  int settled_in_a_row_ = 0;
  Outcome outcome_;
};

}  // namespace syncline
