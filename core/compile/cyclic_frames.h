// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compile/compile.h"
#include "compile/process_image.h"

namespace syncline::compiler {

struct CyclicOptions {
  EniDialect dialect = EniDialect::kEcEngineer;
  std::uint16_t slave_count = 0;
  /// Auto-increment address of the reference clock; empty: no DC commands.
  std::optional<std::uint16_t> reference_clock;
  bool bus_shift = false;
  bool sync_window = false;
  bool system_time_64bit = false;
  bool latch_receive_times = false;  // in every cycle, for the continuous compensation of propagation delays
  std::uint16_t mailbox_state_count = 0;
  std::uint32_t logical_base = kEcEngineerLogicalBase;  // ImageOptions::logical_base()
};

/// Room that the process data of one datagram may take, so that it fits beside the other commands in the first frame.
[[nodiscard]] std::uint16_t max_process_data_length(const CyclicOptions& options);

struct CyclicLayout {
  std::vector<CyclicFrame> frames;  // of the base task
  /// Of the slower tasks, process data only; index + 1 is LogicalDatagram::task. Behind the last that has data it ends.
  std::vector<std::vector<CyclicFrame>> slower;
  std::vector<std::uint32_t> data_offsets;  // byte of ImageLayout::datagrams[i] in the process image
  std::uint32_t image_bytes = 0;            // same for inputs and outputs
  std::uint32_t command_data_offset = 0;    // ProcessImage::command_data_offset
};

/// The commands sent every cycle with their places in the process image.
/// - EC-Engineer: BRD AL status, NOP, ARMW, [APWR bus shift], [LRD mailbox states], process data, [BRD 0x092C]; offsets
///   are those of the data, process data first, everything else behind it.
/// - TwinCAT: NOP, ARMW, [APWR], [LRD], process data, [BRD 0x092C], BRD AL status; offsets are those of the datagram
///   headers in the frame, the data 10 bytes behind.
/// A frame that would exceed Ethernet's maximum is split between commands.
[[nodiscard]] CyclicLayout cyclic_frames(const ImageLayout& image, const CyclicOptions& options);

}  // namespace syncline::compiler
