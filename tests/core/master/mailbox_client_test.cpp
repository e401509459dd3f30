// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/mailbox_client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <numeric>

#include "master/mailbox/coe_client.h"
#include "master/mailbox/foe_client.h"
#include "master/mailbox/mailbox_transfer.h"
#include "master/mailbox/sdo_info_client.h"
#include "protocol/foe.h"
#include "support/random.h"
#include "tests/core/master/mailbox_bed.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;
using Messages = std::vector<MailboxMessage>;

Bytes counted(std::size_t size) {
  Bytes bytes(size);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
  return bytes;
}

/// An honest server of one object and one file; announces its emergencies in front of its answers.
struct Server {
  std::size_t mailbox = 128;
  Bytes object, file;
  std::size_t position = 0;
  std::uint32_t packet = 0;
  std::string name;

  Messages operator()(const MailboxMessage& message) {
    if (message.type == MailboxType::kFoe) return foe(*foe::decode(message.data));
    if (*coe::service_of(message.data) == coe::Service::kSdoInformation)
      return info(*coe::decode_information_request(message.data));
    return std::visit([this](const auto& r) { return sdo(r); }, *coe::decode_request(message.data));
  }
  Messages sdo(const coe::UploadRequest& r) {
    position = std::min(object.size(), object.size() <= 4 ? 4 : coe::first_message_capacity(mailbox));
    return {coe_message(coe::Emergency{0x1234, 1, {}}),
            coe_message(coe::UploadResponse{r.object,
                                            r.complete_access,
                                            object.size() <= 4 && !object.empty(),
                                            static_cast<std::uint32_t>(object.size()),
                                            {object.begin(), object.begin() + static_cast<std::ptrdiff_t>(position)}})};
  }
  Messages sdo(const coe::UploadSegmentRequest& r) {
    const auto size = std::min(object.size() - position, coe::segment_capacity(mailbox));
    const auto begin = object.begin() + static_cast<std::ptrdiff_t>(position);
    position += size;
    return {coe_message(coe::UploadSegmentResponse{
        r.toggle, position == object.size(), {begin, begin + static_cast<std::ptrdiff_t>(size)}})};
  }
  Messages sdo(const coe::DownloadRequest& r) {
    object = r.data;
    return {coe_message(coe::DownloadResponse{r.object})};
  }
  Messages sdo(const coe::DownloadSegmentRequest& r) {
    object.insert(object.end(), r.data.begin(), r.data.end());
    return {coe_message(coe::DownloadSegmentResponse{r.toggle})};
  }
  Messages sdo(const coe::Abort&) { return {}; }
  Messages info(const coe::InformationRequest& request) {
    coe::InformationResponse response;
    if (std::holds_alternative<coe::ObjectListRequest>(request)) {
      coe::ObjectList list;
      for (std::uint16_t i = 0; i < 300; ++i) list.indices.push_back(static_cast<std::uint16_t>(0x2000 + i));
      response = list;
    } else if (const auto* object_request = std::get_if<coe::ObjectDescriptionRequest>(&request)) {
      response = coe::ObjectDescription{object_request->index, 5, 3, coe::ObjectCode::kRecord, "Record"};
    } else {
      response = coe::InformationError{0x06090011};
    }
    Messages messages;
    for (auto& part : coe::encode(response, mailbox))
      messages.push_back(message_of(MailboxType::kCoe, std::move(part)));
    return messages;
  }
  Messages foe(const foe::Message& message) {
    const auto reply = [](const foe::Message& m) { return Messages{message_of(MailboxType::kFoe, foe::encode(m))}; };
    if (const auto* read = std::get_if<foe::ReadRequest>(&message)) {
      if (read->name != "file") return reply(foe::FileError{foe::error::kNotFound, "no such file"});
      packet = 0;
      return reply(next_packet());
    }
    if (std::holds_alternative<foe::Ack>(message)) {
      if (packet * foe::data_capacity(mailbox) > file.size()) return {};
      return reply(next_packet());
    }
    if (const auto* write = std::get_if<foe::WriteRequest>(&message)) {
      name = write->name;
      file.clear();
      packet = 0;
      return reply(foe::Ack{0});
    }
    const auto& data = std::get<foe::Data>(message);
    if (data.packet_no == 2 && packet == 1) {
      packet = 100;  // erasing flash: once
      return reply(foe::Busy{1, 2, "erasing"});
    }
    packet = data.packet_no;
    file.insert(file.end(), data.bytes.begin(), data.bytes.end());
    return reply(foe::Ack{data.packet_no});
  }
  foe::Message next_packet() {
    const auto full = foe::data_capacity(mailbox);
    const auto begin = std::min(file.size(), packet * full), end = std::min(file.size(), begin + full);
    return foe::Data{
        ++packet, {file.begin() + static_cast<std::ptrdiff_t>(begin), file.begin() + static_cast<std::ptrdiff_t>(end)}};
  }
};

