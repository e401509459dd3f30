// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "protocol/fmmu.h"
#include "sim/mailbox/file_server.h"
#include "sim/objects/object_dictionary.h"
#include "sim/objects/pdo_objects.h"
#include "tests/core/sim/sim_probe.h"

/// What a device examines before it changes its state, and the AL status code that says what is wrong.
namespace syncline::test {
namespace {

/// A servo in PREOP, its process data set up as it wants them.
class SimChecks : public testing::Test {
 protected:
  SimChecks() : probe(line({sim_slave("SL-SV7", "servo-y")})) {
    mailbox();
    EXPECT_EQ(probe.request(0, 2), 2);
    process_data();
  }
  void mailbox() {
    probe.set_sync_manager(0, 0, 0x1000, 128, 0x26);
    probe.set_sync_manager(0, 1, 0x1080, 128, 0x22);
  }
  void process_data() {
    probe.set_sync_manager(0, 2, 0x1100, 16, 0x64);
    probe.set_sync_manager(0, 3, 0x1400, 20, 0x20);
  }
  void map(unsigned number, std::uint32_t logical, std::uint16_t physical, std::uint16_t length, bool read,
           bool write) {
    Fmmu fmmu;
    fmmu.logical_start = logical;
    fmmu.physical_start = physical;
    fmmu.length = length;
    fmmu.read = read;
    fmmu.write = write;
    fmmu.active = true;
    const auto image = fmmu.encode();
    probe.write(0, reg::fmmu(number), {image.begin(), image.end()});
  }
  void unmap() { probe.write(0, reg::fmmu(0), std::vector<std::uint8_t>(64)); }
  /// AL status code of a request for SAFEOP; 0 when it was granted. Back in PREOP afterwards.
  std::uint16_t safeop() {
    const auto status = probe.request(0, 4);
    const auto code = probe.al_code(0);
    EXPECT_EQ(status, code == 0 ? 0x04 : 0x12);
    EXPECT_EQ(probe.request(0, 0x12), 2);
    return code;
  }
  void write_outputs() { probe.write(0, 0x1100, std::vector<std::uint8_t>(16)); }
  void start_sync0(std::uint64_t delay) {
    const auto now = probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>();
    probe.write(0, reg::kSync0CycleTime, le_bytes(std::uint32_t{1'000'000}));
    probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(now + delay));
    probe.write(0, reg::kCyclicUnitControl, {0x00, 0x03});
  }

