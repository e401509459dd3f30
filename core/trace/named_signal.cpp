// SPDX-License-Identifier: Apache-2.0
#include "trace/named_signal.h"

#include <algorithm>
#include <charconv>

#include "trace/sample_store.h"

namespace syncline {

std::optional<NamedSignal> named_signal(std::string_view text, const SampleStore& store) {
  const auto& variables = store.watched().variables();
  const auto variable = std::ranges::find(variables, text, [](const auto& one) { return std::string_view(one.name); });
  if (variable != variables.end())
    return NamedSignal{Signal::kVariable, static_cast<std::size_t>(variable - variables.begin())};
  using Scope = SignalInfo::Scope;
  const auto at = text.find('@');
  const bool of_slave = at != std::string_view::npos;
  const auto* row = find_signal(text.substr(0, at), of_slave ? Scope::kSlave : Scope::kBus);
  if (row == nullptr || row->form == SignalInfo::Form::kCell) return std::nullopt;
  NamedSignal named{row->id, 0};
  if (!of_slave) return named;
  const auto number = text.substr(at + 1);
  const auto* const end = number.data() + number.size();
  const auto [rest, error] = std::from_chars(number.data(), end, named.slave);
  if (error != std::errc{} || rest != end || named.slave >= store.slave_count()) return std::nullopt;
  return named;
}

}  // namespace syncline
