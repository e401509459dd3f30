// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "byte_helpers.h"
#include "protocol/coe.h"
#include "protocol/diagnosis_message.h"
#include "protocol/eoe.h"
#include "protocol/foe.h"
#include "protocol/mailbox.h"
#include "protocol/sdo_information.h"
#include "protocol/voe.h"

namespace syncline {
namespace {

using test::Bytes;
using test::from_hex;

TEST(MailboxErrorReply, ByHandAndBack) {
  EXPECT_EQ(MailboxError{MailboxErrorDetail::kUnsupportedProtocol}.encode(), from_hex("0100 0200"));
  const auto decoded = MailboxError::decode(from_hex("0100 0800"));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->detail, MailboxErrorDetail::kInvalidSize);
  EXPECT_FALSE(MailboxError::decode(from_hex("0100 02")));
  EXPECT_FALSE(MailboxError::decode(from_hex("0200 0200")));
}

TEST(MailboxErrorReply, EveryDetailHasItsOwnWords) {
  std::set<std::string_view> words;
  for (std::uint16_t detail = 1; detail <= 9; ++detail)
    words.insert(mailbox_error_text(static_cast<MailboxErrorDetail>(detail)));
  EXPECT_EQ(words.size(), 9U);
  EXPECT_EQ(mailbox_error_text(static_cast<MailboxErrorDetail>(77)), "unknown mailbox error");
}

TEST(Eoe, FragmentHeaderByHand) {
  eoe::Header header;
  header.port = 1;
  header.last_fragment = true;
  header.fragment_no = 2;
  header.offset = 3;
  header.frame_no = 4;
  EXPECT_EQ(eoe::encode(header), from_hex("1001 C240"));
  EXPECT_EQ(*eoe::decode(from_hex("1001 C240")), header);
  eoe::Header refusal;
  refusal.kind = eoe::Kind::kSetIpResponse;
  refusal.result = eoe::kNoIpSupport;
  EXPECT_EQ(eoe::encode(refusal), from_hex("0300 0102"));
  EXPECT_EQ(*eoe::decode(from_hex("0300 0102")), refusal);
}

TEST(Voe, TellsWhoseItIs) {
  const auto header = voe::decode(from_hex("39050000 0700 AABB"));
  ASSERT_TRUE(header);
  EXPECT_EQ(*header, (voe::Header{0x539, 7}));
  EXPECT_FALSE(voe::decode(from_hex("39050000 07")));
}

/// What is decoded encodes to something that decodes to the same, whatever the bytes were.
TEST(MailboxProtocols, AnyBytesDecodeOrFail) {
  EXPECT_TRUE(rc::check([](const Bytes& bytes) {
    if (const auto m = eoe::decode(bytes)) RC_ASSERT((eoe::decode(eoe::encode(*m)) == *m));
    if (const auto m = foe::decode(bytes)) RC_ASSERT((foe::decode(foe::encode(*m)) == *m));
    if (const auto m = MailboxError::decode(bytes)) RC_ASSERT((MailboxError::decode(m->encode()) == *m));
    (void)voe::decode(bytes);
    (void)DiagnosisMessage::decode(bytes);
    (void)coe::decode_information_request(bytes);
    (void)coe::decode_information_fragment(bytes);
    for (std::uint8_t opcode = 0; opcode < 9; ++opcode) (void)coe::decode_information_response(opcode, bytes);
  }));
}

}  // namespace
}  // namespace syncline
