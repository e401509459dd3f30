// SPDX-License-Identifier: Apache-2.0
#include "fuzz/wire_targets.h"

#include <array>
#include <string_view>

#include "capture/pcap_reader.h"
#include "capture/recorded_bus.h"
#include "protocol/coe.h"
#include "protocol/diagnosis_message.h"
#include "protocol/diagnosis_text.h"
#include "protocol/eoe.h"
#include "protocol/foe.h"
#include "protocol/frame.h"
#include "protocol/mailbox.h"
#include "protocol/registers.h"
#include "protocol/sdo_information.h"
#include "protocol/sii.h"
#include "sim/mailbox/mailbox_server.h"
#include "support/byte_order.h"

namespace syncline::fuzz {

// ---- frames --------------------------------------------------------------------------------------

void run_frame(std::span<const std::uint8_t> given) {
  Bytes bytes(given.begin(), given.end());
  FrameReader reader(bytes);
  std::size_t total = 0;
  while (const auto datagram = reader.next()) {
    total += datagram->data.size();
    promise(total <= bytes.size());
    for (const auto byte : datagram->data) total += byte & 0U;
    (void)datagram->wkc();
  }
  BusRecorder recorder;
  for (int twice = 0; twice < 2; ++twice) {
    recorder.add(bytes);
    if (bytes.size() > 6) bytes[6] |= 0x02;  // as it comes back
  }
}

std::vector<Bytes> frames() {
  FrameBuilder builder;
  const std::array<std::uint8_t, 6> master{0x02, 0, 0, 0, 0, 1}, broadcast{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  builder.set_addresses(broadcast, master);
  (void)builder.add_zeros(Command::kBrd, 7, device_address(0, reg::kAlStatus), 2);
  (void)builder.add_zeros(Command::kFprd, 7, device_address(1001, reg::kSystemTime), 4);
  (void)builder.add_zeros(Command::kLrw, 7, 0x1000, 40);
  const auto frame = builder.finish();
  return {{frame.begin(), frame.end()}};
}

// ---- EEPROMs -------------------------------------------------------------------------------------

void run_sii(std::span<const std::uint8_t> bytes) { (void)sii::decode(bytes); }

std::vector<Bytes> siis() {
  sii::Image image;
  image.size_bytes = 512;
  image.general = sii::General{"group", "image", "order", "name", 0x2F, 0, 0, 0, 0, 0x1111, 0};
  image.fmmus = {1, 2, 3};
  image.sync_managers = {{0x1000, 128, 0x26, 0, 1, 1}, {0x1080, 128, 0x22, 0, 1, 2}};
  image.rx_pdos = {{0x1600, 2, 0, "outputs", 0, {{0x7000, 1, "value", 6, 16, 0}}}};
  return {sii::encode(image)};
}

// ---- mailboxes -----------------------------------------------------------------------------------

namespace {

void run_decoders(std::span<const std::uint8_t> data) {
  (void)MailboxError::decode(data);
  (void)coe::decode_request(data);
  (void)coe::decode_response(data);
  (void)coe::decode_information_request(data);
  if (const auto part = coe::decode_information_fragment(data)) {
    (void)coe::decode_information_response(part->opcode, part->data);
  }
  (void)foe::decode(data);
  (void)eoe::decode(data);
  if (const auto message = DiagnosisMessage::decode(data)) {
    (void)raw_diagnosis_text(*message);
    (void)diagnosis_text("%5d %-3u %#06x %s %.2f %c %lo %%", *message);
    const std::string_view text(reinterpret_cast<const char*>(data.data()), data.size());
    (void)diagnosis_text(text, *message);
  }
}

}  // namespace

void run_mailbox(std::span<const std::uint8_t> bytes) {
  const auto message = MailboxMessage::decode(bytes);
  if (message) {
    promise(message->data.size() + MailboxMessage::kHeaderSize <= bytes.size());
    run_decoders(message->data);
  }
  sim::ObjectDictionary dictionary;
  dictionary.add<std::uint32_t>(0x1000, 0, "Device type", 1);
  dictionary.add<std::uint8_t>(0x1C12, 0, "Assigned PDOs", 1, true);
  dictionary.add<std::uint16_t>(0x1C12, 1, "Assigned PDO", 0x1600, true);
  MailboxDescription description;
  description.coe = CoeDescription{};
  description.coe->sdo_info = description.coe->complete_access = true;
  description.foe = true;
  sim::MailboxServer server(dictionary, description, 0);
  server.receive(bytes, 64, true);
  for (int answers = 0; server.waiting(); ++answers) {
    promise(answers < 1'000);
    const auto answer = server.next(64);
    promise(!answer || MailboxMessage::decode(*answer).has_value());
  }
}

std::vector<Bytes> mailboxes() {
  const coe::EntryDescription entry{0x1018, 1,          coe::value_info::kDefault, 7, 32, 7, 0, {1, 2, 3, 4}, {},
                                    {},     "Vendor ID"};
  const coe::ObjectList list{coe::ObjectListType::kAll, {0x1000, 0x1018}};
  const std::vector<std::pair<MailboxType, Bytes>> good{
      {MailboxType::kCoe, coe::encode(coe::Request(coe::DownloadRequest{{0x1C12, 0}, true, false, 6, Bytes(6, 1)}))},
      {MailboxType::kCoe, coe::encode(coe::Request(coe::DownloadSegmentRequest{true, true, Bytes(3, 7)}))},
      {MailboxType::kCoe, coe::encode(coe::Request(coe::UploadRequest{{0x1000, 0}, false}))},
      {MailboxType::kCoe,
       coe::encode(coe::Response(coe::UploadResponse{{0x1008, 0}, false, false, 300, Bytes(40, 65)}))},
      {MailboxType::kCoe, coe::encode(coe::Response(coe::UploadSegmentResponse{true, true, Bytes(5, 65)}))},
      {MailboxType::kCoe, coe::encode(coe::Response(coe::Emergency{0xA001, 0x11, {1, 2, 3, 4, 5}}))},
      {MailboxType::kCoe, coe::encode(coe::InformationRequest(coe::ObjectListRequest{}))},
      {MailboxType::kCoe, coe::encode(coe::InformationResponse(entry), 128).front()},
      {MailboxType::kCoe, coe::encode(coe::InformationResponse(list), 128).front()},
      {MailboxType::kFoe, foe::encode(foe::WriteRequest{0, "name"})},
      {MailboxType::kFoe, foe::encode(foe::Data{1, Bytes(20, 3)})},
      {MailboxType::kFoe, foe::encode(foe::FileError{0x8001, "no"})},
      {MailboxType::kCoe,
       DiagnosisMessage{0xE0000001, DiagnosisMessage::Type::kError, 7, 42, {{5, {1}}, {0x1003, {1, 2, 3}}}}.encode()},
  };
  std::vector<Bytes> corpus;
  for (const auto& [type, data] : good) {
    MailboxMessage message;
    message.type = type;
    message.counter = 3;
    message.data = data;
    corpus.push_back(message.encode());
  }
  return corpus;
}

// ---- captures ------------------------------------------------------------------------------------

void run_pcap(std::span<const std::uint8_t> bytes) {
  auto reader = PcapReader::from_memory(bytes, "fuzz");
  if (!reader) return;
  BusRecorder recorder;
  for (auto frame = reader->next(); frame && *frame; frame = reader->next()) {
    promise((*frame)->bytes.size() <= bytes.size());
    recorder.add((*frame)->bytes);
  }
}

/// The classic format by hand: file header, then each frame behind its record header.
std::vector<Bytes> captures() {
  Bytes file;
  ByteWriter out(file);
  out.u32(0xA1B2C3D4).u16(2).u16(4).u32(0).u32(0).u32(65'535).u32(1);
  for (const auto& frame : frames()) {
    for (int twice = 0; twice < 2; ++twice) {
      out.u32(1'700'000'000).u32(0);
      out.u32(static_cast<std::uint32_t>(frame.size())).u32(static_cast<std::uint32_t>(frame.size())).bytes(frame);
    }
  }
  return {file};
}

}  // namespace syncline::fuzz
