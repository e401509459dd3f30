// SPDX-License-Identifier: Apache-2.0
#include "protocol/mailbox.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "byte_helpers.h"

namespace syncline {
namespace {

using test::Bytes;
using test::from_hex;

TEST(Mailbox, HeaderByHand) {
  MailboxMessage message;
  message.counter = 3;
  message.priority = 1;
  message.channel = 2;
  message.data = from_hex("0020 40 1810 01 00000000");
  EXPECT_EQ(message.encode(), from_hex("0A00 0000 42 33 0020 40 1810 01 00000000"));
}

TEST(Mailbox, IsPaddedToTheMailbox) {
  MailboxMessage message;
  message.data = {1, 2};
  const auto bytes = message.encode(32);
  EXPECT_EQ(bytes.size(), 32U);
  EXPECT_EQ(MailboxMessage::decode(bytes)->data, (Bytes{1, 2}));
}

TEST(Mailbox, RoundTrip) {
  EXPECT_TRUE(rc::check([](std::uint16_t address, const Bytes& data) {
    MailboxMessage message;
    message.address = address;
    message.channel = static_cast<std::uint8_t>(*rc::gen::inRange(0, 64));
    message.priority = static_cast<std::uint8_t>(*rc::gen::inRange(0, 4));
    message.type = static_cast<MailboxType>(*rc::gen::inRange(0, 16));
    message.counter = static_cast<std::uint8_t>(*rc::gen::inRange(0, 8));
    message.data = data;
    const auto decoded = MailboxMessage::decode(message.encode(static_cast<std::size_t>(*rc::gen::inRange(0, 200))));
    RC_ASSERT(decoded.has_value());
    RC_ASSERT(*decoded == message);
  }));
}

TEST(Mailbox, TruncatedMessagesAreRefused) {
  MailboxMessage message;
  message.data = Bytes(10, 0x55);
  const auto bytes = message.encode();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto decoded = MailboxMessage::decode(std::span(bytes).first(size));
    ASSERT_FALSE(decoded) << size;
    EXPECT_EQ(decoded.error().code, ErrorCode::kMalformedData);
  }
}

TEST(Mailbox, AnyBytesDecodeOrFail) {
  EXPECT_TRUE(rc::check([](const Bytes& bytes) {
    const auto decoded = MailboxMessage::decode(bytes);
    if (decoded) RC_ASSERT(decoded->data.size() + MailboxMessage::kHeaderSize <= bytes.size());
  }));
}

TEST(Mailbox, CounterSkipsZero) {
  std::uint8_t counter = 0;
  for (const int expected : {1, 2, 3, 4, 5, 6, 7, 1}) {
    counter = next_mailbox_counter(counter);
    EXPECT_EQ(counter, expected);
  }
}

}  // namespace
}  // namespace syncline
