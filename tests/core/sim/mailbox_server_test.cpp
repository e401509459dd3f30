// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "config/device_description.h"
#include "protocol/diagnosis_message.h"
#include "sim/mailbox/complete_access.h"
#include "sim/mailbox/mailbox_server.h"
#include "sim/objects/diagnosis_history.h"
#include "sim/objects/pdo_objects.h"

namespace syncline::sim {
namespace {

using Bytes = std::vector<std::uint8_t>;
using testing::ElementsAre;

constexpr std::size_t kMailbox = 64;

/// A mailbox server with a dictionary of a few objects.
class Server : public testing::Test {
 protected:
  Server() {
    dictionary.add<std::uint32_t>(0x1000, 0, "Device type", 0x192);
    dictionary.set_object_name(0x2000, "Things");
    dictionary.add<std::uint8_t>(0x2000, 0, "Number", 3);
    dictionary.add<std::uint16_t>(0x2000, 1, "First", 0x1111, true);
    auto& bit = dictionary.add<std::uint8_t>(0x2000, 2, "Second", 1, true);
    bit.bit_length = 1;
    auto& rest = dictionary.add<std::uint8_t>(0x2000, 3, "Third", 0x15, true);
    rest.bit_length = 7;
    Bytes longer(300);
    std::iota(longer.begin(), longer.end(), std::uint8_t{0});
    dictionary.add(0x2001, 0, "Long", longer, true);
    auto& secret = dictionary.add<std::uint16_t>(0x2002, 0, "Secret", 7, true);
    secret.readable = false;
    mailbox.coe = CoeDescription{};
    mailbox.coe->sdo_info = mailbox.coe->complete_access = true;
    mailbox.foe = true;
  }

  MailboxServer& server() {
    if (!server_) server_.emplace(dictionary, mailbox, 0);
    return *server_;
  }
  void send(MailboxType type, Bytes data, std::uint8_t channel = 0) {
    MailboxMessage message;
    message.type = type;
    message.channel = channel;
    message.data = std::move(data);
    message.counter = counter_ = next_mailbox_counter(counter_);
    server().receive(message.encode(kMailbox), kMailbox, in_preop);
  }
  MailboxMessage fetch() {
    const auto bytes = server().next(kMailbox);
    EXPECT_TRUE(bytes);
    return bytes ? MailboxMessage::decode(*bytes).value_or(MailboxMessage{}) : MailboxMessage{};
  }
  coe::Response ask(const coe::Request& request) {
    send(MailboxType::kCoe, coe::encode(request));
    return coe::decode_response(fetch().data).value_or(coe::Abort{{}, 0xFFFF'FFFF});
  }
  std::uint32_t abort_of(const coe::Request& request) {
    const auto response = ask(request);
    const auto* found = std::get_if<coe::Abort>(&response);
    return found != nullptr ? found->code : 0;
  }
  /// All fragments of one answer.
  Result<coe::InformationResponse> inform(const coe::InformationRequest& request) {
    send(MailboxType::kCoe, coe::encode(request));
    Bytes data;
    for (;;) {
      const auto fragment = coe::decode_information_fragment(fetch().data);
      if (!fragment) return tl::unexpected(fragment.error());
      EXPECT_TRUE(coe::answers(fragment->opcode, request));
      data.insert(data.end(), fragment->data.begin(), fragment->data.end());
      if (fragment->fragments_left == 0) return coe::decode_information_response(fragment->opcode, data);
    }
  }

  ObjectDictionary dictionary;
  MailboxDescription mailbox;
  bool in_preop = true;

 private:
  std::optional<MailboxServer> server_;
  std::uint8_t counter_ = 0;
};

TEST_F(Server, CompleteAccessPacksTheEntriesByTheirBits) {
  const auto response = ask(coe::UploadRequest{{0x2000, 0}, true});
  ASSERT_TRUE(std::holds_alternative<coe::UploadResponse>(response));
  // Count and padding, 16 bits, 1 bit and 7 bits.
  EXPECT_THAT(std::get<coe::UploadResponse>(response).data, ElementsAre(3, 0, 0x11, 0x11, 0x2B));
  const auto from_one = ask(coe::UploadRequest{{0x2000, 1}, true});
  EXPECT_THAT(std::get<coe::UploadResponse>(from_one).data, ElementsAre(0x11, 0x11, 0x2B));
}

TEST_F(Server, CompleteAccessWritesWhatItReads) {
  const Bytes image{3, 0, 0x34, 0x12, 0x54};
  const coe::DownloadRequest request{{0x2000, 0}, true, false, 5, image};
  EXPECT_TRUE(std::holds_alternative<coe::DownloadResponse>(ask(request)));
  EXPECT_EQ(dictionary.get<std::uint16_t>(0x2000, 1), 0x1234);
  EXPECT_EQ(dictionary.get<std::uint8_t>(0x2000, 2), 0);
  EXPECT_EQ(dictionary.get<std::uint8_t>(0x2000, 3), 0x2A);
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x2000, 0}, true, false, 4, {3, 0, 1, 2}}), abort::kTooShort);
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x2000, 0}, true, false, 6, {3, 0, 1, 2, 3, 4}}), abort::kTooLong);
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x2000, 0}, true, false, 5, {9, 0, 1, 2, 3}}), abort::kReadOnly);
}

