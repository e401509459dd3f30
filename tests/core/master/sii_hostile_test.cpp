// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "master/exchange/bus.h"
#include "master/scan/bus_scanner.h"
#include "protocol/sii.h"
#include "tests/support/simulated_segment.h"

/// EEPROMs and slaves that lie: the scan ends, names who and where, and the others are read.
namespace syncline {
namespace {

using testing::HasSubstr;

std::vector<std::uint8_t> honest() {
  sii::Image image;
  image.vendor_id = 0x5C17;
  image.product_code = 1;
  image.fmmus = {1, 2};
  return sii::encode(image);
}

struct HostileBed {
  VirtualClock clock;
  test::SimulatedSegment link;
  FrameExchange exchange{link, clock};
  Bus bus{exchange, clock};

  explicit HostileBed(std::vector<std::uint8_t> liar) : HostileBed({honest(), std::move(liar), honest()}) {}
  explicit HostileBed(const std::array<std::vector<std::uint8_t>, 3>& images) : link(clock, segment_of(images)) {}
  Result<BusScan> scan() { return scan_slaves(bus); }

 private:
  static SimConfig segment_of(const std::array<std::vector<std::uint8_t>, 3>& images) {
    auto config = test::terminals(images.size());
    for (std::size_t i = 0; i < images.size(); ++i) config.slaves[i].sii_image = images[i];
    return config;
  }
};

/// Bytes of every look at the liar's EEPROM interface, from 0x0502 on.
void lie(HostileBed& bed, std::function<void(std::span<std::uint8_t>)> change) {
  bed.link.on_reply = [change = std::move(change)](DatagramView& reply) {
    const bool read = reply.header.command == Command::kAprd;
    if (read && test::is_reply_of(reply, 1, 3, reg::kSiiControl)) change(reply.data);
  };
}

void put(std::vector<std::uint8_t>& bytes, std::size_t word, std::uint16_t value) {
  store_le(std::span(bytes).subspan(2 * word), value);
}

/// 2 KiB with a right header and nothing behind it.
std::vector<std::uint8_t> blank() {
  std::vector<std::uint8_t> bytes(2048);
  bytes[14] = sii::checksum(std::span<const std::uint8_t>(bytes).first(14));
  put(bytes, 0x3E, 15);
  return bytes;
}

void expect_error(HostileBed& bed, const std::string& what) {
  const auto scan = bed.scan();
  ASSERT_TRUE(scan);
  ASSERT_TRUE(scan->slaves[1].sii_error);
  EXPECT_EQ(scan->slaves[1].sii_error->subject, "slave 1");
  EXPECT_THAT(scan->slaves[1].sii_error->detail.text(), HasSubstr(what));
  EXPECT_TRUE(scan->slaves[0].sii);
  EXPECT_TRUE(scan->slaves[2].sii);
}

TEST(HostileSii, ACategoryBeyondTheEnd) {
  auto bytes = blank();
  put(bytes, 0x40, 50);
  put(bytes, 0x41, 0x7000);
  HostileBed bed(bytes);
  expect_error(bed, "category 50 at word 0x0040 of 28672 words");
}

TEST(HostileSii, CategoriesWithoutEnd) {
  auto bytes = blank();
  for (std::size_t word = 0x40; word + 1 < 1024; word += 2) put(bytes, word, 0x0801);
  HostileBed bed(bytes);
  const auto scan = bed.scan();
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->slaves[1].sii || scan->slaves[1].sii_error);
}

TEST(HostileSii, EndlessCategoriesInAnEepromThatClaimsToBeHuge) {
  std::vector<std::uint8_t> bytes(128 * 1024);
  put(bytes, 0x3E, 0xFFFF);
  for (std::size_t word = 0x40; word + 1 < bytes.size() / 2; word += 2) put(bytes, word, 0x0801);
  HostileBed bed(bytes);
  expect_error(bed, "more than 1024 categories");
}

TEST(HostileSii, AnEepromThatWasNeverWritten) {
  for (const std::uint8_t fill : {std::uint8_t{0x00}, std::uint8_t{0xFF}}) {
    HostileBed bed(std::vector<std::uint8_t>(2048, fill));
    const auto scan = bed.scan();
    ASSERT_TRUE(scan);
    EXPECT_TRUE(scan->slaves[1].sii);
    EXPECT_TRUE(scan->slaves[2].sii);
  }
}

TEST(HostileSii, AnyBytesAtAll) {
  rc::check([](const std::vector<std::uint8_t>& bytes, std::uint16_t size_word) {
    auto liar = bytes;
    liar.resize(std::max<std::size_t>(liar.size(), 0x80));
    put(liar, 0x3E, size_word);
    HostileBed bed(liar);
    const auto scan = bed.scan();
    RC_ASSERT(scan.has_value());
    RC_ASSERT(scan->slaves[1].sii.has_value() != scan->slaves[1].sii_error.has_value());
    if (scan->slaves[1].sii_error) RC_ASSERT(scan->slaves[1].sii_error->subject == "slave 1");
    RC_ASSERT(scan->slaves[0].sii.has_value());
    RC_ASSERT(scan->slaves[2].sii.has_value());
  });
}

/// The status that every look at the liar's EEPROM finds.
void claim(HostileBed& bed, std::uint16_t status) {
  lie(bed, [status](std::span<std::uint8_t> bytes) { store_le(bytes, status); });
}

TEST(HostileSii, AnEepromThatStaysBusy) {
  HostileBed bed(honest());
  claim(bed, 0x8040);
  const auto begin = bed.clock.now();
  expect_error(bed, "stays busy at word 0x0000");
  EXPECT_LT(bed.clock.now() - begin, 2 * kSecond);
}

TEST(HostileSii, AnEepromThatAcknowledgesNothing) {
  HostileBed bed(honest());
  claim(bed, 0x2040);
  expect_error(bed, "acknowledges no read command at word 0x0000");
}

TEST(HostileSii, ASlaveThatShowsAnyAddressAndStatus) {
  rc::check([](std::uint64_t seed) {
    HostileBed bed(honest());
    std::uint64_t state = seed | 1;
    lie(bed, [&state](std::span<std::uint8_t> bytes) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      store_le(bytes, static_cast<std::uint16_t>(state >> 40));
      if (bytes.size() >= 6) store_le(bytes.subspan(2), static_cast<std::uint32_t>(state >> 20) & 0xFFU);
    });
    const auto scan = bed.scan();
    RC_ASSERT(scan.has_value());
    RC_ASSERT(scan->slaves[0].sii.has_value());
    RC_ASSERT(scan->slaves[2].sii.has_value());
  });
}

