// SPDX-License-Identifier: Apache-2.0
#include "capture/capture_tap.h"

#include <gtest/gtest.h>
#include <pcap/pcap.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "link/link.h"
#include "support/clock.h"

namespace syncline {
namespace {

/// Gives back what was sent.
class EchoLink final : public Link {
 public:
  Status send(std::span<const std::uint8_t> frame) override {
    frame_.assign(frame.begin(), frame.end());
    return {};
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    std::copy(frame_.begin(), frame_.end(), buffer.begin());
    return ReceivedFrame{std::exchange(frame_, {}).size(), deadline};
  }
  [[nodiscard]] LinkDescription describe() const override { return {}; }

 private:
  std::vector<std::uint8_t> frame_;
};

TEST(CaptureTap, FileHoldsBothDirectionsAndAppearsWhenComplete) {
  const auto path = std::filesystem::temp_directory_path() / ("syncline-tap-" + std::to_string(::getpid()) + ".pcapng");
  VirtualClock clock;
  {
    auto tap = make_capture_tap(std::make_unique<EchoLink>(), path.string(), clock);
    ASSERT_TRUE(tap);
    const std::vector<std::uint8_t> frame(61, 0x5A);
    ASSERT_TRUE((*tap)->send(frame));
    std::array<std::uint8_t, 1514> buffer{};
    ASSERT_EQ((*tap)->receive(buffer, clock.now() + 100)->length, 61U);
    ASSERT_EQ((*tap)->receive(buffer, clock.now() + 100)->length, 0U);
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_EQ(std::filesystem::file_size(path), 28U + 32U + 2U * 108U);
  // Read by an implementation that is not ours.
  char text[PCAP_ERRBUF_SIZE] = {};
  auto* file = pcap_open_offline_with_tstamp_precision(path.c_str(), PCAP_TSTAMP_PRECISION_NANO, text);
  ASSERT_NE(file, nullptr) << text;
  EXPECT_EQ(pcap_datalink(file), DLT_EN10MB);
  for (const Nanoseconds offset : {0, 100}) {
    pcap_pkthdr* header = nullptr;
    const u_char* bytes = nullptr;
    ASSERT_EQ(pcap_next_ex(file, &header, &bytes), 1);
    EXPECT_EQ(header->len, 61U);
    EXPECT_EQ(bytes[60], 0x5A);
    // tv_usec holds nanoseconds here.
    const auto time = header->ts.tv_sec * kSecond + header->ts.tv_usec;
    EXPECT_EQ(time, VirtualClock::kDefaultStart + offset + kDcEpochUnixSeconds * kSecond);
  }
  pcap_pkthdr* header = nullptr;
  const u_char* bytes = nullptr;
  EXPECT_EQ(pcap_next_ex(file, &header, &bytes), PCAP_ERROR_BREAK);
  pcap_close(file);
  std::filesystem::remove(path);
}

TEST(CaptureTap, UnwritablePathIsAnErrorThatNamesTheFile) {
  VirtualClock clock;
  const auto tap = make_capture_tap(std::make_unique<EchoLink>(), "/nowhere/at/all.pcapng", clock);
  ASSERT_FALSE(tap);
  EXPECT_EQ(tap.error().file, "/nowhere/at/all.pcapng");
}

}  // namespace
}  // namespace syncline