TEST_F(Server, AbortCodesSayWhatIsWrong) {
  EXPECT_EQ(abort_of(coe::UploadRequest{{0x3000, 0}, false}), abort::kNoObject);
  EXPECT_EQ(abort_of(coe::UploadRequest{{0x2000, 9}, false}), abort::kNoSubIndex);
  EXPECT_EQ(abort_of(coe::UploadRequest{{0x2002, 0}, false}), abort::kWriteOnly);
  EXPECT_EQ(abort_of(coe::UploadRequest{{0x2000, 2}, true}), abort::kUnsupportedAccess);
  EXPECT_EQ(abort_of(coe::UploadSegmentRequest{false}), abort::kCommand);
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x1000, 0}, false, true, 4, {1, 2, 3, 4}}), abort::kReadOnly);
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x2000, 1}, false, true, 1, {1}}), abort::kTooShort);
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x2000, 1}, false, true, 4, {1, 2, 3, 4}}), abort::kTooLong);
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x2001, 0}, false, false, 1'000'000, Bytes(10)}), abort::kOutOfMemory);
  dictionary.find(0x2000, 1)->preop_only = true;
  in_preop = false;
  EXPECT_EQ(abort_of(coe::DownloadRequest{{0x2000, 1}, false, true, 2, {1, 2}}), abort::kDeviceState);
}

TEST_F(Server, DeviceWithoutCompleteAccessSaysSo) {
  mailbox.coe->complete_access = false;
  EXPECT_EQ(abort_of(coe::UploadRequest{{0x2000, 0}, true}), abort::kNoCompleteAccess);
}

TEST_F(Server, SegmentsCarryLongValuesBothWaysAndMindTheToggle) {
  auto response = ask(coe::UploadRequest{{0x2001, 0}, false});
  auto data = std::get<coe::UploadResponse>(response).data;
  for (bool toggle = false; data.size() < 300; toggle = !toggle) {
    response = ask(coe::UploadSegmentRequest{toggle});
    const auto& segment = std::get<coe::UploadSegmentResponse>(response);
    EXPECT_EQ(segment.toggle, toggle);
    data.insert(data.end(), segment.data.begin(), segment.data.end());
    EXPECT_EQ(segment.last, data.size() == 300);
  }
  EXPECT_EQ(data[299], 299 % 256);

  Bytes sent(300, 0x5A);
  (void)ask(coe::DownloadRequest{{0x2001, 0}, false, false, 300, Bytes(sent.begin(), sent.begin() + 40)});
  EXPECT_EQ(abort_of(coe::DownloadSegmentRequest{true, false, Bytes(50, 0x5A)}), abort::kToggle);
  (void)ask(coe::DownloadRequest{{0x2001, 0}, false, false, 300, Bytes(sent.begin(), sent.begin() + 40)});
  bool toggle = false;
  for (std::size_t at = 40; at < 300; at += 52, toggle = !toggle) {
    const bool last = at + 52 >= 300;
    (void)ask(coe::DownloadSegmentRequest{toggle, last, Bytes(std::min<std::size_t>(52, 300 - at), 0x5A)});
  }
  EXPECT_EQ(dictionary.find(0x2001, 0)->value, sent);
}

