// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "protocol/registers.h"
#include "sim/registers/esc_memory.h"
#include "sim/registers/short_copy.h"

namespace syncline::sim {

/// The shadow of an ESC's registers: what the frame that passes has written to them, in its order. It becomes effective
/// at the end of the frame, or not at all (ESC data sheet I, 5.3).
class FrameWrites {
 public:
  struct Write {
    std::uint16_t address;
    std::uint16_t length;
  };

  void add(std::uint16_t address, std::span<const std::uint8_t> data) {
    writes_.push_back({address, static_cast<std::uint16_t>(data.size())});
    short_copy(data, std::span(bytes_).subspan(size_));
    size_ += data.size();
  }
  [[nodiscard]] bool empty() const { return writes_.empty(); }
  /// The system time comes in every cycle, and changes nothing that plans or waiting depend on.
  [[nodiscard]] bool only_system_time() const {
    return std::ranges::all_of(writes_, [](const Write& write) {
      return write.address >= reg::kSystemTime && write.address + write.length <= reg::kSystemTime + EscMemory::kWord;
    });
  }
  /// `visit(write, bytes)`, in the order of the frame.
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::size_t position = 0;
    for (const auto& write : writes_) {
      visit(write, std::span(bytes_).subspan(position, write.length));
      position += write.length;
    }
  }
  void clear() {
    writes_.clear();
    size_ = 0;
  }

 private:
  static constexpr std::size_t kMaxFrameBody = 0x0800;  // the length in the EtherCAT header has 11 bits

  std::vector<Write> writes_;
  std::array<std::uint8_t, kMaxFrameBody> bytes_{};  // of writes_, in order
  std::size_t size_ = 0;
};

}  // namespace syncline::sim
