// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "support/output_file.h"
#include "support/result.h"
#include "support/types.h"

namespace syncline {

/// Writes Ethernet frames with nanosecond stamps into a pcapng file (section header, one interface,
/// enhanced packet blocks). The file appears under its name when finish() is called, see OutputFile.
class PcapngWriter {
 public:
  enum class Direction : std::uint8_t { kReceived = 1, kSent = 2 };  // epb_flags, bits 1:0

  [[nodiscard]] static Result<PcapngWriter> create(const std::string& path);
  /// `time` counts from the DC epoch; the file holds Unix time. kFileNotWritable, also of what was written before.
  Status write(std::span<const std::uint8_t> frame, Nanoseconds time, Direction direction);
  Status finish() { return out_.finish(); }

 private:
  explicit PcapngWriter(OutputFile out);
  Status write_block();

  OutputFile out_;
  std::vector<std::uint8_t> block_;
};

}  // namespace syncline