  SimProbe probe;
};

TEST_F(SimChecks, LegalMappingsOfEveryKindPass) {
  EXPECT_EQ(safeop(), 0) << "no FMMU: the master addresses the data directly";
  map(0, 0x10000, 0x1100, 16, false, true);
  map(1, 0x10010, 0x1400, 20, true, false);
  map(2, 0x10024, 0x080D, 1, true, false);
  EXPECT_EQ(safeop(), 0);
  map(0, 0x10000, 0x1100, 9, false, true);
  map(3, 0x20000, 0x1109, 7, false, true);
  EXPECT_EQ(safeop(), 0) << "an FMMU for each part";
  unmap();
  map(0, 0x10000, 0x1400, 20, true, false);
  EXPECT_EQ(safeop(), 0) << "outputs without, inputs with an FMMU";
  map(1, 0x10000, 0x1100, 16, true, true);
  EXPECT_EQ(safeop(), 0) << "outputs that are read back";
}

TEST_F(SimChecks, AMappingThatCannotWorkIsRefused) {
  map(0, 0x10000, 0x1180, 16, false, true);
  EXPECT_EQ(safeop(), 0x0025) << "misses the outputs";
  map(0, 0x10000, 0x1100, 17, false, true);
  EXPECT_EQ(safeop(), 0x0025) << "reaches into the second buffer";
  map(0, 0x10000, 0x1100, 16, false, true);
  map(1, 0x10010, 0x1404, 20, true, false);
  EXPECT_EQ(safeop(), 0x0024) << "reaches behind the inputs";
  map(1, 0x10010, 0x1500, 20, true, false);
  EXPECT_EQ(safeop(), 0x0024) << "misses the inputs";
  map(1, 0x10010, 0x1400, 20, false, true);
  EXPECT_EQ(safeop(), 0x0024) << "writes inputs";
  map(1, 0x10010, 0x1400, 20, true, false);
  EXPECT_EQ(safeop(), 0);
}

TEST_F(SimChecks, ProcessDataInMailboxModeHaveTheWrongType) {
  probe.set_sync_manager(0, 2, 0x1100, 16, 0x66);
  EXPECT_EQ(safeop(), 0x001C);
  process_data();
  probe.set_sync_manager(0, 3, 0x1400, 20, 0x22);
  EXPECT_EQ(safeop(), 0x001C);
  process_data();
  EXPECT_EQ(safeop(), 0);
}

TEST_F(SimChecks, ADriveDoesNotMoveWithoutItsWatchdog) {
  probe.write(0, reg::kWatchdogProcessData, {0, 0});
  EXPECT_EQ(safeop(), 0x001F);
  probe.set_sync_manager(0, 2, 0x1100, 16, 0x24);
  EXPECT_EQ(safeop(), 0) << "not asked to watch";
  process_data();
  probe.write(0, reg::kWatchdogProcessData, {10, 0});
  EXPECT_EQ(safeop(), 0);
}

TEST_F(SimChecks, SyncManagersThatChangeBehindTheDevicesBackSendItBack) {
  probe.set_sync_manager(0, 1, 0x1080, 100, 0x22);
  EXPECT_EQ(safeop(), 0x0021) << "mailboxes are set up on the way from INIT";
  mailbox();
  EXPECT_EQ(probe.request(0, 4), 4);
  write_outputs();
  probe.set_sync_manager(0, 3, 0x1400, 12, 0x20);
  EXPECT_EQ(probe.request(0, 8), 0x14);
  EXPECT_EQ(probe.al_code(0), 0x0022) << "process data on the way from PREOP";
  process_data();
  EXPECT_EQ(probe.request(0, 0x14), 4);
  EXPECT_EQ(probe.request(0, 8), 8) << "written again as they were";
}

/// Any device with firmware, not just drives.
class SimSyncChecks : public SimChecks {
 protected:
  SimSyncChecks() {
    auto slave = sim_slave("SL-SV7");
    slave.behaviour = "generic";
    probe = SimProbe(line({slave}));
    mailbox();
    EXPECT_EQ(probe.request(0, 2), 2);
    process_data();
  }
};

TEST_F(SimSyncChecks, TheAnswerToARequestForOpWaitsForTheFirstSync0) {
  start_sync0(30 * kMillisecond);
  ASSERT_EQ(probe.request(0, 4), 4);
  write_outputs();
  EXPECT_EQ(probe.request(0, 8), 4) << "neither granted nor refused";
  probe.pass(15 * kMillisecond);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 4);
  probe.pass(20 * kMillisecond);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 8);
}

TEST_F(SimSyncChecks, LatchInputsInTheWrongHandsAreRefused) {
  start_sync0(5 * kMillisecond);
  probe.write(0, reg::kCyclicUnitControl, {0x30});  // both belong to the device: no mode of it says so
  EXPECT_EQ(safeop(), 0x0031);
  probe.write(0, reg::kCyclicUnitControl, {0x00});
  EXPECT_EQ(safeop(), 0);
  probe.write(0, reg::kActivation, {0x00});
  probe.write(0, reg::kCyclicUnitControl, {0x30});
  EXPECT_EQ(safeop(), 0) << "nothing is switched on";
}

/// A device whose first input is its first output.
TEST_F(SimSyncChecks, InputsAreThoseOfSync0WhereThereIsOne) {
  for (const bool dc : {true, false}) {
    auto slave = sim_slave("SL-SV7");
    slave.behaviour = "generic";
    for (auto& pdo : slave.device.tx_pdos) {
      for (auto& entry : pdo.entries) entry.index = entry.index == 0x6041 ? 0x6040 : entry.index;
    }
    probe = SimProbe(line({slave}));
    mailbox();
    ASSERT_EQ(probe.request(0, 2), 2);
    process_data();
    if (dc) start_sync0(5 * kMillisecond);
    ASSERT_EQ(probe.request(0, 4), 4);
    write_outputs();
    probe.pass(10 * kMillisecond);
    ASSERT_EQ(probe.request(0, 8), 8);
    const auto input = [this] { return probe.bus->peek(0, 0x1400, 1)[0]; };
    const auto next = probe.read(0, reg::kStartTimeCyclicOperation, 8).value<std::uint64_t>();
    const auto now = probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>();
    if (dc) probe.pass(static_cast<Nanoseconds>(next - now) + 100 * kMicrosecond);
    probe.write(0, 0x1100, std::vector<std::uint8_t>(16, 0x5A));
    EXPECT_EQ(input(), dc ? 0x00 : 0x5A);
    probe.pass(kMillisecond);
    EXPECT_EQ(input(), 0x5A);
  }
}

