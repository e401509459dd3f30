// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/al_state.h"
#include "protocol/command.h"
#include "support/types.h"

/// What is sent in each cycle (ETG.2100, Cyclic).
namespace syncline {

/// Slave-to-slave copy: bits of this command's inputs that the master puts into its outputs, offsets in the image.
struct CopyInfo {
  std::uint32_t source_bit = 0;
  std::uint32_t destination_bit = 0;
  std::uint32_t bit_size = 0;
  bool operator==(const CopyInfo&) const = default;
};

struct CyclicCmd {
  std::vector<AlState> states;
  std::string comment;
  Command command = Command::kNop;
  std::uint16_t adp = 0;
  std::uint16_t ado = 0;
  std::uint32_t logical_address = 0;
  std::vector<std::uint8_t> data;
  std::optional<std::uint16_t> data_length;
  std::optional<std::uint16_t> expected_wkc;
  std::uint32_t input_offset = 0;
  std::uint32_t output_offset = 0;
  std::vector<CopyInfo> copy_infos;
  bool operator==(const CyclicCmd&) const = default;
  [[nodiscard]] std::uint16_t length() const {
    return data_length ? *data_length : static_cast<std::uint16_t>(data.size());
  }
};

struct CyclicFrame {
  std::vector<CyclicCmd> commands;
  std::string comment{};
  bool operator==(const CyclicFrame&) const = default;
};

struct CyclicTask {
  Nanoseconds cycle_time = kMillisecond;
  std::vector<CyclicFrame> frames;
  std::string comment{};
  std::optional<std::int32_t> priority{};
  std::string task_id{};
  bool cycle_time_given = true;  // false: the ENI says none, cycle_time is the best guess
  bool operator==(const CyclicTask&) const = default;
};

}  // namespace syncline
