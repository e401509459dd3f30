// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pcap/pcap.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "link/pcap_link.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "support/clock.h"
#include "support/net_namespace.h"

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
    if (!network_.ready()) GTEST_SKIP() << "no permission to create a network namespace with a veth pair";
  }
  test::NetNamespace network_;
};

TEST_F(VethPair, FramesCrossAndTheOwnEchoDoesNotReturn) {
  RealClock clock;
  auto near = open_pcap_link("slm0", clock);
  auto far = open_pcap_link("slb0", clock);
  ASSERT_TRUE(near) << near.error().detail.text();
  ASSERT_TRUE(far) << far.error().detail.text();
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

  // A segment answers with the locally-administered bit set in the source address, or unchanged when its
  // DL control says so. Both must arrive, also on a card whose own address has the bit.
  std::vector<std::uint8_t> answer(frame.begin(), frame.end());
  EXPECT_EQ(answer[6] & 0x02, 0);
  for (const int bit : {0x02, 0x00}) {
    answer[6] = static_cast<std::uint8_t>(frame[6] | bit);
    ASSERT_TRUE((*far)->send(answer));
    const auto back = (*near)->receive(buffer, clock.now() + kSecond);
    ASSERT_TRUE(back);
    EXPECT_GE(back->length, frame.size()) << bit;
    EXPECT_EQ(buffer[6], answer[6]);
  }
}

TEST_F(VethPair, OtherTrafficIsNotDelivered) {
  RealClock clock;
  auto near = open_pcap_link("slm0", clock);
  auto far = open_pcap_link("slb0", clock);
  ASSERT_TRUE(near && far);
  std::vector<std::uint8_t> ip(60, 0);
  std::fill_n(ip.begin(), 6, std::uint8_t{0xFF});
  ip[12] = 0x08;
  ASSERT_TRUE((*far)->send(ip));
  std::array<std::uint8_t, 1514> buffer{};
  const auto deadline = clock.now() + 5 * kMillisecond;
  const auto received = (*near)->receive(buffer, deadline);
  ASSERT_TRUE(received);
  EXPECT_EQ(received->length, 0U);
  EXPECT_GE(clock.now(), deadline);
}

TEST_F(VethPair, WithoutPermissionTheErrorHasTheCommandForThisBinary) {
  constexpr uid_t kNobody = 65'534;
  int channel[2] = {-1, -1};
  ASSERT_EQ(::pipe(channel), 0);
  const auto child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // Another user in a process of its own: privileges once dropped do not come back.
    std::string text = "could not drop the privileges";
    if (::setuid(kNobody) == 0) {
      RealClock clock;
      const auto link = open_pcap_link("slm0", clock);
      text = link ? "opened" : std::to_string(static_cast<int>(link.error().code)) + " " + link.error().detail.text();
    }
    (void)!::write(channel[1], text.data(), text.size());
    ::_exit(0);
  }
  ::close(channel[1]);
  std::array<char, 1024> text{};
  const auto size = ::read(channel[0], text.data(), text.size() - 1);
  ::close(channel[0]);
  ::waitpid(child, nullptr, 0);
  ASSERT_GT(size, 0);
  const std::string expected = std::to_string(static_cast<int>(ErrorCode::kLinkPermission)) +
                               " sudo setcap cap_net_raw,cap_net_admin,cap_sys_nice,cap_ipc_lock=ep " +
                               std::filesystem::read_symlink("/proc/self/exe").string();
  EXPECT_EQ(std::string(text.data()), expected);
}

TEST_F(VethPair, LinkThatIsDownSaysSo) {
  ASSERT_EQ(std::system("ip link set slm0 down"), 0);
  RealClock clock;
  const auto link = open_pcap_link("slm0", clock);
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kLinkDown);
}

}  // namespace
}  // namespace syncline
