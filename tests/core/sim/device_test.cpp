// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "protocol/coe.h"
#include "protocol/mailbox.h"
#include "sim/device/device_objects.h"
#include "sim/mailbox/complete_access.h"
#include "sim/objects/object_dictionary.h"
#include "tests/core/sim/sim_probe.h"

namespace syncline::test {
namespace {

/// A servo alone on the bus with its mailbox set up.
class SimServo : public testing::Test {
 protected:
  SimServo() : probe(line({sim_slave("SL-SV7", "servo-y")})) {
    probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
    probe.set_sync_manager(0, 1, 0x1080, 128, 0x22);
  }

  std::optional<coe::Response> sdo(const coe::Request& request) {
    MailboxMessage mail;
    mail.counter = counter = next_mailbox_counter(counter);
    mail.data = coe::encode(request);
    EXPECT_EQ(probe.write(0, mailbox_out, mail.encode(128)).wkc, 1);
    for (;;) {
      probe.pass(kMillisecond);
      const auto reply = probe.read(0, mailbox_in, 128);
      if (reply.wkc == 0) return std::nullopt;
      const auto decoded = MailboxMessage::decode(reply.data);
      if (!decoded) return std::nullopt;
      const auto response = coe::decode_response(decoded->data);
      if (!response) return std::nullopt;
      if (!std::holds_alternative<coe::Emergency>(*response)) return *response;
      emergencies.push_back(std::get<coe::Emergency>(*response));  // they come in between
    }
  }
  std::uint32_t read_object(std::uint16_t index, std::uint8_t sub) {
    const auto response = sdo(coe::UploadRequest{{index, sub}, false});
    if (!response || !std::holds_alternative<coe::UploadResponse>(*response)) return 0xDEADBEEF;
    auto data = std::get<coe::UploadResponse>(*response).data;
    data.resize(4);
    return load_le<std::uint32_t>(data);
  }
  std::uint32_t write_object(std::uint16_t index, std::uint8_t sub, std::vector<std::uint8_t> data) {
    const auto size = static_cast<std::uint32_t>(data.size());
    const auto response = sdo(coe::DownloadRequest{{index, sub}, false, true, size, std::move(data)});
    if (!response) return 1;
    const auto* abort = std::get_if<coe::Abort>(&*response);
    return abort == nullptr ? 0 : abort->code;
  }
  /// SM2/SM3 as the default assignment wants them, and SAFEOP.
  std::uint16_t to_safeop() {
    probe.set_sync_manager(0, 2, 0x1100, 16, 0x64);
    probe.set_sync_manager(0, 3, 0x1400, 20, 0x20);
    return probe.request(0, 4);
  }
  void write_outputs() { probe.write(0, 0x1100, std::vector<std::uint8_t>(16)); }
  /// SYNC0 every millisecond from 5 ms on.
  void start_sync0(std::uint32_t cycle = 1'000'000) {
    const auto now = probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>();
    first_sync = now + 5 * kMillisecond;
    probe.write(0, reg::kSync0CycleTime, le_bytes(cycle));
    probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(first_sync));
    probe.write(0, reg::kCyclicUnitControl, {0x00, 0x03});
  }

