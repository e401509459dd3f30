// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

struct CapturedFrame {
  Nanoseconds time = 0;             // since the DC epoch
  std::vector<std::uint8_t> bytes;  // Ethernet frame without FCS, as far as it was captured
  bool truncated = false;           // the capture holds less than there was on the wire
  /// Of a probe that stamps frames itself (EtherCAT Switch Link, ET2000), ns by its own clock; its header or trailer is
  /// no part of `bytes`.
  std::optional<Nanoseconds> stamp;
};

/// Reads pcap and pcapng captures of Ethernet frames, one after the other.
class PcapReader {
 public:
  /// kFileNotFound, kFileNotReadable, kNotThatKindOfFile for what is no capture or none of Ethernet.
  [[nodiscard]] static Result<PcapReader> open(const std::string& path);
  /// A capture in memory; `name` stands for the file in errors. The bytes must outlive the reader.
  [[nodiscard]] static Result<PcapReader> from_memory(std::span<const std::uint8_t> bytes, const std::string& name);
  PcapReader(PcapReader&&) noexcept;
  PcapReader& operator=(PcapReader&&) noexcept;
  ~PcapReader();

  /// Empty at the end. kFileNotReadable when the file breaks off or lies about its lengths; the frames before
  /// it have been delivered by then.
  [[nodiscard]] Result<std::optional<CapturedFrame>> next();
  /// Bytes of the file that have been read so far; 0 where it is no file in which one can tell.
  [[nodiscard]] std::uint64_t read_bytes() const;

 private:
  struct Impl;
  explicit PcapReader(std::unique_ptr<Impl> impl);
  [[nodiscard]] static Result<PcapReader> from_stream(void* stream, const std::string& name);
  std::unique_ptr<Impl> impl_;
};

}  // namespace syncline
