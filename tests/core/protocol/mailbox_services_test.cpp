// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck.h>

#include "protocol/aoe.h"
#include "protocol/diagnosis_message.h"
#include "protocol/foe.h"
#include "protocol/sdo_information.h"
#include "protocol/soe.h"

namespace syncline {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(SdoInformation, RequestsAreTheSpecificationsBytes) {
  EXPECT_EQ(coe::encode(coe::InformationRequest{coe::ObjectListRequest{coe::ObjectListType::kAll}}),
            (Bytes{0x00, 0x80, 0x01, 0x00, 0x00, 0x00, 0x01, 0x00}));
  EXPECT_EQ(coe::encode(coe::InformationRequest{coe::ObjectDescriptionRequest{0x1C32}}),
            (Bytes{0x00, 0x80, 0x03, 0x00, 0x00, 0x00, 0x32, 0x1C}));
  EXPECT_EQ(coe::encode(coe::InformationRequest{coe::EntryDescriptionRequest{0x1C32, 0x0B, 0x10}}),
            (Bytes{0x00, 0x80, 0x05, 0x00, 0x00, 0x00, 0x32, 0x1C, 0x0B, 0x10}));
}

Result<coe::InformationResponse> there_and_back(const coe::InformationResponse& response, std::size_t mailbox) {
  const auto messages = coe::encode(response, mailbox);
  Bytes data;
  std::uint8_t opcode = 0;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    EXPECT_LE(messages[i].size() + 6, std::max<std::size_t>(mailbox, 14));
    const auto fragment = coe::decode_information_fragment(messages[i]);
    EXPECT_TRUE(fragment);
    EXPECT_EQ(fragment->fragments_left, messages.size() - 1 - i);
    EXPECT_EQ(fragment->incomplete, i + 1 < messages.size());
    opcode = fragment->opcode;
    data.insert(data.end(), fragment->data.begin(), fragment->data.end());
  }
  return coe::decode_information_response(opcode, data);
}

TEST(SdoInformation, ResponsesOfAnyLengthComeBackFromTheirFragments) {
  coe::ObjectList list{coe::ObjectListType::kRxPdo, {}};
  for (std::uint16_t i = 0; i < 700; ++i) list.indices.push_back(static_cast<std::uint16_t>(0x2000 + i));
  const coe::ObjectDescription object{0x1C32, 0x29, 32, coe::ObjectCode::kRecord, "SM output parameter"};
  coe::EntryDescription entry{
      0x1C32, 0x0B, 0, 0x06, 16, coe::access::kRead | coe::access::kTxPdo, 0, {}, {}, {}, "SM-Event Missed"};
  for (const std::size_t mailbox : {48, 128, 1486}) {
    EXPECT_EQ(there_and_back(list, mailbox), coe::InformationResponse(list));
    EXPECT_EQ(there_and_back(object, mailbox), coe::InformationResponse(object));
    EXPECT_EQ(there_and_back(entry, mailbox), coe::InformationResponse(entry));
  }
  entry.value_info = coe::value_info::kUnitType | coe::value_info::kDefault | coe::value_info::kMaximum;
  entry.unit_type = 0x1234;
  entry.default_value = {1, 0};
  entry.maximum = {0xFF, 0xFF};
  EXPECT_EQ(there_and_back(entry, 128), coe::InformationResponse(entry));
  EXPECT_EQ(there_and_back(coe::InformationError{0x06020000}, 128),
            coe::InformationResponse(coe::InformationError{0x06020000}));
}

TEST(SdoInformation, AnswerIsKnownByItsOpcode) {
  const coe::InformationRequest list{coe::ObjectListRequest{}}, entry{coe::EntryDescriptionRequest{}};
  EXPECT_TRUE(coe::answers(2, list));
  EXPECT_FALSE(coe::answers(2, entry));
  EXPECT_TRUE(coe::answers(6, entry));
  EXPECT_TRUE(coe::answers(7, list)) << "an error answers everything";
}

