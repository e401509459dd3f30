// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "channels/frame_ring.h"
#include "record/black_box.h"
#include "support/byte_order.h"
#include "tests/support/pcapng_file.h"
#include "tests/support/temporary_folder.h"

namespace syncline::test {

inline constexpr Nanoseconds kBegin = 820'000'000 * kSecond;
inline constexpr std::uint64_t kMiB = 1ULL << 20;

/// A black box of frames that the test makes, in a folder of its own.
class BlackBoxFile : public ::testing::Test {
 protected:
  BlackBox::Options options(std::uint64_t bytes = kMiB) {
    return {.name = folder_.file("box"),
            .most_bytes = bytes,
            .keep_free_bytes = 0,
            .virtual_time = true,
            .program = "test 1.0",
            .link = "nic:eth1",
            .description = "machine.syncline"};
  }
  std::unique_ptr<BlackBox> start(const BlackBox::Options& wanted) {
    auto box = BlackBox::start(ring_, wanted, [this](const Error& error) { stopped_.push_back(error); });
    EXPECT_TRUE(box) << box.error().detail.text();
    return box ? std::move(*box) : nullptr;
  }
  /// A millisecond after the one before; its first bytes are its number.
  void push(std::size_t size = 300) {
    std::vector<std::uint8_t> frame(size);
    store_le(frame, static_cast<std::uint32_t>(pushed_));
    const auto direction = pushed_ % 2 == 0 ? FrameDirection::kSent : FrameDirection::kReceived;
    ring_->push(frame, kBegin + static_cast<Nanoseconds>(pushed_++) * kMillisecond, direction);
  }
  [[nodiscard]] std::vector<std::string> files() const { return files_in(folder_.path()); }
  [[nodiscard]] std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const auto& file : files()) {
      std::error_code gone;  // the oldest may go meanwhile
      const auto size = std::filesystem::file_size(file, gone);
      if (!gone) sum += size;
    }
    return sum;
  }

  TemporaryFolder folder_;
  std::shared_ptr<FrameRing> ring_ = std::make_shared<FrameRing>();
  std::vector<Error> stopped_;
  std::size_t pushed_ = 0;
};

}  // namespace syncline::test
