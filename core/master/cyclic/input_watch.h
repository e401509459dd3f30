// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "master/exchange/frame_exchange.h"
#include "support/random.h"

namespace syncline {

class RunState;
struct SlaveConfig;

/// Whether slaves renew their inputs. The status of a buffered SyncManager names the buffer that was written last
/// (0x0805 + 8 n, bits 5:4; ESC data sheet II, 2.8): behind two readings of the inputs it is the same only when the
/// firmware has written none in between, because it never writes into the buffer that is being read. One byte of one
/// slave a cycle, in two cycles one behind the other, slave after slave.
///
/// Many devices renew their inputs seldom, and rightly so: only one that did it in every cycle for its first readings
/// in OP is held to it. Then kFirmwareSlow tells when it has stopped to, and when it does it again. Firmware that hangs
/// is the PDI watchdog's. Allocates nothing; the cyclic thread.
class InputWatch {
 public:
  explicit InputWatch(RunState& run);
  InputWatch(const InputWatch&) = delete;
  InputWatch& operator=(const InputWatch&) = delete;

  /// Whether it took this cycle for itself: it leaves at least one in three to others.
  bool add_to(PendingFrame& frame);
  /// Once a cycle, behind its frames. `read`: they have come back, so that the inputs were read.
  void take(Nanoseconds send_time, bool read);

 private:
  struct Slave {
    std::uint16_t position = 0, address = 0;  // of the SyncManager's status
    std::uint32_t stale = 0;                  // the last readings, the newest in bit 0: nothing new
    std::uint8_t readings = 0;                // as many as count
    bool regular = false;                     // renewed them in every cycle
    std::optional<Nanoseconds> stale_since;
    std::uint32_t watchdog_before = 0;  // expirations of the PDI watchdog while it renewed them
    bool told = false;
  };

  void next();
  [[nodiscard]] bool worth_reading(const Slave& slave) const;
  void note(Slave& slave, bool stale, Nanoseconds time);
  void judge(Slave& slave, Nanoseconds time);

  RunState& run_;
  std::vector<Slave> slaves_;
  std::size_t current_ = 0;
  std::optional<std::uint8_t> first_;  // buffer in the first of the two cycles
  std::array<std::uint8_t, 1> byte_{};
  Datagram datagram_;
  bool asked_ = false;
  std::uint8_t pause_ = 0;
  Random shuffle_{1};
  Nanoseconds last_send_ = 0;
};

/// The first SyncManager whose buffers the master reads each cycle; nothing when the configuration sets none.
[[nodiscard]] std::optional<std::uint8_t> input_sync_manager(const SlaveConfig& slave);

}  // namespace syncline
