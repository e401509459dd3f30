// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "link/link.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "protocol/system_time_difference.h"
#include "support/byte_order.h"
#include "support/whole_file.h"
#include "tests/support/temporary_folder.h"

namespace syncline::test {

inline constexpr Nanoseconds kCaptureBegin = 830'000'000 * kSecond;

/// A capture as it is written: pcap with times in ns.
class PlainCapture {
 public:
  PlainCapture() {
    for (const std::uint32_t word : {0xA1B23C4DU, 0x00040002U, 0U, 0U, 0x40000U, 1U}) put(word);
  }
  void add(Nanoseconds time, std::vector<std::uint8_t> frame) {
    const auto unix_time = time + kDcEpochUnixSeconds * kSecond;
    put(static_cast<std::uint32_t>(unix_time / kSecond));
    put(static_cast<std::uint32_t>(unix_time % kSecond));
    for (int i = 0; i < 2; ++i) put(static_cast<std::uint32_t>(frame.size()));
    bytes_.insert(bytes_.end(), frame.begin(), frame.end());
  }
  [[nodiscard]] std::string write(const TemporaryFolder& folder) const {
    const auto path = folder.file("capture.pcap");
    EXPECT_TRUE(write_whole_file(path, std::span<const std::uint8_t>(bytes_)).has_value());
    return path;
  }

 private:
  void put(std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes_.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
  }
  std::vector<std::uint8_t> bytes_;
};

/// A cycle's frame: process data, the reference clock at station 1001, the deviation of one station.
inline std::vector<std::uint8_t> cyclic_frame(std::uint8_t index, std::uint16_t station) {
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> to{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, from{0x00, 1, 2, 3, 4, 5};
  builder.set_addresses(to, from);
  EXPECT_TRUE(builder.add_zeros(Command::kLrw, index, 0x1000, 8));
  EXPECT_TRUE(builder.add_zeros(Command::kFrmw, index, device_address(1001, reg::kSystemTime), 8));
  EXPECT_TRUE(builder.add_zeros(Command::kFprd, index, device_address(station, reg::kSystemTimeDifference), 4));
  const auto bytes = builder.finish();
  return {bytes.begin(), bytes.end()};
}

inline std::vector<std::uint8_t> answered(std::vector<std::uint8_t> frame, std::uint64_t system_time,
                                          std::int64_t deviation) {
  frame[6] |= kLocallyAdministered;
  FrameReader reader(frame);
  auto data = reader.next();
  data->set_wkc(6);
  data = reader.next();
  store_le(data->data, system_time);
  data->set_wkc(1);
  data = reader.next();
  store_le(data->data, SystemTimeDifference::from_signed(deviation).raw);
  data->set_wkc(1);
  return frame;
}

}  // namespace syncline::test