class MailboxLoss : public testing::TestWithParam<double> {};

TEST_P(MailboxLoss, NeverAbortsATransferNorDamagesIt) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MailboxBed bed(GetParam(), 128, seed);
    Server server;
    bed.slave->handler = [&](const MailboxMessage& m) { return server(m); };
    CoeClient coe(*bed.client);
    FoeClient foe(*bed.client);
    SdoInfoClient info(*bed.client);
    const auto big = counted(3000);
    const auto written = coe.download({0x2000, 0}, big, true);
    ASSERT_TRUE(written) << written.error().detail.text();
    EXPECT_EQ(server.object, big);
    const auto read = coe.upload({0x2000, 0}, true);
    ASSERT_TRUE(read) << read.error().detail.text();
    EXPECT_EQ(*read, big);
    const auto list = info.object_list();
    ASSERT_TRUE(list) << list.error().detail.text();
    EXPECT_EQ(list->size(), 300U);
    const auto sent = foe.write("name", big);
    ASSERT_TRUE(sent) << sent.error().detail.text();
    EXPECT_EQ(server.file, big);
    const auto fetched = foe.read("file");
    ASSERT_TRUE(fetched) << fetched.error().detail.text();
    EXPECT_EQ(*fetched, big);
    EXPECT_EQ(bed.emergencies.size(), 1U) << "each emergency once";
    if (GetParam() >= 0.05) {
      EXPECT_GT(bed.slave->repeats, 0U);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Percent, MailboxLoss, testing::Values(0.0, 0.01, 0.05, 0.1));

TEST(MailboxClient, AsksASlaveAnewThatCannotRepeatWhatWasLost) {
  for (const bool acknowledges : {true, false}) {
    MailboxBed bed(0.1, 128, 7);
    bed.slave->answers_repeats = acknowledges;
    bed.slave->has_repeats = false;
    Server server;
    server.object = {1, 2};
    bed.slave->handler = [&](const MailboxMessage& m) { return server(m); };
    CoeClient coe(*bed.client);
    constexpr int kTransfers = 100;
    for (int i = 0; i < kTransfers; ++i) {
      const auto read = coe.upload({0x2000, 1});
      ASSERT_TRUE(read) << i << ": " << read.error().detail.text();
      EXPECT_EQ(*read, (Bytes{1, 2}));
    }
    EXPECT_GT(bed.slave->requests, kTransfers + 3U) << "some were asked for twice";
    EXPECT_LT(bed.elapsed(), 10 * kSecond) << "without waiting for the slave's time-out";
  }
}

TEST(MailboxTransfer, KnowsNothingOfTheSlaveBefore) {
  MailboxBed bed;
  bed.slave->handler = Server{};
  MailboxTransfer transfer(bed.mailbox);
  transfer.ask(MailboxType::kCoe, coe::encode(coe::UploadRequest{{0x1018, 1}, false}), bed.clock.now());
  while (!transfer.over()) {
    if (auto* datagram = transfer.next(bed.clock.now())) {
      ASSERT_TRUE(bed.bus->transact(*datagram));
    } else {
      ASSERT_TRUE(bed.bus->wait_a_little());
    }
    transfer.take(bed.clock.now());
  }
  ASSERT_FALSE(transfer.data().empty());
  transfer.use(bed.mailbox);
  EXPECT_TRUE(transfer.data().empty());
}

TEST(MailboxClient, NamesAMailboxErrorInWords) {
  MailboxBed bed;
  bed.slave->handler = [](const MailboxMessage&) {
    return Messages{message_of(MailboxType::kError, MailboxError{MailboxErrorDetail::kUnsupportedProtocol}.encode())};
  };
  const auto read = FoeClient(*bed.client).read("file");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kMailboxProtocol);
  EXPECT_THAT(read.error().detail.text(), HasSubstr("does not support this protocol"));
}

TEST(MailboxClient, SilenceEndsInATimeout) {
  MailboxBed bed;
  bed.slave->handler = [](const MailboxMessage&) { return Messages{}; };
  const auto read = CoeClient(*bed.client).upload({0x1018, 1});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kMailboxTimeout);
  EXPECT_LT(bed.elapsed(), 3 * kSecond);
}