TEST_F(SimSyncChecks, ASync0ThatDoesNotComeRefusesOp) {
  start_sync0(std::uint64_t{0} - kMillisecond);
  ASSERT_EQ(probe.request(0, 4), 4);
  write_outputs();
  EXPECT_EQ(probe.request(0, 8), 0x14) << "the start time has passed: no use to wait";
  EXPECT_EQ(probe.al_code(0), 0x002D);
  probe.write(0, reg::kCyclicUnitControl, {0, 0});
  ASSERT_EQ(probe.request(0, 0x14), 4);
  start_sync0(10 * kSecond);
  write_outputs();
  EXPECT_EQ(probe.request(0, 8), 4);
  probe.pass(190 * kMillisecond);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 4);
  probe.pass(20 * kMillisecond);
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 0x14) << "patience has an end";
  EXPECT_EQ(probe.al_code(0), 0x002D);
}

TEST_F(SimSyncChecks, ASync0ThatStopsInOpIsFatal) {
  start_sync0(5 * kMillisecond);
  ASSERT_EQ(probe.request(0, 4), 4);
  write_outputs();
  probe.pass(10 * kMillisecond);
  ASSERT_EQ(probe.request(0, 8), 8);
  probe.write(0, reg::kActivation, {0});
  for (int i = 0; i < 7; ++i) {
    write_outputs();
    probe.pass(kMillisecond - 20 * kMicrosecond);
  }
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 8);
  for (int i = 0; i < 3; ++i) {
    write_outputs();
    probe.pass(kMillisecond);
  }
  EXPECT_EQ(probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(), 0x14);
  EXPECT_EQ(probe.al_code(0), 0x002C);
}

// ---- objects and files -----------------------------------------------------------------------------------

TEST(SimPdoMapping, AnEntryIsAsWideAsItsObject) {
  sim::ObjectDictionary dictionary;
  dictionary.add<std::uint16_t>(0x6040, 0, "Controlword", 0, true);
  dictionary.add<std::uint8_t>(0x7000, 1, "Output", 0, true).bit_length = 1;
  DeviceDescription device;
  Pdo pdo;
  pdo.index = 0x1600;
  device.rx_pdos.push_back(pdo);
  const sim::PdoObjects pdos(device, dictionary, 8);
  const auto write = [&](std::uint32_t word) { return dictionary.write(0x1600, 1, le_bytes(word), true); };
  EXPECT_EQ(write(0x6040'00'20U), 0x06040041U) << "wider";
  EXPECT_EQ(write(0x6040'00'08U), 0x06040041U) << "narrower";
  EXPECT_EQ(write(0x6040'00'10U), 0U);
  EXPECT_EQ(write(0x7000'01'08U), 0x06040041U) << "a bit is not a byte";
  EXPECT_EQ(write(0x7000'01'01U), 0U);
  EXPECT_EQ(write(0x0000'00'07U), 0U) << "padding of any width";
}

TEST(SimFileServer, IsBusyWhileItErasesASector) {
  sim::FileServer server(0);
  constexpr std::size_t kMailbox = 1024;
  const auto room = foe::data_capacity(kMailbox);
  ASSERT_TRUE(std::holds_alternative<foe::Ack>(*server.respond(foe::WriteRequest{0, "firmware"}, kMailbox)));
  std::vector<std::uint8_t> all;
  unsigned busy = 0;
  for (std::uint32_t packet = 1; all.size() < 150'000; ++packet) {
    const foe::Data data{packet, std::vector<std::uint8_t>(room, static_cast<std::uint8_t>(packet))};
    auto answer = server.respond(data, kMailbox);
    if (std::holds_alternative<foe::Busy>(*answer)) {
      ++busy;
      answer = server.respond(data, kMailbox);
    }
    ASSERT_TRUE(std::holds_alternative<foe::Ack>(*answer));
    EXPECT_EQ(std::get<foe::Ack>(*answer).packet_no, packet);
    all.insert(all.end(), data.bytes.begin(), data.bytes.end());
  }
  EXPECT_EQ(busy, 2U) << "at 64 and at 128 KByte";
  const auto packets = static_cast<std::uint32_t>(all.size() / room);
  ASSERT_TRUE(server.respond(foe::Data{packets + 1, {}}, kMailbox));
  EXPECT_EQ(server.files().at("firmware"), all) << "nothing twice, nothing left out";
}

}  // namespace
}  // namespace syncline::test
