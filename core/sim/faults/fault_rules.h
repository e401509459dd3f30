// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "config/sim_config.h"

namespace syncline::sim {

/// What a [[fault]] of a kind has in a scenario, beside kind and at_ms.
struct FaultRule {
  /// Whom it is about.
  enum class Subject : std::uint8_t {
    kSlave,  // one slave
    kAny,    // one slave or, without it, all of them, the line or the host
    kHost,   // the host or the segment as a whole
  };
  enum Key : std::uint16_t {
    kUntil = 1,
    kCount = 2,
    kPort = 4,
    kValue = 8,
    kState = 16,
    kCode = 32,
    kProbability = 64,
    kPpm = 128,
    kPeriod = 256
  };
  /// What the slave must have.
  enum Needs : std::uint8_t { kNothing, kFirmware, kMailbox, kClock, kSystemTime };

  std::string_view name;
  FaultKind kind;
  Subject subject;
  std::uint16_t keys;      // it may have
  std::uint16_t required;  // of them
  Needs needs = kNothing;
  std::int64_t least = INT64_MIN, most = INT64_MAX;  // of value_ns
};

[[nodiscard]] std::span<const FaultRule> fault_rules();
/// Kinds of the scenario's faults that only a simulated host has, once each, by their names: who serves the segment to
/// a master with a host of its own passes them over.
[[nodiscard]] std::vector<std::string_view> host_faults(const SimConfig& config);
/// Its TOML name.
[[nodiscard]] std::string_view name_of(FaultRule::Key key);

}  // namespace syncline::sim
