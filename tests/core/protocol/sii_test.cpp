// SPDX-License-Identifier: Apache-2.0
#include "protocol/sii.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "byte_helpers.h"
#include "support/byte_order.h"

namespace syncline::sii {
namespace {

using test::Bytes;
using test::from_hex;

std::string any_name() {
  const auto size = static_cast<std::size_t>(*rc::gen::inRange(0, 12));
  return *rc::gen::container<std::string>(size, rc::gen::inRange<char>('A', 'Z'));
}

template <class T>
T any() {
  return *rc::gen::arbitrary<T>();
}

General any_general() {
  General g;
  g.group = any_name();
  g.image = any_name();
  g.order = any_name();
  g.name = any_name();
  g.coe_details = any<std::uint8_t>();
  g.foe_details = any<std::uint8_t>();
  g.eoe_details = any<std::uint8_t>();
  g.flags = any<std::uint8_t>();
  g.ebus_current_ma = any<std::int16_t>();
  g.physical_ports = any<std::uint16_t>();
  g.physical_memory_address = any<std::uint16_t>();
  return g;
}

Pdo any_pdo() {
  Pdo pdo{any<std::uint16_t>(), any<std::uint8_t>(), any<std::uint8_t>(), any_name(), any<std::uint16_t>(), {}};
  const int entries = *rc::gen::inRange(0, 6);
  for (int i = 0; i < entries; ++i) {
    pdo.entries.push_back({any<std::uint16_t>(), any<std::uint8_t>(), any_name(), any<std::uint8_t>(),
                           any<std::uint8_t>(), any<std::uint16_t>()});
  }
  return pdo;
}

DcMode any_dc_mode() {
  return {any<std::uint32_t>(), any<std::uint32_t>(), any<std::uint32_t>(), any<std::int16_t>(),
          any<std::uint16_t>(), any<std::int16_t>(),  any_name(),           any_name()};
}

MailboxArea any_mailbox() {
  return {any<std::uint16_t>(), any<std::uint16_t>(), any<std::uint16_t>(), any<std::uint16_t>()};
}

template <class T, class Make>
std::vector<T> some(int at_most, Make make) {
  std::vector<T> all;
  const int count = *rc::gen::inRange(0, at_most + 1);
  for (int i = 0; i < count; ++i) all.push_back(make());
  return all;
}

Image any_image() {
  Image image;
  image.pdi_control = any<std::uint16_t>();
  image.pdi_configuration = any<std::uint16_t>();
  image.sync_impulse_length = any<std::uint16_t>();
  image.pdi_configuration2 = any<std::uint16_t>();
  image.alias = any<std::uint16_t>();
  image.reserved = {any<std::uint16_t>(), any<std::uint16_t>()};
  image.vendor_id = any<std::uint32_t>();
  image.product_code = any<std::uint32_t>();
  image.revision_no = any<std::uint32_t>();
  image.serial_no = any<std::uint32_t>();
  image.bootstrap_mailbox = any_mailbox();
  image.mailbox = any_mailbox();
  image.mailbox_protocols = any<std::uint16_t>();
  image.size_bytes = 128U * static_cast<std::uint32_t>(*rc::gen::inRange(64, 256));
  if (any<bool>()) image.general = any_general();
  image.fmmus = some<std::uint8_t>(8, [] { return static_cast<std::uint8_t>(*rc::gen::inRange(0, 4)); });
  image.sync_managers = some<SyncM>(8, [] {
    return SyncM{any<std::uint16_t>(), any<std::uint16_t>(), any<std::uint8_t>(),
                 any<std::uint8_t>(),  any<std::uint8_t>(),  any<std::uint8_t>()};
  });
  image.tx_pdos = some<Pdo>(5, any_pdo);
  image.rx_pdos = some<Pdo>(5, any_pdo);
  image.dc_modes = some<DcMode>(3, any_dc_mode);
  image.other = some<RawCategory>(3, [] {
    const auto words = static_cast<std::size_t>(*rc::gen::inRange(0, 10));
    return RawCategory{static_cast<std::uint16_t>(*rc::gen::inRange(0x0800, 0x7FFF)),
                       *rc::gen::container<Bytes>(2 * words, rc::gen::arbitrary<std::uint8_t>())};
  });
  return image;
}

Image small_image() {
  Image image;
  image.pdi_control = 0x0C08;
  image.pdi_configuration = 0x0066;
  image.sync_impulse_length = 10;
  image.vendor_id = 0x0000066F;
  image.product_code = 0x12345678;
  image.revision_no = 2;
  image.mailbox = {0x1000, 0x80, 0x1080, 0x80};
  image.mailbox_protocols = kProtocolCoe;
  image.general = General{};
  image.general->order = "SERVO";
  image.general->name = "SERVO";
  image.fmmus = {1, 2, 3};
  image.sync_managers = {{0x1000, 0x80, 0x26, 0, 1, 1}};
  return image;
}

TEST(Sii, FixedAreaByHand) {
  const auto bytes = encode(small_image());
  ASSERT_EQ(bytes.size(), 2048U);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 14), from_hex("080C 6600 0A00 0000 0000 0000 0000"));
  EXPECT_EQ(bytes[14], checksum(std::span(bytes).first(14)));
  EXPECT_EQ(bytes[15], 0);
  EXPECT_EQ(Bytes(bytes.begin() + 16, bytes.begin() + 32), from_hex("6F060000 78563412 02000000 00000000"));
  EXPECT_EQ(Bytes(bytes.begin() + 0x30, bytes.begin() + 0x3A), from_hex("0010 8000 8010 8000 0400"));
  EXPECT_EQ(Bytes(bytes.begin() + 0x7C, bytes.begin() + 0x80), from_hex("0F00 0100"));  // 16 Kbit, version 1
}