/// Same header, different content behind it: each is read by itself.
TEST(SiiKinds, SlavesThatOnlyLookAlikeAreReadOneByOne) {
  const auto other = honest();
  sii::Image image;
  image.vendor_id = 0x5C17;
  image.product_code = 1;
  image.fmmus = {1, 2, 3, 1, 2};
  const auto different = sii::encode(image);
  HostileBed bed(different);
  ASSERT_TRUE(std::equal(other.begin(), other.begin() + 0x20, different.begin()));
  const auto scan = bed.scan();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->slaves[0].sii->fmmus.size(), 2U);
  EXPECT_EQ(scan->slaves[1].sii->fmmus.size(), 5U);
  EXPECT_EQ(scan->slaves[2].sii->fmmus.size(), 2U);
  for (const auto& slave : scan->slaves) EXPECT_FALSE(slave.sii_shared_with);
}

TEST(SiiKinds, AWrongHeaderChecksumSharesNothing) {
  auto damaged = honest();
  damaged[14] ^= 0x55;
  HostileBed bed({damaged, damaged, damaged});
  const auto scan = bed.scan();
  ASSERT_TRUE(scan);
  for (const auto& slave : scan->slaves) {
    EXPECT_TRUE(slave.sii);
    EXPECT_FALSE(slave.sii_shared_with);
  }
  EXPECT_EQ(scan->findings.size(), 3U);
}

}  // namespace
}  // namespace syncline
