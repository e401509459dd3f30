// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "channels/event.h"
#include "config/sim_config.h"
#include "findings/finding.h"
#include "findings/run_codes.h"
#include "trace/signals.h"

namespace syncline::bench {

/// A kind of fault, how it is thrown in, and by what it must be told.
struct SoakFaultKind {
  const char* name;
  FaultKind kind{};
  std::vector<int> victims;               // of the line's six; empty: the line or the host, or
  bool of_reference = false;              // whoever leads,
  bool of_clock = false;                  // who follows it,
  bool with_sync0 = false;                // who has SYNC signals,
  bool by_itself = false;                 // who has none, and shows what it does
  Nanoseconds shortest = 0, longest = 0;  // how long it lasts; 0: a moment
  Nanoseconds least = 0, most = 0;        // value,
  bool in_cycles = false;                 // at a cycle of 1 ms, in proportion to it at others
  bool either_sign = false;
  std::uint32_t most_count = 1;
  double ppm = 0;
  double probability = 0;
  std::uint8_t port = 0;
  AlState state = AlState::kNone;
  std::uint16_t code = 0;
  Nanoseconds period = kMillisecond;
  bool while_down = false;                   // before the machine is brought up, until it is down again
  bool switched_on_anew = false;             // its victim, just before
  bool harmless = false;                     // nothing must be told
  bool of_cycles = false;                    // lasts for so many as `count` says; one in four is what comes back
  std::vector<EventKind> events{};           // any of them tells it,
  std::vector<std::string_view> findings{};  // or any of these, of the victim where it names a slave
  std::vector<std::string_view> also{};      // what it brings with it, of anybody
  std::vector<Signal> shows{};               // any of these shows it in the plots, of the victim or of the bus,
  std::vector<Signal> gaps{};  // or that any of these is not known for a while, of the victim; neither: events alone
  std::vector<Signal> may_show{};  // what it brings with it there, of anybody
};

/// Positions as in soak_machine(): 0 terminal, 1 and 2 servos, 3 drive, 4 gateway, 5 terminal.
[[nodiscard]] std::span<const SoakFaultKind> soak_fault_kinds();

}  // namespace syncline::bench
