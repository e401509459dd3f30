// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace syncline::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// A parser of foreign bytes with good inputs to start from. `run` aborts when a promise is broken; what it reads is
/// for the sanitizers to watch.
struct Target {
  const char* name;
  void (*run)(std::span<const std::uint8_t> bytes);
  std::vector<Bytes> (*corpus)();
  bool is_xml = false;
};

/// frame, sii, mailbox, pcap, esi, eni, project.
[[nodiscard]] std::span<const Target> targets();
/// nullptr when there is none of this name.
[[nodiscard]] const Target* find_target(std::string_view name);

}  // namespace syncline::fuzz
