// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "master/exchange/bus.h"
#include "master/scan/bus_scanner.h"
#include "tests/support/test_bus.h"

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
  test::TestBus link{clock, 3};
  FrameExchange exchange{link, clock};
  Bus bus{exchange, clock};

  explicit HostileBed(std::vector<std::uint8_t> liar) {
    for (std::size_t i = 0; i < 3; ++i) link.slave(i).sii = honest();
    link.slave(1).sii = std::move(liar);
  }
  Result<BusScan> scan() { return scan_slaves(bus); }
};

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
  bed.link.on_frame = [&bed, status] { bed.link.slave(1).set(reg::kSiiControl, status); };
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
  // The read command of the test bus clears the status in the frame itself; the look comes in the next one.
  expect_error(bed, "acknowledges no read command at word 0x0000");
}

TEST(HostileSii, ASlaveThatShowsAnyAddressAndStatus) {
  rc::check([](std::uint64_t seed) {
    HostileBed bed(honest());
    std::uint64_t state = seed | 1;
    bed.link.on_frame = [&] {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      bed.link.slave(1).set(reg::kSiiControl, static_cast<std::uint16_t>(state >> 40));
      bed.link.slave(1).set(reg::kSiiAddress, static_cast<std::uint32_t>(state >> 20) & 0xFFU);
    };
    const auto scan = bed.scan();
    RC_ASSERT(scan.has_value());
    RC_ASSERT(scan->slaves[0].sii.has_value());
    RC_ASSERT(scan->slaves[2].sii.has_value());
  });
}

/// Same header, different content behind it: each is read by itself.
TEST(SiiKinds, SlavesThatOnlyLookAlikeAreReadOneByOne) {
  HostileBed bed(honest());
  auto other = honest();
  sii::Image image;
  image.vendor_id = 0x5C17;
  image.product_code = 1;
  image.fmmus = {1, 2, 3, 1, 2};
  const auto different = sii::encode(image);
  bed.link.slave(1).sii = different;
  ASSERT_TRUE(std::equal(other.begin(), other.begin() + 0x20, different.begin()));
  const auto scan = bed.scan();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->slaves[0].sii->fmmus.size(), 2U);
  EXPECT_EQ(scan->slaves[1].sii->fmmus.size(), 5U);
  EXPECT_EQ(scan->slaves[2].sii->fmmus.size(), 2U);
  for (const auto& slave : scan->slaves) EXPECT_FALSE(slave.sii_shared_with);
}

TEST(SiiKinds, AWrongHeaderChecksumSharesNothing) {
  HostileBed bed(honest());
  for (std::size_t i = 0; i < 3; ++i) bed.link.slave(i).sii[14] ^= 0x55;
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
