// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

/// Writes Ethernet frames with nanosecond stamps into a pcapng file (section header, one interface,
/// enhanced packet blocks). The file appears under its name when finish() is called; until then it
/// is `path`.part, so a cut-off capture is recognisable and still readable.
class PcapngWriter {
 public:
  enum class Direction : std::uint8_t { kReceived = 1, kSent = 2 };  // epb_flags, bits 1:0

  [[nodiscard]] static Result<PcapngWriter> create(const std::string& path);
  /// `time` counts from the DC epoch; the file holds Unix time.
  void write(std::span<const std::uint8_t> frame, Nanoseconds time, Direction direction);
  Status finish();

 private:
  PcapngWriter(std::string path, std::ofstream out);
  std::string path_;
  std::ofstream out_;
};

}  // namespace syncline
