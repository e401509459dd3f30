// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <algorithm>
#include <fstream>
#include <utility>

#include "link/capture_tap.h"
#include "link/pcap_link.h"
#include "protocol/frame.h"

namespace syncline {
namespace {

using testing::HasSubstr;

TEST(Adapters, AreListedWithoutLoopback) {
  const auto adapters = list_adapters();
  ASSERT_TRUE(adapters);
  for (const auto& adapter : *adapters) EXPECT_NE(adapter.name, "lo");
}

TEST(PcapLink, MissingAdapterIsNamed) {
  RealClock clock;
  const auto link = open_pcap_link("no-such-card0", clock);
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kLinkNotFound);
  EXPECT_EQ(link.error().subject, "no-such-card0");
}

/// A veth pair of this test's own, where that is permitted.
class VethPair : public testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0 || std::system("ip link add slt0 type veth peer name slt1 >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "no permission to create a veth pair";
    }
    created_ = true;
    ASSERT_EQ(std::system("ip link set slt0 up && ip link set slt1 up"), 0);
  }
  void TearDown() override {
    if (created_) (void)!std::system("ip link del slt0 >/dev/null 2>&1");
  }
  bool created_ = false;
};

TEST_F(VethPair, FramesCrossAndTheOwnEchoDoesNotReturn) {
  RealClock clock;
  auto near = open_pcap_link("slt0", clock);
  auto far = open_pcap_link("slt1", clock);
  ASSERT_TRUE(near) << near.error().detail;
  ASSERT_TRUE(far) << far.error().detail;
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> broadcast{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  builder.set_addresses(broadcast, (*near)->describe().mac);
  ASSERT_TRUE(builder.add_zeros(Command::kBrd, 7, device_address(0, 0x0130), 2));
  const auto frame = builder.finish();
  ASSERT_TRUE((*near)->send(frame));

  std::array<std::uint8_t, 1514> buffer{};
  const auto there = (*far)->receive(buffer, clock.now() + kSecond);
  ASSERT_TRUE(there);
  ASSERT_GE(there->length, frame.size());
  EXPECT_TRUE(std::equal(frame.begin(), frame.end(), buffer.begin()));
  const auto echo = (*near)->receive(buffer, clock.now() + 5 * kMillisecond);
  ASSERT_TRUE(echo);
  EXPECT_EQ(echo->length, 0U);

  // A segment answers with the locally-administered bit set in the source address.
  std::vector<std::uint8_t> answer(frame.begin(), frame.end());
  answer[6] |= 0x02;
  ASSERT_TRUE((*far)->send(answer));
  const auto back = (*near)->receive(buffer, clock.now() + kSecond);
  ASSERT_TRUE(back);
  EXPECT_GE(back->length, frame.size());
}

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
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  // Section header 28, interface 32, two packets of 28 + 64 (padded) + 12 options + 4.
  EXPECT_EQ(bytes.size(), 28U + 32U + 2U * 108U);
  EXPECT_EQ(bytes.substr(0, 4), "\x0A\x0D\x0D\x0A");
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