TEST_F(Server, InformationListsAndDescribesWhatIsThere) {
  dictionary.find(0x2000, 1)->extra_access = coe::access::kTxPdo;
  const auto all = inform(coe::ObjectListRequest{coe::ObjectListType::kAll});
  ASSERT_TRUE(all);
  EXPECT_THAT(std::get<coe::ObjectList>(*all).indices, ElementsAre(0x1000, 0x2000, 0x2001, 0x2002));
  const auto lengths = inform(coe::ObjectListRequest{coe::ObjectListType::kLengths});
  EXPECT_THAT(std::get<coe::ObjectList>(*lengths).indices, ElementsAre(4, 0, 1, 0, 0));
  const auto tx = inform(coe::ObjectListRequest{coe::ObjectListType::kTxPdo});
  EXPECT_THAT(std::get<coe::ObjectList>(*tx).indices, ElementsAre(0x2000));

  const auto object = std::get<coe::ObjectDescription>(inform(coe::ObjectDescriptionRequest{0x2000}).value());
  EXPECT_EQ(object.index, 0x2000);
  EXPECT_EQ(object.name, "Things");
  EXPECT_EQ(object.max_sub_index, 3);
  EXPECT_EQ(object.code, coe::ObjectCode::kRecord);
  const auto entry = std::get<coe::EntryDescription>(
      inform(coe::EntryDescriptionRequest{0x2000, 1, coe::value_info::kDefault}).value());
  EXPECT_EQ(entry.name, "First");
  EXPECT_EQ(entry.data_type, 0x06);
  EXPECT_EQ(entry.bit_length, 16);
  EXPECT_EQ(entry.access, coe::access::kRead | coe::access::kWrite | coe::access::kTxPdo);
  EXPECT_EQ(entry.value_info, coe::value_info::kDefault);
  EXPECT_THAT(entry.default_value, ElementsAre(0x11, 0x11));
  const auto unasked = std::get<coe::EntryDescription>(inform(coe::EntryDescriptionRequest{0x2000, 1, 0}).value());
  EXPECT_EQ(unasked.index, 0x2000);
  EXPECT_EQ(unasked.sub_index, 1);
  EXPECT_EQ(unasked.value_info, 0);
  EXPECT_THAT(unasked.default_value, testing::IsEmpty());
  const auto none = std::get<coe::InformationError>(inform(coe::EntryDescriptionRequest{0x2000, 9, 0}).value());
  EXPECT_EQ(none.abort_code, abort::kNoSubIndex);
}

TEST_F(Server, AGapBetweenEntriesIsDescribedAsNothing) {
  dictionary.set_object_name(0x2010, "Gaps");
  dictionary.add<std::uint8_t>(0x2010, 0, "Number", 5);
  dictionary.add<std::uint16_t>(0x2010, 5, "Fifth", 1);
  const auto gap = std::get<coe::EntryDescription>(
      inform(coe::EntryDescriptionRequest{0x2010, 3, coe::value_info::kDefault}).value());
  EXPECT_EQ(gap.index, 0x2010);
  EXPECT_EQ(gap.sub_index, 3);
  EXPECT_EQ(gap.data_type, 0);
  EXPECT_EQ(gap.bit_length, 0);
  EXPECT_EQ(gap.access, 0);
  EXPECT_EQ(std::get<coe::InformationError>(inform(coe::EntryDescriptionRequest{0x2010, 6, 0}).value()).abort_code,
            abort::kNoSubIndex);
  EXPECT_EQ(abort_of(coe::UploadRequest{{0x2010, 3}, false}), abort::kNoSubIndex) << "there is nothing to read";
}

TEST_F(Server, InformationOfADeviceWithoutItIsAMailboxError) {
  mailbox.coe->sdo_info = false;
  send(MailboxType::kCoe, coe::encode(coe::InformationRequest{coe::ObjectListRequest{}}));
  const auto reply = fetch();
  EXPECT_EQ(reply.type, MailboxType::kError);
  EXPECT_THAT(reply.data, ElementsAre(1, 0, 4, 0));
}

TEST_F(Server, ProtocolsAndChannelsThatItDoesNotHaveAreMailboxErrors) {
  send(MailboxType::kEoe, {0, 0, 0, 0});
  EXPECT_THAT(fetch().data, ElementsAre(1, 0, 2, 0));
  send(MailboxType::kCoe, {0, 0x20, 0x40}, 5);
  EXPECT_THAT(fetch().data, ElementsAre(1, 0, 3, 0));
  send(MailboxType::kCoe, {0});
  EXPECT_THAT(fetch().data, ElementsAre(1, 0, 6, 0));
  server().receive(Bytes{0xFF, 0xFF, 0, 0, 0, 3}, kMailbox, true);
  EXPECT_THAT(fetch().data, ElementsAre(1, 0, 8, 0));
}