  SimProbe probe;
  std::uint16_t mailbox_out = 0x1000, mailbox_in = 0x1080;
  std::uint8_t counter = 0;
  std::uint64_t first_sync = 0;
  std::vector<coe::Emergency> emergencies;
};

TEST_F(SimServo, RefusesStatesForTheReasonsThatTheCodesName) {
  EXPECT_EQ(probe.request(0, 8), 0x11);
  EXPECT_EQ(probe.al_code(0), 0x0011) << "INIT -> OP skips states";
  EXPECT_EQ(probe.request(0, 2), 0x11) << "nothing is executed before the acknowledgement";
  EXPECT_EQ(probe.request(0, 0x11), 0x01);
  probe.set_sync_manager(0, 1, 0x1090, 128, 0x22);
  EXPECT_EQ(probe.request(0, 2), 0x11);
  EXPECT_EQ(probe.al_code(0), 0x0016);
  probe.set_sync_manager(0, 1, 0x1080, 128, 0x22);
  EXPECT_EQ(probe.request(0, 0x12), 0x02);
  probe.set_sync_manager(0, 2, 0x1100, 15, 0x64);
  probe.set_sync_manager(0, 3, 0x1400, 20, 0x20);
  EXPECT_EQ(probe.request(0, 4), 0x12);
  EXPECT_EQ(probe.al_code(0), 0x001D) << "output length differs from the assigned PDOs";
  EXPECT_EQ(probe.request(0, 0x12), 0x02);
  EXPECT_EQ(to_safeop(), 0x04);
  EXPECT_EQ(probe.request(0, 8), 0x14);
  EXPECT_EQ(probe.al_code(0), 0x0019) << "no outputs yet";
}

TEST_F(SimServo, RepeatRequestBringsTheAnswerAgain) {
  ASSERT_EQ(probe.request(0, 2), 2);
  EXPECT_EQ(read_object(0x1018, 1), 0x5C17U);
  // The frame with the answer was lost: the mailbox is empty, the master toggles 0x080E bit 1.
  EXPECT_EQ(probe.read(0, mailbox_in, 128).wkc, 0);
  EXPECT_EQ(probe.write(0, reg::kSyncManager + 8 + 6, {0x03}).wkc, 1);
  probe.pass(kMillisecond);
  EXPECT_EQ(probe.read(0, reg::kSyncManager + 8 + 7, 1).data[0] & 0x02, 0x02) << "acknowledged";
  const auto again = probe.read(0, mailbox_in, 128);
  EXPECT_EQ(again.wkc, 1);
  const auto mail = MailboxMessage::decode(again.data);
  ASSERT_TRUE(mail);
  const auto response = coe::decode_response(mail->data);
  ASSERT_TRUE(response);
  EXPECT_EQ(std::get<coe::UploadResponse>(*response).data, (std::vector<std::uint8_t>{0x17, 0x5C, 0, 0}));
}

TEST_F(SimServo, AnswersSdosAndAborts) {
  ASSERT_EQ(probe.request(0, 2), 2);
  EXPECT_EQ(read_object(0x1018, 1), 0x5C17U);
  for (std::uint8_t sm = 0; sm < 4; ++sm) EXPECT_EQ(read_object(0x1C00, static_cast<std::uint8_t>(sm + 1)), sm + 1U);
  EXPECT_EQ(read_object(0x10F1, 2), 9U);
  EXPECT_EQ(write_object(0x10F1, 2, {12, 0}), 0U);
  EXPECT_EQ(read_object(0x10F1, 2), 12U);
  EXPECT_EQ(write_object(0x10F1, 2, {16, 0}), 0x06090030U) << "15 is the largest limit";
  EXPECT_EQ(write_object(0x10F1, 2, {1, 0, 0, 0}), 0x06070012U) << "too long";
  EXPECT_EQ(write_object(0x10F1, 2, {1}), 0x06070013U) << "too short";
  EXPECT_EQ(write_object(0x1018, 1, {1, 0, 0, 0}), 0x06010002U);
  EXPECT_EQ(write_object(0x5555, 0, {1}), 0x06020000U);
  EXPECT_EQ(write_object(0x1018, 9, {1}), 0x06090011U);
}

TEST_F(SimServo, LongObjectsComeInSegments) {
  SimSlaveConfig slave = sim_slave("SL-SV7", "servo-y");
  ObjectDescription object;
  object.index = 0x2FFF;
  ObjectEntry entry;
  entry.bit_length = 8 * 400;
  entry.writable = true;
  for (int i = 0; i < 400; ++i) entry.default_data.push_back(static_cast<std::uint8_t>(i * 7));
  const auto expected = entry.default_data;
  object.entries.push_back(std::move(entry));
  slave.device.dictionary.push_back(std::move(object));
  probe = SimProbe(line({slave}));
  probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
  probe.set_sync_manager(0, 1, 0x1080, 128, 0x22);
  ASSERT_EQ(probe.request(0, 2), 2);
  auto response = sdo(coe::UploadRequest{{0x2FFF, 0}, false});
  ASSERT_TRUE(response && std::holds_alternative<coe::UploadResponse>(*response));
  auto data = std::get<coe::UploadResponse>(*response).data;
  EXPECT_EQ(std::get<coe::UploadResponse>(*response).complete_size, 400U);
  bool toggle = false;
  while (data.size() < 400) {
    response = sdo(coe::UploadSegmentRequest{toggle});
    ASSERT_TRUE(response && std::holds_alternative<coe::UploadSegmentResponse>(*response));
    const auto& segment = std::get<coe::UploadSegmentResponse>(*response);
    EXPECT_EQ(segment.toggle, toggle);
    data.insert(data.end(), segment.data.begin(), segment.data.end());
    EXPECT_EQ(segment.last, data.size() == 400);
    toggle = !toggle;
  }
  EXPECT_EQ(data, expected);
}

TEST_F(SimServo, PdoAssignmentBySdoChangesTheProcessData) {
  ASSERT_EQ(probe.request(0, 2), 2);
  EXPECT_EQ(write_object(0x1C12, 1, {0x01, 0x16}), 0x06010003U) << "count must be cleared first";
  EXPECT_EQ(write_object(0x1C12, 0, {0}), 0U);
  EXPECT_EQ(write_object(0x1C12, 1, {0x01, 0x16}), 0U);
  EXPECT_EQ(write_object(0x1C12, 0, {1}), 0U);
  EXPECT_EQ(to_safeop(), 0x12) << "16 bytes are the old assignment's";
  EXPECT_EQ(probe.request(0, 0x12), 2);
  probe.set_sync_manager(0, 2, 0x1100, 6, 0x64);
  EXPECT_EQ(probe.request(0, 4), 4);
}

TEST_F(SimServo, SixteenObjectsADirectionAreTheMost) {
  ASSERT_EQ(probe.request(0, 2), 2);
  EXPECT_EQ(write_object(0x1C12, 0, {0}), 0U);
  EXPECT_EQ(write_object(0x1600, 0, {0}), 0U);
  for (std::uint8_t sub = 1; sub <= 17; ++sub) EXPECT_EQ(write_object(0x1600, sub, {0x08, 0x00, 0x60, 0x60}), 0U);
  EXPECT_EQ(write_object(0x1600, 0, {17}), 0U);
  EXPECT_EQ(write_object(0x1C12, 0, {1}), 0x06040042U);
  EXPECT_EQ(write_object(0x1600, 0, {16}), 0U);
  EXPECT_EQ(write_object(0x1C12, 0, {1}), 0U);
}

TEST_F(SimServo, OutputsThatStopTripTheWatchdog) {
  ASSERT_EQ(probe.request(0, 2), 2);
  ASSERT_EQ(to_safeop(), 4);
  write_outputs();
  ASSERT_EQ(probe.request(0, 8), 8);
  for (int i = 0; i < 50; ++i) {
    write_outputs();
    probe.pass(10 * kMillisecond);
  }
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 8);
  probe.pass(150 * kMillisecond);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 0x14);
  EXPECT_EQ(probe.al_code(0), 0x001B);
}

