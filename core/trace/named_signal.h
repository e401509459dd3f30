// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "trace/signals.h"

namespace syncline {

class SampleStore;

/// A signal of the bus, or of one slave.
struct NamedSignal {
  Signal signal = Signal::kCycle;
  std::size_t slave = 0;  // position; 0 of the bus, and with SignalInfo::Scope::kVariable the variable's number
  bool operator==(const NamedSignal&) const = default;
};

/// "dcm_error_ns" of the bus, "deviation_ns@1" of the slave at that position, or the name of a variable that was
/// watched. Nothing where there is no such signal, or none that is drawn (SignalInfo::Form::kCell).
[[nodiscard]] std::optional<NamedSignal> named_signal(std::string_view text, const SampleStore& store);

}  // namespace syncline