TEST_F(Server, RepeatedCounterIsNotExecutedTwice) {
  MailboxMessage message;
  message.counter = 3;
  message.data = coe::encode(coe::Request{coe::UploadRequest{{0x1000, 0}, false}});
  server().receive(message.encode(), kMailbox, true);
  server().receive(message.encode(), kMailbox, true);
  const auto answer = server().next(kMailbox);
  ASSERT_TRUE(answer);
  EXPECT_FALSE(server().next(kMailbox));
  EXPECT_EQ(server().repeat(false), *answer);
}

TEST_F(Server, RepeatGivesTheLostMessageAndThenTheOneThatWasLoaded) {
  server().queue_emergency({1, 1, {}});
  server().queue_emergency({2, 1, {}});
  const auto first = server().next(kMailbox);
  const auto second = server().next(kMailbox);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(server().repeat(true), *first);
  EXPECT_EQ(server().next(kMailbox), second);
}

/// Frames may get lost in front of the slave time after time: nothing was fetched, and the master cannot know.
TEST_F(Server, AskedAgainAndAgainItGivesNoMessageThatWasNone) {
  server().queue_emergency({1, 1, {}});
  EXPECT_EQ(server().next(kMailbox).has_value(), true);
  EXPECT_TRUE(server().repeat(true).empty()) << "the first one of all lies there still";
  EXPECT_FALSE(server().waiting());
  server().queue_emergency({2, 1, {}});
  const auto second = server().next(kMailbox);
  EXPECT_FALSE(server().repeat(true).empty());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(server().repeat(true).empty());
  EXPECT_EQ(server().next(kMailbox), second);
  EXPECT_FALSE(server().waiting());
}

TEST_F(Server, EmergencyIsDelivered) {
  server().queue_emergency({0xA000, 0x81, {0x1E, 0, 0, 0, 0}});
  const auto response = coe::decode_response(fetch().data);
  ASSERT_TRUE(response);
  EXPECT_EQ(std::get<coe::Emergency>(*response).error_code, 0xA000);
  for (int i = 0; i < 100; ++i) server().queue_emergency({1, 1, {}});
  int count = 0;
  while (server().next(kMailbox)) ++count;
  EXPECT_LE(count, 8) << "a device's memory is small";
}

TEST_F(Server, FilesAreWrittenAndReadPacketByPacket) {
  const auto file = [this](const foe::Message& message) {
    send(MailboxType::kFoe, foe::encode(message));
    return foe::decode(fetch().data).value();
  };
  const auto room = foe::data_capacity(kMailbox);
  EXPECT_EQ(std::get<foe::FileError>(file(foe::ReadRequest{0, "a.bin"})).code, foe::error::kNotFound);
  EXPECT_EQ(file(foe::WriteRequest{0, "a.bin"}), foe::Message(foe::Ack{0}));
  EXPECT_EQ(file(foe::Data{1, Bytes(room, 1)}), foe::Message(foe::Ack{1}));
  EXPECT_EQ(file(foe::Data{2, Bytes(room, 2)}), foe::Message(foe::Ack{2}));
  EXPECT_EQ(file(foe::Data{3, {}}), foe::Message(foe::Ack{3})) << "an exact multiple ends with an empty packet";
  EXPECT_EQ(std::get<foe::FileError>(file(foe::Data{4, {9}})).code, foe::error::kIllegal) << "it is written to its end";
  const auto first = std::get<foe::Data>(file(foe::ReadRequest{0, "a.bin"}));
  EXPECT_EQ(first.bytes, Bytes(room, 1));
  EXPECT_EQ(std::get<foe::Data>(file(foe::Ack{1})).bytes, Bytes(room, 2));
  EXPECT_TRUE(std::get<foe::Data>(file(foe::Ack{2})).bytes.empty());
  send(MailboxType::kFoe, foe::encode(foe::Ack{3}));
  EXPECT_FALSE(server().waiting());
  EXPECT_EQ(std::get<foe::FileError>(file(foe::Ack{3})).code, foe::error::kIllegal) << "it is read to its end";
  EXPECT_EQ(std::get<foe::FileError>(file(foe::Data{7, {}})).code, foe::error::kIllegal);
  (void)file(foe::WriteRequest{0, "b"});
  EXPECT_EQ(std::get<foe::FileError>(file(foe::Data{2, {}})).code, foe::error::kPacketNumber);
}

TEST(FileServerPassword, OpensOnlyWithTheRightOne) {
  FileServer server(0x1234);
  const auto refused = server.respond(foe::WriteRequest{1, "a"}, kMailbox);
  EXPECT_EQ(std::get<foe::FileError>(*refused).code, foe::error::kAccessDenied);
  EXPECT_EQ(server.respond(foe::WriteRequest{0x1234, "a"}, kMailbox), foe::Message(foe::Ack{0}));
}