TEST_F(SimServo, SyncCycleMustSuitTheDriveAndSync0MustCome) {
  ASSERT_EQ(probe.request(0, 2), 2);
  start_sync0(300'000);
  EXPECT_EQ(to_safeop(), 0x12);
  EXPECT_EQ(probe.al_code(0), 0x0036);
  probe.write(0, reg::kCyclicUnitControl, {0, 0});
  ASSERT_EQ(probe.request(0, 0x12), 2);
  // A start time in the past never fires on a 64-bit clock.
  start_sync0();
  probe.write(0, reg::kCyclicUnitControl, {0, 0});
  probe.pass(50 * kMillisecond);
  probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(first_sync));
  probe.write(0, reg::kCyclicUnitControl, {0x00, 0x03});
  ASSERT_EQ(to_safeop(), 4);
  write_outputs();
  probe.pass(20 * kMillisecond);
  EXPECT_EQ(probe.request(0, 8), 0x14);
  EXPECT_EQ(probe.al_code(0), 0x002D);
  EXPECT_EQ(probe.read(0, reg::kActivationStatus, 1).data[0] & 1, 1) << "SYNC0 still pending";
}

TEST_F(SimServo, MissedSm2EventsCountAndTheIntegratorTrips) {
  ASSERT_EQ(probe.request(0, 2), 2);
  start_sync0();
  ASSERT_EQ(to_safeop(), 4);
  write_outputs();
  probe.pass(10 * kMillisecond);
  ASSERT_EQ(probe.request(0, 8), 8);
  const auto cycle = [this](bool with_frame) {
    if (with_frame) write_outputs();
    probe.pass(kMillisecond - (with_frame ? 20 * kMicrosecond : 0));
  };
  for (int i = 0; i < 20; ++i) cycle(true);
  EXPECT_EQ(read_object(0x1C32, 0x0C), 0U);
  // Reading the counter took cycles without outputs of their own; start again from good ones.
  for (int i = 0; i < 40; ++i) cycle(true);
  const auto before = read_object(0x1C32, 0x0C);
  for (int i = 0; i < 40; ++i) cycle(true);
  // One in four is tolerated for ever: +3 - 3 * 1.
  for (int i = 0; i < 100; ++i) cycle(i % 4 != 0);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 8);
  EXPECT_GE(read_object(0x1C32, 0x0C), before + 25);
  for (int i = 0; i < 40; ++i) cycle(true);
  // The third in a row reaches the default limit of 9.
  cycle(false);
  cycle(false);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 8);
  cycle(false);
  cycle(false);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 0x14);
  EXPECT_EQ(probe.al_code(0), 0x001A);
  EXPECT_EQ(read_object(0x603F, 0), 0x0A12U);
  ASSERT_EQ(emergencies.size(), 1U);
  EXPECT_EQ(emergencies[0].error_code, 0x0A12);
  EXPECT_EQ(read_object(0x10F3, 4), 1U) << "the history has it, too";
}

