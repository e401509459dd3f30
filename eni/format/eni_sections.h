// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace syncline::eni {

enum class EniPart : std::uint8_t { kMaster, kSlave, kCyclic, kProcessImage, kOther };

/// The lines of one element below Config.
struct EniSection {
  EniPart part = EniPart::kOther;
  int slave = -1;                    // position of a kSlave
  std::size_t first = 0, count = 0;  // lines, from 0
  bool operator==(const EniSection&) const = default;
};

[[nodiscard]] std::vector<std::string_view> lines_of(std::string_view text);

/// Of an ENI as write_eni() sets it: an element a line.
[[nodiscard]] std::vector<EniSection> sections_of(std::span<const std::string_view> lines);

}  // namespace syncline::eni