TEST(SdoInformation, EntryThatIsShorterThanItSaysIsRefused) {
  coe::EntryDescription entry{0x6040, 0, coe::value_info::kDefault, 0x06, 16, 7, 0, {1, 2}, {}, {}, ""};
  const auto messages = coe::encode(entry, 128);
  auto fragment = coe::decode_information_fragment(messages.front());
  ASSERT_TRUE(fragment);
  fragment->data.pop_back();
  EXPECT_FALSE(coe::decode_information_response(fragment->opcode, fragment->data));
}

TEST(Foe, MessagesComeBack) {
  const std::vector<foe::Message> messages{foe::ReadRequest{0x12345678, "firmware.efw"},
                                           foe::WriteRequest{0, "a"},
                                           foe::Data{1, {1, 2, 3}},
                                           foe::Data{70'000, {}},
                                           foe::Ack{3},
                                           foe::FileError{foe::error::kNotFound, "no such file"},
                                           foe::Busy{10, 100, "erasing"}};
  for (const auto& message : messages) {
    const auto back = foe::decode(foe::encode(message));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, message);
  }
  EXPECT_EQ(foe::encode(foe::WriteRequest{5, "ab"}), (Bytes{2, 0, 5, 0, 0, 0, 'a', 'b'}));
}

TEST(Foe, WordsForEveryErrorOfTheTable) {
  for (std::uint32_t code = foe::error::kNotDefined; code <= foe::error::kProgramError; ++code) {
    EXPECT_NE(foe::error_text(code), foe::error_text(0xFFFF)) << code;
  }
}

TEST(DiagnosisMessage, ComesBackWithItsParameters) {
  const DiagnosisMessage message{
      0x0000E800,
      DiagnosisMessage::Type::kError,
      0x0012,
      123'456'789,
      {{0x0006, {0x34, 0x12}}, {0x2003, {'a', 'b', 'c'}}, {0x001B, {1, 2, 3, 4, 5, 6, 7, 8}}}};
  const auto back = DiagnosisMessage::decode(message.encode());
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, message);
  auto bytes = message.encode();
  bytes.pop_back();
  EXPECT_FALSE(DiagnosisMessage::decode(bytes));
}

TEST(MailboxServices, AnyBytesAreReadOrRefused) {
  EXPECT_TRUE(rc::check("random bytes", [](const Bytes& bytes) {
    (void)foe::decode(bytes);
    (void)DiagnosisMessage::decode(bytes);
    (void)coe::decode_information_request(bytes);
    if (const auto fragment = coe::decode_information_fragment(bytes)) {
      (void)coe::decode_information_response(fragment->opcode, fragment->data);
    }
    for (std::uint8_t opcode = 0; opcode < 9; ++opcode) (void)coe::decode_information_response(opcode, bytes);
  }));
}

TEST(SoeMessage, KeepsEveryField) {
  soe::Header header;
  header.op_code = soe::OpCode::kWriteRequest;
  header.drive_no = 5;
  header.idn = 0x8021;
  header.incomplete = header.error = true;
  const auto bytes = soe::encode(header);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0xBB, 0x40, 0x21, 0x80}));
  EXPECT_EQ(soe::decode(bytes).value(), header);
  for (const auto* wrong : {"\x00\x40\x00\x00", "\x07\x40\x00\x00"}) {
    const std::vector<std::uint8_t> message(wrong, wrong + 4);
    EXPECT_FALSE(soe::decode(message));
  }
  EXPECT_FALSE(soe::decode(std::span(bytes).first(3)));
}

TEST(AoeMessage, KeepsEveryField) {
  aoe::Header header;
  header.target = {{1, 2, 3, 4, 5, 6}, 0x0102};
  header.source = {{6, 5, 4, 3, 2, 1}, 0x8001};
  header.command = aoe::kReadWrite;
  header.state_flags = 5;
  header.length = 70'000;
  header.error_code = 0x701;
  header.invoke_id = 0xDEADBEEF;
  const auto bytes = aoe::encode(header);
  ASSERT_EQ(bytes.size(), aoe::Header::kSize);
  EXPECT_EQ(bytes[16], 9) << "command behind two addresses of eight bytes";
  EXPECT_EQ(aoe::decode(bytes).value(), header);
  EXPECT_FALSE(aoe::decode(std::span(bytes).first(31)));
}

}  // namespace
}  // namespace syncline
