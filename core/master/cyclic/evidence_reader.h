// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "master/exchange/frame_exchange.h"
#include "master/exchange/slave_batch.h"
#include "protocol/registers.h"
#include "support/counter_total.h"

namespace syncline {

class EventTeller;
struct NetworkConfig;
struct Snapshot;

/// Reads what the slaves' ESCs counted, while the bus runs: the port error counters, the watchdog counters and the
/// speed counter difference of one slave after the other, one datagram in each cycle that is left for
/// it (see ProcessDataWatch), behind everything else that wants the acyclic frame. Fills SlaveEvidence and tells new
/// errors by kPortErrors and kWatchdog. A counter that has come to its end stop would count no more: it is cleared,
/// with those that an ESC clears along with it, and nothing else is. Allocates nothing; the cyclic thread.
class EvidenceReader final : public SlaveWork {
 public:
  EvidenceReader(const NetworkConfig& config, Snapshot& snapshot, EventTeller& teller);
  EvidenceReader(const EvidenceReader&) = delete;
  EvidenceReader& operator=(const EvidenceReader&) = delete;

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds time) override;
  [[nodiscard]] bool over() const override { return false; }
  [[nodiscard]] Status result() const override { return {}; }

 private:
  enum class What : std::uint8_t { kPorts, kWatchdogs, kEndStop, kDlStatus, kSpeedCounter };
  static constexpr std::uint8_t kKinds = 5;
  static constexpr CounterTotal kByte{8, CounterTotal::End::kSaturates};

  /// By differences, because nobody else's reading shall be disturbed by clearing what still counts.
  struct Totals {
    std::array<CounterTotal, 20> ports;  // 0x0300 to 0x0313
    std::array<CounterTotal, 2> watchdogs{kByte, kByte};
    Totals() : ports(filled(std::make_index_sequence<20>{})) {}
    template <std::size_t... I>
    static std::array<CounterTotal, sizeof...(I)> filled(std::index_sequence<I...>) {
      return {((void)I, kByte)...};
    }
  };

  void move_on();
  [[nodiscard]] bool worth_asking();
  struct Place;
  [[nodiscard]] std::span<CounterTotal> counters(const Place& place);
  /// Counters that are cleared together, one of which counts no more; null: there are none.
  [[nodiscard]] const Place* at_end_stop();
  void take_ports(Nanoseconds time);
  void tell_port(std::size_t port, std::uint32_t damaged, std::uint32_t lost_links, Nanoseconds time);
  void take_watchdogs(Nanoseconds time);
  void take_dl_status();
  void take_speed_counter(Nanoseconds time);

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  EventTeller& teller_;
  std::vector<Totals> totals_;
  std::size_t slave_ = 0;
  What what_ = What::kPorts;
  std::array<std::uint8_t, 20> bytes_{};
  Datagram datagram_;
};

}  // namespace syncline