TEST(Sii, CategoriesByHand) {
  const auto bytes = encode(small_image());
  const Bytes categories(bytes.begin() + 0x80, bytes.end());
  const Bytes expected = from_hex(
      "0A00 0400 01 05 534552564F 00"  // one string, a byte to fill the word
      "1E00 1000 00000101 00 000000 000000 00 0000 0000 0000 0000 000000000000000000000000"
      "2800 0200 010203 FF"
      "2900 0400 0010 8000 26 00 01 01"
      "FFFF FFFF");
  EXPECT_EQ(Bytes(categories.begin(), categories.begin() + static_cast<std::ptrdiff_t>(expected.size())), expected);
}

TEST(Sii, ChecksumKnownValues) {
  // An independent formulation: polynomial division of 0xFF followed by zeros.
  const Bytes zeros(14, 0);
  unsigned crc = 0xFF;
  for (int bit = 0; bit < 14 * 8; ++bit) crc = (crc & 0x80U) != 0 ? ((crc << 1) ^ 0x107U) : crc << 1;
  EXPECT_EQ(checksum(zeros), crc);
}

TEST(Sii, RoundTrip) {
  EXPECT_TRUE(rc::check([] {
    const auto image = any_image();
    const auto bytes = encode(image);
    RC_ASSERT(bytes.size() == image.size_bytes);
    const auto decoded = decode(bytes);
    RC_ASSERT(decoded.has_value());
    RC_ASSERT(*decoded == image);
  }));
}

TEST(Sii, GrowsWhenTheContentNeedsMore) {
  auto image = small_image();
  image.size_bytes = 128;
  const auto bytes = encode(image);
  EXPECT_EQ(bytes.size(), 256U);
  const auto decoded = decode(bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->size_bytes, 256U);
  EXPECT_EQ(decoded->general->order, "SERVO");
}

TEST(Sii, AnImageIsAsLongAsAnEepromCanBe) {
  for (const std::size_t size : {128U, 2048U, 65'536U, 131'072U}) {
    auto image = small_image();
    image.size_bytes = static_cast<std::uint32_t>(std::max<std::size_t>(size, 256));
    const auto bytes = encode(image);
    EXPECT_EQ(told_size(bytes), bytes.size());
    EXPECT_EQ(image_size(std::span(bytes).first(128)), std::max<std::size_t>(size, 256));
  }
  EXPECT_EQ(image_size(Bytes(128, 0xFF)), 2048U) << "an EEPROM that was never written does not have 8 MiB";
  EXPECT_EQ(told_size(Bytes(128, 0xFF)), 8U << 20U);
}

TEST(Sii, WrongChecksumIsToldNotRefused) {
  auto bytes = encode(small_image());
  bytes[14] ^= 0x01;
  const auto decoded = decode(bytes);
  ASSERT_TRUE(decoded);
  EXPECT_FALSE(decoded->checksum_ok);
  EXPECT_EQ(decoded->vendor_id, 0x66FU);
}

TEST(Sii, EmptyEepromHasNoCategories) {
  const auto decoded = decode(Bytes(2048, 0xFF));
  ASSERT_TRUE(decoded);
  EXPECT_FALSE(decoded->checksum_ok);
  EXPECT_FALSE(decoded->general);
  EXPECT_TRUE(decode(Bytes(2048, 0)));
}

TEST(Sii, BrokenCategoryIsNamedWithItsPlace) {
  auto bytes = encode(small_image());
  bytes[0x82] = 0xFF;  // strings category claims 0xFF words and more than the image has
  bytes[0x83] = 0x7F;
  const auto beyond = decode(bytes);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, ErrorCode::kSii);
  EXPECT_EQ(beyond.error().detail.text(), "category 10 at word 0x0040 of 32767 words reaches beyond the image");

  auto strings = encode(small_image());
  strings[0x84] = 9;  // nine strings where there is one
  EXPECT_EQ(decode(strings).error().detail.text(), "category 10 at word 0x0040 ends inside string 3 of 9");
}

TEST(Sii, TruncatedImagesDecodeOrFailButNeverReadOutside) {
  const auto bytes = encode(small_image());
  for (std::size_t size = 0; size < 0x100; ++size) {
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    const auto decoded = decode(part);
    EXPECT_TRUE(size >= 128 || !decoded) << size;
  }
}

TEST(Sii, RandomCategoriesDecodeOrFail) {
  EXPECT_TRUE(rc::check([](const Bytes& noise, std::uint16_t type) {
    auto bytes = encode(small_image());
    bytes.resize(0x80);
    Bytes data = noise;
    if (data.size() % 2 != 0) data.push_back(0);
    const std::uint16_t known[] = {10, 30, 40, 41, 50, 51, 60, type};
    ByteWriter(bytes)
        .u16(known[*rc::gen::inRange(0, 8)])
        .u16(static_cast<std::uint16_t>(data.size() / 2))
        .bytes(data)
        .bytes(noise);
    const auto decoded = decode(bytes);
    if (decoded) RC_ASSERT(decode(encode(*decoded)).has_value());
  }));
}

}  // namespace
}  // namespace syncline::sii