TEST(MailboxClient, EmergenciesWithoutEndAreNoAnswer) {
  MailboxBed bed;
  bed.slave->handler = [](const MailboxMessage&) { return Messages(500, coe_message(coe::Emergency{1, 2, {}})); };
  const auto read = CoeClient(*bed.client).upload({0x1018, 1});
  ASSERT_FALSE(read);
  EXPECT_LE(bed.emergencies.size(), 65U);
}

/// What lies there without having been asked for, until there is nothing more.
TEST(MailboxClient, CollectsWhatLiesInTheMailbox) {
  MailboxBed bed;
  bed.slave->handler = [](const MailboxMessage&) {
    return Messages{coe_message(coe::DownloadResponse{{0x2000, 0}}), coe_message(coe::Emergency{0x1000, 1, {}}),
                    coe_message(coe::Emergency{0x2000, 1, {}})};
  };
  ASSERT_TRUE(CoeClient(*bed.client).download({0x2000, 0}, Bytes(2, 1)));
  EXPECT_TRUE(bed.emergencies.empty());
  ASSERT_TRUE(bed.client->collect());
  ASSERT_EQ(bed.emergencies.size(), 2U);
  EXPECT_EQ(bed.emergencies[1].error_code, 0x2000);
  const auto sent = bed.link->injected().sent;
  ASSERT_TRUE(bed.client->collect());
  EXPECT_EQ(bed.link->injected().sent, sent + 1) << "a look at the SyncManager's status";
}

TEST(MailboxClient, TheProcessImagesBitSavesThePolling) {
  MailboxBed bed;
  Server server;
  server.object = {1, 2};
  bool full = false;
  bed.slave->handler = [&](const MailboxMessage& m) {
    full = true;
    return server(m);
  };
  bed.mailbox.port.full = [&]() -> std::optional<bool> { return full; };
  bed.mailbox.counter = 3;
  const auto read = CoeClient(*bed.client).upload({0x2000, 1});
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, (Bytes{1, 2}));
}

TEST(CoeClient, ALateAnswerToAGivenUpRequestIsPassedOver) {
  MailboxBed bed;
  bed.slave->handler = [](const MailboxMessage&) {
    return Messages{coe_message(coe::UploadResponse{{0x1000, 0}, false, true, 1, {9}}),
                    coe_message(coe::UploadResponse{{0x1018, 1}, false, true, 1, {7}})};
  };
  const auto read = CoeClient(*bed.client).upload({0x1018, 1});
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, Bytes{7});
}

/// What a slave does to a reader of 0x2000:00 and what the reader says.
struct Lie {
  const char* name;
  std::function<coe::Response(const coe::Request&)> answer;
  const char* says;
};
coe::Response announce(std::uint32_t size) {
  return coe::UploadResponse{{0x2000, 0}, false, false, size, {1, 2, 3, 4, 5}};
}
bool first(const coe::Request& request) { return std::holds_alternative<coe::UploadRequest>(request); }

