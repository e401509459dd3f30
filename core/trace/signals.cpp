// SPDX-License-Identifier: Apache-2.0
#include "trace/signals.h"

#include <algorithm>

#include "trace/bus_signals.h"
#include "trace/signal_table.h"
#include "trace/slave_signals.h"

namespace syncline {
namespace {

SignalTable make_table() {
  SignalTable table{};
  put_bus_signals(table);
  put_slave_signals(table);
  return table;
}

}  // namespace

std::span<const SignalInfo> signals() {
  static const auto kTable = make_table();
  return kTable;
}

const SignalInfo& info(Signal signal) { return signals()[static_cast<std::size_t>(signal)]; }

const SignalInfo* find_signal(std::string_view key, SignalInfo::Scope scope) {
  const auto found = std::ranges::find_if(
      signals(), [&](const SignalInfo& signal) { return signal.key == key && signal.scope == scope; });
  return found == signals().end() ? nullptr : &*found;
}

double as_double(const SignalNumber& number) {
  return std::visit([](auto value) { return static_cast<double>(value); }, number);
}

}  // namespace syncline
