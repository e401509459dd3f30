// SPDX-License-Identifier: Apache-2.0
#include "protocol/frame.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "byte_helpers.h"
#include "protocol/datagram.h"

namespace syncline {
namespace {

using test::Bytes;
using test::from_hex;

struct Datagram {
  Command command;
  std::uint8_t index;
  std::uint32_t address;
  Bytes data;
};

rc::Gen<Datagram> any_datagram() {
  return rc::gen::construct<Datagram>(
      rc::gen::map(rc::gen::inRange(0, kLastCommand + 1), [](int c) { return static_cast<Command>(c); }),
      rc::gen::arbitrary<std::uint8_t>(), rc::gen::arbitrary<std::uint32_t>(), rc::gen::arbitrary<Bytes>());
}

TEST(FrameBuilder, WritesTheBytesOfTheSpecification) {
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> destination{0x01, 0x01, 0x05, 0x01, 0x00, 0x00};
  const std::array<std::uint8_t, 6> source{0x10, 0x11, 0x12, 0x13, 0x14, 0x15};
  builder.set_addresses(destination, source);
  const Bytes two{0x11, 0x00};
  ASSERT_TRUE(builder.add(Command::kBwr, 1, device_address(0, 0x0120), two));
  ASSERT_TRUE(builder.add_zeros(Command::kFprd, 2, device_address(0x1001, 0x0130), 2));
  const auto frame = builder.finish();
  Bytes expected = from_hex(
      "010105010000 101112131415 88A4"
      "1C10"                                   // 28 bytes of datagrams, type 1
      "08 01 0000 2001 0280 0000 1100 0000"    // BWR, more follows
      "04 02 0110 3001 0200 0000 0000 0000");  // FPRD, last
  expected.resize(60, 0);
  EXPECT_EQ(Bytes(frame.begin(), frame.end()), expected);
}

TEST(FrameBuilder, DefaultsToBroadcast) {
  FrameBuilder builder;
  const auto frame = builder.finish();
  EXPECT_EQ(Bytes(frame.begin(), frame.begin() + 6), from_hex("FFFFFFFFFFFF"));
  EXPECT_EQ(frame.size(), kMinEthernetFrame);
}

TEST(FrameBuilder, TakesOneFullDatagramAndNoByteMore) {
  FrameBuilder builder;
  EXPECT_FALSE(builder.add(Command::kLrw, 0, 0, Bytes(kMaxDatagramData + 1)));
  EXPECT_TRUE(builder.empty());
  EXPECT_TRUE(builder.add(Command::kLrw, 0, 0, Bytes(kMaxDatagramData)));
  EXPECT_FALSE(builder.add_zeros(Command::kNop, 0, 0, 0));
  EXPECT_EQ(builder.finish().size(), kMaxEthernetFrame);
}

TEST(FrameBuilder, ResetForgetsTheDatagramsButKeepsTheAddresses) {
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> address{0x10, 1, 2, 3, 4, 5};
  builder.set_addresses(address, address);
  (void)builder.add(Command::kLrw, 9, 77, Bytes(200, 0xEE));
  (void)builder.finish();
  builder.reset();
  ASSERT_TRUE(builder.add_zeros(Command::kNop, 0, 0, 4));
  const auto frame = builder.finish();
  Bytes expected = from_hex("100102030405 100102030405 88A4 1010 00 00 00000000 0400 0000 00000000 0000");
  expected.resize(60, 0);  // nothing of the earlier frame in the padding
  EXPECT_EQ(Bytes(frame.begin(), frame.end()), expected);
}

TEST(Frame, WhatIsBuiltIsRead) {
  EXPECT_TRUE(rc::check([] {
    const auto wanted = *rc::gen::container<std::vector<Datagram>>(any_datagram());
    FrameBuilder builder;
    std::vector<Datagram> sent;
    for (const auto& d : wanted) {
      if (builder.add(d.command, d.index, d.address, d.data)) sent.push_back(d);
    }
    const auto built = builder.finish();
    Bytes frame(built.begin(), built.end());
    FrameReader reader(frame);
    RC_ASSERT(reader.is_ethercat());
    for (std::size_t i = 0; i < sent.size(); ++i) {
      const auto view = reader.next();
      RC_ASSERT(view.has_value());
      RC_ASSERT(view->header.command == sent[i].command);
      RC_ASSERT(view->header.index == sent[i].index);
      RC_ASSERT(view->header.address == sent[i].address);
      RC_ASSERT(view->header.more == (i + 1 < sent.size()));
      RC_ASSERT(Bytes(view->data.begin(), view->data.end()) == sent[i].data);
      RC_ASSERT(view->wkc() == 0);
    }
    RC_ASSERT(!reader.next());
    RC_ASSERT(!reader.malformed());
  }));
}

TEST(Frame, AnswersAreWrittenIntoTheFrame) {
  FrameBuilder builder;
  ASSERT_TRUE(builder.add_zeros(Command::kAprd, 5, device_address(0, 0x0010), 2));
  ASSERT_TRUE(builder.add_zeros(Command::kBrd, 6, device_address(0, 0x0130), 2));
  const auto built = builder.finish();
  Bytes frame(built.begin(), built.end());
  {
    FrameReader reader(frame);
    auto view = reader.next();
    ASSERT_TRUE(view);
    view->header.address = device_address(1, 0x0010);
    view->header.irq = 0x0004;
    view->header.circulating = true;
    view->header.length = 99;  // may not change on the wire
    view->store_header();
    view->data[0] = 0xE9;
    view->set_wkc(3);
  }
  FrameReader reader(frame);
  const auto view = reader.next();
  ASSERT_TRUE(view);
  EXPECT_EQ(view->header.adp(), 1);
  EXPECT_EQ(view->header.ado(), 0x0010);
  EXPECT_EQ(view->header.irq, 0x0004);
  EXPECT_TRUE(view->header.circulating);
  EXPECT_TRUE(view->header.more);
  EXPECT_EQ(view->header.length, 2);
  EXPECT_EQ(view->data[0], 0xE9);
  EXPECT_EQ(view->wkc(), 3);
  EXPECT_TRUE(reader.next());
}

TEST(FrameReader, SkipsAVlanTag) {
  Bytes frame = from_hex("FFFFFFFFFFFF 100102030405 8100 0005 88A4 0E10 07 09 0000 3001 0200 0000 0800 0300");
  frame.resize(64, 0);
  FrameReader reader(frame);
  const auto view = reader.next();
  ASSERT_TRUE(view);
  EXPECT_EQ(view->header.command, Command::kBrd);
  EXPECT_EQ(view->wkc(), 3);
}

TEST(FrameReader, RefusesWhatIsNotEtherCat) {
  Bytes ip = from_hex("FFFFFFFFFFFF 100102030405 0800 0E10");
  EXPECT_FALSE(FrameReader(ip).is_ethercat());
  Bytes mailbox_gateway = from_hex("FFFFFFFFFFFF 100102030405 88A4 0050");
  EXPECT_FALSE(FrameReader(mailbox_gateway).is_ethercat());
}

TEST(FrameReader, TellsALyingLengthField) {
  Bytes frame = from_hex("FFFFFFFFFFFF 100102030405 88A4 0F10 07 09 0000 3001 0200 0000 0800 0300");
  FrameReader longer(frame);
  EXPECT_FALSE(longer.is_ethercat());
  EXPECT_TRUE(longer.malformed());
  frame[14] = 0x0E;
  frame[23] = 0x80;  // more datagrams, but there are none
  FrameReader missing(frame);
  EXPECT_TRUE(missing.next());
  EXPECT_FALSE(missing.next());
  EXPECT_TRUE(missing.malformed());
  frame[23] = 0x07;  // 1794 bytes of data
  FrameReader big(frame);
  EXPECT_FALSE(big.next());
  EXPECT_TRUE(big.malformed());
}

TEST(FrameReader, SlavesFollowTheDatagramsWhateverTheHeaderSays) {
  Bytes frame = from_hex("FFFFFFFFFFFF 100102030405 88A4 0F10 07 09 0000 3001 0200 0000 0800 0300");
  for (const std::uint8_t length : {0x00, 0x05, 0x0E, 0x0F, 0xFF}) {
    frame[14] = length;
    FrameReader reader(frame, FrameReader::LengthField::kIgnored);
    EXPECT_TRUE(reader.is_ethercat());
    const auto view = reader.next();
    ASSERT_TRUE(view) << int{length};
    EXPECT_EQ(view->header.length, 2);
    EXPECT_EQ(view->wkc(), 3);
    EXPECT_FALSE(reader.next());
    EXPECT_FALSE(reader.malformed());
  }
}

TEST(FrameReader, NeverReadsOutside) {
  EXPECT_TRUE(rc::check([](Bytes frame, bool ethercat) {
    if (ethercat && frame.size() > 14) {
      frame[12] = 0x88;
      frame[13] = 0xA4;
      if (frame.size() > 15) frame[15] = static_cast<std::uint8_t>(0x10 | (frame[15] & 0x07));
    }
    FrameReader reader(frame);
    std::size_t walked = 0;
    while (auto view = reader.next()) {
      RC_ASSERT(view->wkc_bytes.data() + view->wkc_bytes.size() <= frame.data() + frame.size());
      view->set_wkc(static_cast<std::uint16_t>(view->wkc() + 1));
      ++walked;
    }
    RC_ASSERT(walked <= frame.size() / (kDatagramHeaderSize + kWkcSize));
  }));
}

TEST(FrameReader, EveryTruncationOfAGoodFrameIsSafe) {
  FrameBuilder builder;
  for (std::uint8_t i = 0; i < 5; ++i) ASSERT_TRUE(builder.add(Command::kLrw, i, i, Bytes(20, i)));
  const auto built = builder.finish();
  for (std::size_t size = 0; size < built.size(); ++size) {
    Bytes part(built.begin(), built.begin() + static_cast<std::ptrdiff_t>(size));
    FrameReader reader(part);
    EXPECT_FALSE(reader.is_ethercat()) << size;
    EXPECT_FALSE(reader.next());
  }
}

TEST(WireTime, MatchesTheReference) {
  EXPECT_EQ(wire_time_ns(60), 6'720);
  EXPECT_EQ(wire_time_ns(114), 11'040);
  EXPECT_EQ(wire_time_ns(1514), 123'040);
}

TEST(FrameReader, LengthFieldMayBeRoundedUp) {
  // TwinCAT sends one data byte (13 bytes of datagram) with a length field of 14.
  FrameBuilder builder;
  ASSERT_TRUE(builder.add_zeros(Command::kBwr, 4, device_address(0, 0x0101), 1));
  const auto built = builder.finish();
  std::array<std::uint8_t, kMinEthernetFrame> frame{};
  std::ranges::copy(built.first(frame.size()), frame.begin());
  ASSERT_EQ(frame[kEthernetHeaderSize], 13);
  frame[kEthernetHeaderSize] = 14;
  FrameReader reader(frame);
  const auto datagram = reader.next();
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->data.size(), 1U);
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.malformed());
}

}  // namespace
}  // namespace syncline