TEST(DiagnosisHistory, RingsOverwritesAndIsAcknowledged) {
  ObjectDictionary dictionary;
  DiagnosisHistory history(dictionary);
  history.enable();
  const auto value = [&](std::uint8_t sub) { return dictionary.get<std::uint8_t>(0x10F3, sub); };
  history.add({0xA000E000, DiagnosisMessage::Type::kError, 1, 10, {}});
  EXPECT_EQ(value(2), 6);
  EXPECT_EQ(value(4), 1);
  const auto stored = DiagnosisMessage::decode(dictionary.find(0x10F3, 6)->value);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->time_stamp, 10U);
  const std::uint8_t six[] = {6};
  EXPECT_EQ(dictionary.write(0x10F3, 3, six, false), abort::kNone);
  EXPECT_EQ(value(4), 0) << "nothing new behind the acknowledged one";
  for (std::uint64_t i = 0; i < 9; ++i) history.add({1, DiagnosisMessage::Type::kInfo, 1, 100 + i, {}});
  EXPECT_EQ(DiagnosisMessage::decode(dictionary.find(0x10F3, value(2))->value)->time_stamp, 108U);
  EXPECT_NE(dictionary.get<std::uint16_t>(0x10F3, 5) & diagnosis_history::kOverwritten, 0);
  EXPECT_EQ(dictionary.write(0x10F3, 3, std::array{value(2)}, false), abort::kNone);
  EXPECT_EQ(value(4), 0);
  EXPECT_EQ(dictionary.get<std::uint16_t>(0x10F3, 5) & diagnosis_history::kOverwritten, 0) << "the loss is known";
  const std::uint8_t none[] = {0};
  EXPECT_EQ(dictionary.write(0x10F3, 3, none, false), abort::kNone);
  EXPECT_EQ(value(2), 0);
  EXPECT_EQ(dictionary.find(0x10F3, 6)->value, DiagnosisMessage{}.encode()) << "forgotten";
  history.add({1, DiagnosisMessage::Type::kInfo, 1, 200, {}});
  EXPECT_EQ(value(2), 6);
  const std::uint8_t wrong[] = {99};
  EXPECT_EQ(dictionary.write(0x10F3, 3, wrong, false), abort::kRange);
}

TEST(MailboxServerFuzz, AnyMessageIsAnsweredOrIgnored) {
  EXPECT_TRUE(rc::check("random messages", [](const Bytes& bytes, std::uint8_t type) {
    ObjectDictionary dictionary;
    dictionary.add<std::uint32_t>(0x1000, 0, "Device type", 1);
    MailboxDescription description;
    description.coe = CoeDescription{};
    description.coe->sdo_info = description.coe->complete_access = true;
    description.foe = true;
    MailboxServer server(dictionary, description, 0);
    server.receive(bytes, kMailbox, true);
    MailboxMessage message;
    message.type = static_cast<MailboxType>(type & 0x0F);
    message.data = bytes;
    server.receive(message.encode(), kMailbox, true);
    while (server.waiting()) (void)server.next(kMailbox);
  }));
}

TEST(PdoMappingBySdo, CompleteAccessChangesTheAssignment) {
  ObjectDictionary dictionary;
  dictionary.add<std::uint16_t>(0x6040, 0, "Controlword", 0, true);
  dictionary.add<std::uint32_t>(0x607A, 0, "Target position", 0, true);
  DeviceDescription device;
  device.mailbox = MailboxDescription{};
  device.mailbox->coe = CoeDescription{};
  device.mailbox->coe->pdo_assign = true;
  device.rx_pdos = {{0x1600, "First", 2, false, false, {}, {{0x6040, 0, 16, "", "UINT"}}},
                    {0x1601, "Second", std::nullopt, false, false, {}, {{0x607A, 0, 32, "", "DINT"}}}};
  PdoObjects pdos(device, dictionary, 16);
  EXPECT_EQ(pdos.byte_length(PdoDirection::kRx), 2U);
  const Bytes both{2, 0, 0x00, 0x16, 0x01, 0x16};
  EXPECT_EQ(write_complete(dictionary, {0x1C12, 0}, both, true), abort::kNone);
  EXPECT_EQ(pdos.byte_length(PdoDirection::kRx), 6U);
  EXPECT_EQ(write_complete(dictionary, {0x1C12, 0}, both, false), abort::kDeviceState);
}

}  // namespace
}  // namespace syncline::sim
