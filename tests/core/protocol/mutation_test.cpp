// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "byte_helpers.h"
#include "protocol/coe.h"
#include "protocol/diagnosis_message.h"
#include "protocol/eoe.h"
#include "protocol/foe.h"
#include "protocol/frame.h"
#include "protocol/mailbox.h"
#include "protocol/sdo_information.h"
#include "protocol/sii.h"
#include "support/random.h"

namespace syncline {
namespace {

using test::Bytes;
using test::from_hex;

/// Good messages with a few bytes changed, cut off or doubled: further into a parser than random bytes come. The
/// sanitizers watch what it reads.
template <class Parse>
void mutate(const std::vector<Bytes>& corpus, std::uint64_t seed, int rounds, Parse parse) {
  Random random(seed);
  for (const auto& good : corpus) {
    parse(good);
    for (int i = 0; i < rounds; ++i) {
      auto bytes = good;
      for (auto changes = random.next() % 4 + 1; changes > 0 && !bytes.empty(); --changes) {
        auto& byte = bytes[random.next() % bytes.size()];
        byte = random.next() % 3 == 0 ? std::uint8_t{0xFF} : static_cast<std::uint8_t>(random.next());
      }
      if (random.next() % 3 == 0) bytes.resize(random.next() % (bytes.size() + 1));
      if (random.next() % 5 == 0) bytes.insert(bytes.end(), good.begin(), good.end());
      bytes.shrink_to_fit();  // a read beyond the end leaves the allocation
      parse(bytes);
    }
  }
}

void parse_mailbox(const Bytes& bytes) {
  const auto message = MailboxMessage::decode(bytes);
  if (!message) return;
  const auto& data = message->data;
  ASSERT_LE(data.size() + MailboxMessage::kHeaderSize, bytes.size());
  (void)MailboxError::decode(data);
  (void)coe::decode_request(data);
  (void)coe::decode_response(data);
  (void)coe::decode_information_request(data);
  if (const auto part = coe::decode_information_fragment(data)) {
    (void)coe::decode_information_response(part->opcode, part->data);
  }
  (void)foe::decode(data);
  (void)eoe::decode(data);
  (void)DiagnosisMessage::decode(data);
}

TEST(Mutations, MailboxMessages) {
  coe::EntryDescription entry{0x1018, 1, coe::value_info::kDefault, 7, 32, 7, 0, {1, 2, 3, 4}, {}, {}, "Vendor ID"};
  const std::vector<std::pair<MailboxType, Bytes>> good{
      {MailboxType::kCoe, coe::encode(coe::Request(coe::DownloadRequest{{0x1C12, 0}, true, false, 6, Bytes(6, 1)}))},
      {MailboxType::kCoe, coe::encode(coe::Request(coe::DownloadSegmentRequest{true, true, Bytes(3, 7)}))},
      {MailboxType::kCoe, coe::encode(coe::Response(coe::UploadResponse{{0x1008, 0}, false, false, 300, Bytes(40, 65)}))},
      {MailboxType::kCoe, coe::encode(coe::Response(coe::UploadSegmentResponse{true, true, Bytes(5, 65)}))},
      {MailboxType::kCoe, coe::encode(coe::Response(coe::Emergency{0xA001, 0x11, {1, 2, 3, 4, 5}}))},
      {MailboxType::kCoe, coe::encode(coe::InformationResponse(entry), 128).front()},
      {MailboxType::kCoe, coe::encode(coe::InformationResponse(coe::ObjectList{coe::ObjectListType::kAll, {0x1000, 0x1018}}), 128).front()},
      {MailboxType::kFoe, foe::encode(foe::Data{1, Bytes(20, 3)})},
      {MailboxType::kFoe, foe::encode(foe::FileError{0x8001, "no"})},
      {MailboxType::kCoe, DiagnosisMessage{0xE000'0001, DiagnosisMessage::Type::kError, 7, 42, {{5, {1}}, {0x1003, {1, 2, 3}}}}.encode()},
  };
  std::vector<Bytes> corpus;
  for (const auto& [type, data] : good) {
    MailboxMessage message;
    message.type = type;
    message.counter = 3;
    message.data = data;
    corpus.push_back(message.encode());
  }
  mutate(corpus, 1, 2000, parse_mailbox);
}

TEST(Mutations, SiiImages) {
  sii::Image image;
  image.size_bytes = 512;
  image.general = sii::General{"group", "image", "order", "name", 0x2F, 0, 0, 0, 0, 0x1111, 0};
  image.fmmus = {1, 2, 3};
  image.sync_managers = {{0x1000, 128, 0x26, 0, 1, 1}, {0x1080, 128, 0x22, 0, 1, 2}};
  image.rx_pdos = {{0x1600, 2, 0, "outputs", 0, {{0x7000, 1, "value", 6, 16, 0}}}};
  mutate({sii::encode(image)}, 2, 4000, [](const Bytes& bytes) { (void)sii::decode(bytes); });
}

TEST(Mutations, Frames) {
  // BRD of 2 bytes, then FPRD of 4 in the same frame, with padding.
  auto frame = from_hex("FFFFFFFFFFFF 020000000001 88A4 1E10  0701 0000 3001 0280 0000 0000 0000  0402 E903 1009 0400 0000 00000000 0000");
  frame.resize(60);
  mutate({frame}, 3, 8000, [](const Bytes& good) {
    auto bytes = good;
    FrameReader reader(bytes);
    std::size_t total = 0;
    while (const auto datagram = reader.next()) {
      total += datagram->data.size();
      ASSERT_LE(total, bytes.size());
      for (const auto byte : datagram->data) total += byte & 0U;
      (void)datagram->wkc();
    }
  });
}

}  // namespace
}  // namespace syncline
