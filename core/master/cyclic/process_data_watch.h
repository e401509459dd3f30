// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "master/exchange/frame_exchange.h"
#include "support/random.h"

namespace syncline {

class EventTeller;
struct NetworkConfig;
struct Snapshot;

/// Whether slaves renew their inputs, and those that have none take their outputs. The status of a buffered SyncManager
/// names the buffer that was written last (0x0805 + 8 n, bits 5:4; ESC data sheet II, 2.8): behind two readings of the
/// inputs it is the same only when the firmware has written none in between, because it never writes into the buffer
/// that is being read. That outputs were written stands in the AL event request until the firmware reads them (0x0220,
/// bit 8 + n; data sheet II, 2.12): a datagram behind those that bring the next ones still shows what became of the
/// ones before, because an ESC raises the event at the end of the frame. One byte of one slave a cycle, in two cycles
/// one behind the other (of a slave whose SYNC0 comes every nth cycle in two that are so far apart), slave after slave;
/// behind its process data, in the same frame. In another one it would see the outputs that came just in front of it,
/// and inputs may have been renewed once before they were read and once behind, which ends where it began.
///
/// A slave without SYNC0 may run by itself, with a cycle as long as the master's. Where its moment slides through that
/// of the frames, those that come early and late by turns find nothing new in up to a quarter of the cycles, and twice
/// in as many others: nothing wrong with it. That takes two frames that are less than a cycle apart, so that only those
/// count that are further apart than usual.
///
/// Many devices do either seldom, and rightly so: only one that did it in every cycle for its first readings in OP is
/// held to it. Then StaleProcessData tells when it has stopped to, and when it does it again. One reading that says so
/// is looked into at once: the next ones are of the same slave, once in each turn of all, so that it does not take
/// longer on a machine of many. Firmware that hangs is the PDI watchdog's. Allocates nothing; the cyclic thread.
class ProcessDataWatch {
 public:
  ProcessDataWatch(const NetworkConfig& config, const Snapshot& snapshot, EventTeller& teller);
  ProcessDataWatch(const ProcessDataWatch&) = delete;
  ProcessDataWatch& operator=(const ProcessDataWatch&) = delete;

  /// Behind whose outputs, or whose inputs, the datagram is to go.
  struct Wish {
    Datagram* datagram = nullptr;
    std::size_t slave = 0;
    bool outputs = false;
  };
  /// What it takes this cycle for: it leaves at least one in three to others.
  [[nodiscard]] std::optional<Wish> next();
  /// Once a cycle, behind its frames. `regular`: none were left out before it.
  void take(Nanoseconds send_time, bool regular);

 private:
  struct Slave {
    std::uint16_t position = 0, address = 0;  // of the byte
    std::uint8_t event = 0;  // its bit for outputs that are left; 0: the SyncManager's status of inputs
    bool has_sync0 = false;
    std::uint8_t cycles = 1;    // in which it does its work once: from one SYNC0 to the next
    std::uint32_t stale = 0;    // the last readings, the newest in bit 0: nothing new, or left
    std::uint8_t readings = 0;  // as many as count
    bool regular = false;       // renewed or took them in every cycle
    std::optional<Nanoseconds> stale_since;
    std::uint32_t watchdog_before = 0;  // expirations of the PDI watchdog while it renewed them
    bool told = false;
  };

  /// How far frames are apart from those of the cycle before, ns: usually, and by how much that varies.
  struct Spacing {
    double usual = 0, varies = 0;
    void note(Nanoseconds between);
    [[nodiscard]] bool exceeded_by(Nanoseconds between) const;
  };

  void add_slave(std::size_t position);
  void try_again();
  void go_on();
  /// Whether what was read tells of what was before it.
  [[nodiscard]] bool counts(const Slave& slave, bool regular) const;
  /// Whether whoever does it once a cycle has done so between two frames.
  [[nodiscard]] bool far_enough(const Slave& slave, Nanoseconds between) const;
  [[nodiscard]] bool worth_reading(const Slave& slave) const;
  void note(Slave& slave, bool stale, Nanoseconds time);
  void judge(Slave& slave, Nanoseconds time);

  const NetworkConfig& config_;
  const Snapshot& snapshot_;
  EventTeller& teller_;
  std::vector<Slave> slaves_;
  std::size_t current_ = 0;
  std::optional<std::uint8_t> first_;  // byte in the first of the two cycles
  std::uint8_t tries_ = 0;             // of the current one, that came to nothing
  std::array<std::uint8_t, 1> byte_{};
  Datagram datagram_;
  bool asked_ = false;
  std::uint8_t pause_ = 0;
  std::uint8_t looked_into_ = 0;       // readings of the current one that are still to come
  bool may_look_into_another_ = true;  // in this turn
  Random shuffle_{1};
  Nanoseconds last_send_ = 0;
  Spacing spacing_;
};

}  // namespace syncline