TEST(CoeClient, HostileUploadsEndWithAClearError) {
  const std::vector<Lie> lies{
      {"endless",
       [](const auto& r) {
         if (first(r)) return announce(100'000);
         return coe::Response(coe::UploadSegmentResponse{std::get<coe::UploadSegmentRequest>(r).toggle, false, {}});
       },
       "empty segment"},
      {"too much",
       [](const auto& r) {
         if (first(r)) return announce(20);
         return coe::Response(
             coe::UploadSegmentResponse{std::get<coe::UploadSegmentRequest>(r).toggle, false, Bytes(50)});
       },
       "more than the 20 bytes"},
      {"too little",
       [](const auto& r) {
         if (first(r)) return announce(200);
         return coe::Response(
             coe::UploadSegmentResponse{std::get<coe::UploadSegmentRequest>(r).toggle, true, Bytes(8)});
       },
       "13 bytes where 200"},
      {"toggle",
       [](const auto& r) {
         if (first(r)) return announce(200);
         return coe::Response(coe::UploadSegmentResponse{true, false, Bytes(8)});
       },
       "toggle"},
      {"huge", [](const auto&) { return announce(0xFFFF'FFFF); }, "announces 4294967295"},
      {"other service",
       [](const auto& r) {
         if (first(r)) return announce(200);
         return coe::Response(coe::DownloadSegmentResponse{false});
       },
       "another request"},
  };
  for (const auto& lie : lies) {
    MailboxBed bed;
    bed.slave->handler = [&](const MailboxMessage& m) {
      const auto request = *coe::decode_request(m.data);
      if (std::holds_alternative<coe::Abort>(request)) return Messages{};
      return Messages{coe_message(lie.answer(request))};
    };
    const auto read = CoeClient(*bed.client).upload({0x2000, 0});
    ASSERT_FALSE(read) << lie.name;
    EXPECT_EQ(read.error().code, ErrorCode::kMailboxProtocol) << lie.name;
    EXPECT_THAT(read.error().detail.text(), HasSubstr(lie.says)) << lie.name;
  }
}

TEST(SdoInfoClient, AbortAndBrokenFragmentsAreErrors) {
  MailboxBed bed;
  Server server;
  bed.slave->handler = [&](const MailboxMessage& m) { return server(m); };
  SdoInfoClient info(*bed.client);
  EXPECT_EQ(info.object(0x2000)->name, "Record");
  const auto entry = info.entry(0x2000, 9);
  ASSERT_FALSE(entry);
  EXPECT_EQ(entry.error().code, ErrorCode::kSdoAbort);
  EXPECT_EQ(entry.error().received, 0x06090011);

  bed.slave->handler = [](const MailboxMessage&) {  // says "two to come" for ever
    auto part =
        coe::encode(coe::InformationResponse(coe::ObjectList{coe::ObjectListType::kAll, {0x1000}}), 128).front();
    part[4] = 2;
    return Messages(5, message_of(MailboxType::kCoe, part));
  };
  const auto list = info.object_list();
  ASSERT_FALSE(list);
  EXPECT_THAT(list.error().detail.text(), HasSubstr("fragments"));
}

TEST(FoeClient, TheSlavesErrorKeepsItsWords) {
  MailboxBed bed;
  Server server;
  bed.slave->handler = [&](const MailboxMessage& m) { return server(m); };
  const auto read = FoeClient(*bed.client).read("other");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kFileTransfer);
  EXPECT_EQ(read.error().received, 0x8001);
  EXPECT_EQ(read.error().detail.text(), "no such file");
}

TEST(FoeClient, AFileThatFillsItsLastPacketIsEndedByAnEmptyOne) {
  for (const std::size_t size :
       {std::size_t{0}, foe::data_capacity(128), 2 * foe::data_capacity(128), std::size_t{1}}) {
    MailboxBed bed;
    Server server;
    bed.slave->handler = [&](const MailboxMessage& m) { return server(m); };
    FoeClient foe(*bed.client);
    ASSERT_TRUE(foe.write("x", counted(size)));
    EXPECT_EQ(server.file, counted(size));
    const auto back = foe.read("file");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->size(), size);
  }
}

/// Whatever comes out of the mailbox: an end, and no byte from beyond it (the sanitizers watch).
TEST(MailboxClient, RandomAnswersEndInAResult) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    MailboxBed bed;
    Random random(seed);
    bed.slave->handler = [&](const MailboxMessage& request) {
      Messages messages;
      const auto count = random.next() % 3;
      for (std::uint64_t i = 0; i <= count; ++i) {
        auto data = Bytes(random.next() % 120);
        for (auto& byte : data) byte = static_cast<std::uint8_t>(random.next());
        // Often the right service, so that its decoder is reached.
        if (data.size() > 2 && request.type == MailboxType::kCoe && random.next() % 4 != 0) {
          data[0] = 0;
          data[1] = static_cast<std::uint8_t>(random.next() % 2 == 0 ? 0x30 : 0x80);
        } else if (!data.empty() && request.type == MailboxType::kFoe) {
          data[0] = static_cast<std::uint8_t>(random.next() % 7);
        }
        messages.push_back(
            message_of(random.next() % 5 == 0 ? static_cast<MailboxType>(random.next() % 16) : request.type, data));
      }
      return messages;
    };
    (void)CoeClient(*bed.client).upload({0x1008, 0});
    (void)CoeClient(*bed.client).download({0x2000, 0}, counted(400), true);
    (void)SdoInfoClient(*bed.client).object_list();
    (void)SdoInfoClient(*bed.client).entry(0x1018, 1);
    (void)FoeClient(*bed.client).read("file");
    (void)FoeClient(*bed.client).write("file", counted(300));
    RC_ASSERT(bed.elapsed() < 600 * kSecond);
  }));
}

}  // namespace
}  // namespace syncline::test
