// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/esc_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace syncline::sim {
namespace {

constexpr std::array kTypes{
    EscType{"et1100", 0x11, {320, 280}},  EscType{"et1200", 0x12, {150, 130}},  EscType{"ip-core", 0x04, {335, 315}},
    EscType{"lan9252", 0xC0, {390, 330}}, EscType{"xmc4800", 0x98, {340, 300}},
};

}  // namespace

const EscType* find_esc_type(std::string_view name) {
  const auto found = std::ranges::find(kTypes, name, &EscType::name);
  return found == kTypes.end() ? nullptr : &*found;
}

std::string esc_type_names() {
  std::string names;
  for (const auto& type : kTypes) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", type.name);
  return names;
}

}  // namespace syncline::sim
