// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

/// When process data are exchanged and where they lie.
namespace syncline {

/// A cyclic task beside the base task: its frames are sent in every `multiple`-th cycle.
struct TaskSettings {
  std::string name;
  std::uint32_t multiple = 2;  // 1..1000 bus cycles
  bool operator==(const TaskSettings&) const = default;
};

struct ProcessImageSettings {
  /// Where the process data begin in the logical address space. Empty: as the dialect's tool.
  std::optional<std::uint32_t> logical_start;
  std::uint8_t alignment = 1;  // each slave's data begin at a multiple of 1, 2, 4 or 8 bytes
  /// Digital terminals share bytes where the dialect packs them; off gives each whole bytes.
  bool bit_packing = true;
  bool operator==(const ProcessImageSettings&) const = default;
};

}  // namespace syncline
