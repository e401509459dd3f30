// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "support/random.h"

/// Ways to damage a good input so that most of it stays what it is: what is behind the first check is reached.
namespace syncline::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// A few bytes changed, cut off or doubled.
[[nodiscard]] Bytes damage_bytes(const Bytes& good, Random& random);
/// damage_xml() on most inputs, damage_bytes() on the others.
[[nodiscard]] Bytes damage_xml_bytes(const Bytes& good, Random& random);
/// A text of lines: a value behind "=" or between separators replaced, lines taken out, doubled or moved.
[[nodiscard]] Bytes damage_lines(const Bytes& good, Random& random);
/// A frame whose lengths still fit: commands, addresses, data and working counters of its datagrams changed, datagrams
/// added, doubled or taken out.
[[nodiscard]] Bytes damage_frame(const Bytes& good, Random& random);
/// A database whose header is mostly left alone.
[[nodiscard]] Bytes damage_database(const Bytes& good, Random& random);

[[nodiscard]] std::size_t pick(Random& random, std::size_t count);  // 0 of none
/// Numbers at the ends of ranges, and what is no number.
[[nodiscard]] std::string_view nasty_value(Random& random);

}  // namespace syncline::fuzz
