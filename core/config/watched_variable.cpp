// SPDX-License-Identifier: Apache-2.0
#include "config/watched_variable.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>

#include "config/image_owners.h"
#include "config/network_config.h"
#include "protocol/coe_data_type.h"
#include "reasons/because.h"

namespace syncline {
namespace {

constexpr std::size_t kMostNamed = 5;  // of several that a text could mean

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_word(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

/// The last part of a name: "Position actual value" of "Servo.Inputs.Position actual value".
bool ends_with_part(std::string_view name, std::string_view part) {
  if (part.empty() || name.size() < part.size()) return false;
  const auto rest = name.size() - part.size();
  return same_word(name.substr(rest), part) && (rest == 0 || name[rest - 1] == '.');
}

bool is_slave(const NetworkConfig& config, int slave, std::string_view text) {
  if (slave < 0) return false;
  int number = -1;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed == std::errc() && end == text.data() + text.size()) return number == slave;
  return same_word(config.slaves[static_cast<std::size_t>(slave)].name, text);
}

/// Slaves have dots in their names, too: each is tried as the end of the slave's.
bool is_meant(const NetworkConfig& config, const WatchedVariable& variable, std::string_view text) {
  for (auto dot = text.find('.'); dot != std::string_view::npos; dot = text.find('.', dot + 1)) {
    if (is_slave(config, variable.slave, text.substr(0, dot)) && ends_with_part(variable.name, text.substr(dot + 1)))
      return true;
  }
  return false;
}

std::optional<coe::ValueKind> kind_of(const WatchedVariable& variable) {
  const auto* type = coe::find_data_type(variable.data_type);
  return type != nullptr && type->bits == variable.bit_size ? std::optional(type->kind) : std::nullopt;
}

}  // namespace

std::vector<WatchedVariable> watchable_variables(const NetworkConfig& config) {
  const ImageOwners owners(config);
  std::vector<WatchedVariable> result;
  const auto add = [&](const std::vector<Variable>& variables, bool output) {
    for (const auto& variable : variables) {
      if (variable.bit_size < 1 || variable.bit_size > kMostWatchedBits) continue;
      const auto owner = output ? owners.of_output(variable.bit_offset) : owners.of_input(variable.bit_offset);
      result.push_back({variable.name, variable.data_type, output, variable.bit_offset, variable.bit_size,
                        owner ? static_cast<int>(*owner) : -1});
    }
  };
  add(config.image.inputs, false);
  add(config.image.outputs, true);
  return result;
}

Result<WatchedVariable> find_watchable(const NetworkConfig& config, std::string_view text) {
  const auto all = watchable_variables(config);
  if (const auto named = std::ranges::find(all, text, &WatchedVariable::name); named != all.end()) return *named;
  std::vector<const WatchedVariable*> meant;
  for (const auto& variable : all) {
    if (same_word(variable.name, text) || is_meant(config, variable, text)) meant.push_back(&variable);
  }
  if (meant.size() == 1) return *meant.front();
  if (meant.empty()) {
    return fail(ErrorCode::kBadValue, std::string(text),
                because("the process image has no such variable of 1 to 64 bits: use its name, or SLAVE.ENTRY with the "
                        "slave's position or name, e.g. \"3.Position actual value\""));
  }
  std::string names;
  for (std::size_t i = 0; i < std::min(meant.size(), kMostNamed); ++i)
    names += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", meant[i]->name);
  if (meant.size() > kMostNamed) names += fmt::format(" and {} more", meant.size() - kMostNamed);
  return fail(ErrorCode::kBadValue, std::string(text), because("it could be any of {names}", names));
}

WatchedNumber watched_number(const WatchedVariable& variable, std::uint64_t bits) {
  switch (kind_of(variable).value_or(coe::ValueKind::kUnsigned)) {
    case coe::ValueKind::kSigned: {
      const auto unused = kMostWatchedBits - variable.bit_size;
      return std::bit_cast<std::int64_t>(bits << unused) >> unused;
    }
    case coe::ValueKind::kReal:
      if (variable.bit_size == 32) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
      return std::bit_cast<double>(bits);
    case coe::ValueKind::kUnsigned:
    case coe::ValueKind::kText:
      break;
  }
  return bits;
}

double watched_value(const WatchedVariable& variable, std::uint64_t bits) {
  return std::visit([](auto value) { return static_cast<double>(value); }, watched_number(variable, bits));
}

}  // namespace syncline