TEST_F(SimServo, DriveCSaysInItsStatusWhatIsWrongWithTheCycle) {
  const auto status_with = [this](std::uint32_t cycle, bool late) {
    probe = SimProbe(line({sim_slave("SL-XE2", "drive-c")}));
    counter = 0;
    const auto device = sim_slave("SL-XE2").device;
    mailbox_out = device.sync_managers[0].start_address;
    mailbox_in = device.sync_managers[1].start_address;
    for (unsigned i = 0; i < 2; ++i) {
      const auto& sm = device.sync_managers[i];
      probe.set_sync_manager(0, i, sm.start_address, 128, sm.control_byte);
    }
    EXPECT_EQ(probe.request(0, 2), 2);
    start_sync0(cycle);
    if (late) {
      probe.write(0, reg::kCyclicUnitControl, {0, 0});
      probe.pass(10 * kMillisecond);
      probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(first_sync));
      probe.write(0, reg::kCyclicUnitControl, {0x00, 0x03});
    }
    for (const unsigned i : {2U, 3U}) {
      const auto& sm = device.sync_managers[i];
      std::uint32_t bits = 0;
      for (const auto& pdo : device.pdos(i == 2 ? PdoDirection::kRx : PdoDirection::kTx)) {
        if (pdo.sync_manager) bits += pdo.bit_length();
      }
      probe.set_sync_manager(0, i, sm.start_address, static_cast<std::uint16_t>((bits + 7) / 8), sm.control_byte);
    }
    EXPECT_EQ(probe.request(0, 4), 4);
    probe.pass(500 * kMillisecond);  // for the drive's PLL
    return read_object(0x21B4, 0);
  };
  EXPECT_EQ(status_with(1'000'000, false), 0x07U);
  EXPECT_EQ(status_with(312'500, false), 0x01U) << "legal, but only the current loop is synchronised";
  EXPECT_EQ(status_with(1'000'000, true), 0x0DU) << "start time before system time: no SYNC0 leads the servo loop";
}

TEST_F(SimServo, RepeatedMailboxCounterIsDroppedAndAFullMailboxRefused) {
  ASSERT_EQ(probe.request(0, 2), 2);
  MailboxMessage mail;
  mail.counter = 3;
  mail.data = coe::encode(coe::Request{coe::UploadRequest{{0x1018, 1}, false}});
  EXPECT_EQ(probe.write(0, 0x1000, mail.encode(128)).wkc, 1);
  EXPECT_EQ(probe.write(0, 0x1000, mail.encode(128)).wkc, 0) << "not taken by the firmware yet";
  probe.pass(kMillisecond);
  EXPECT_EQ(probe.read(0, 0x1080, 128).wkc, 1);
  EXPECT_EQ(probe.read(0, 0x1080, 128).wkc, 0) << "empty now";
  EXPECT_EQ(probe.write(0, 0x1000, mail.encode(128)).wkc, 1);
  probe.pass(kMillisecond);
  EXPECT_EQ(probe.read(0, 0x1080, 128).wkc, 0) << "a duplicate is not answered";
}

/// ETG.5001.1, 0xF030, also where the ESI has no dictionary; it takes as many idents as there are places.
TEST(SimStation, TakesTheListOfItsModulesWhereItIsDownloaded) {
  SimSlaveConfig config;
  auto& slots = config.device.slots.emplace();
  slots.slots.resize(2);
  slots.slots[0].max_instances = 1;
  slots.slots[1].max_instances = 2;
  sim::ObjectDictionary without;
  sim::add_device_objects(config, without);
  EXPECT_TRUE(without.sub_indices(0xF030).empty());

  slots.download_ident_list = true;
  sim::ObjectDictionary dictionary;
  sim::add_device_objects(config, dictionary);
  EXPECT_EQ(dictionary.sub_indices(0xF030), (std::vector<std::uint8_t>{0, 1, 2, 3}));
  const coe::ObjectAddress list{0xF030, 0};
  const std::vector<std::uint8_t> two{2, 0, 0x10, 1, 0, 0, 0x20, 1, 0, 0},
      four{4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(sim::write_complete(dictionary, list, two, true), sim::abort::kNone);
  EXPECT_EQ(dictionary.get<std::uint8_t>(0xF030, 0), 2);
  EXPECT_EQ(dictionary.get<std::uint32_t>(0xF030, 2), 0x120U);
  EXPECT_NE(sim::write_complete(dictionary, list, four, true), sim::abort::kNone);
}

}  // namespace
}  // namespace syncline::test
