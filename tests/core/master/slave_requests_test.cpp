// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "channels/request_desk.h"
#include "channels/slave_request.h"
#include "channels/snapshot.h"
#include "cycle_hooks.h"
#include "findings/error_text.h"
#include "master/master_service.h"
#include "protocol/registers.h"
#include "protocol/sii.h"
#include "support/byte_order.h"
#include "support/random.h"
#include "tests/support/simulated_network.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

using Bytes = std::vector<std::uint8_t>;
using namespace requests;

constexpr std::uint16_t kServo = 1, kOther = 2;

/// Requests on the slaves of a simulated machine in any state.
class SlaveRequests : public ::testing::Test {
 protected:
  void go_online(AlState state, const test::SimulatedNetwork& network = test::two_axes()) {
    service = std::make_unique<MasterService>(network.link(clock), clock);
    service->channels().commands.push(GoOnlineCommand{network.compiled(), state});
    service->run_for(5 * kSecond);
    look();
    ASSERT_EQ(snapshot.state, state);
  }
  void look() {
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
    service->channels().snapshot.read(snapshot);
    service->channels().samples.pop(samples);
  }
  RequestDesk& desk() { return service->channels().requests; }
  /// Its answer, when one comes in time.
  SlaveAnswer wait_for(RequestId id, Nanoseconds patience = 20 * kSecond) {
    const auto end = clock.now() + patience;
    while (clock.now() < end) {
      if (auto answer = desk().take(id)) return std::move(*answer);
      if (!service->step()) service->run_for(kMillisecond);
    }
    ADD_FAILURE() << "no answer";
    return {};
  }
  SlaveAnswer ask(SlaveRequest request) {
    const auto id = desk().submit(std::move(request));
    EXPECT_TRUE(id);
    return id ? wait_for(*id) : SlaveAnswer{};
  }
  static std::string told(const SlaveAnswer& answer) {
    return answer.error ? answer.error->subject + ": " + answer.error->detail.text() : std::string();
  }

  VirtualClock clock;
  std::unique_ptr<MasterService> service;
  Snapshot snapshot;
  std::vector<Event> events;
  std::vector<CycleSample> samples;
};

TEST_F(SlaveRequests, OfflineTheySayWhatToDo) {
  service = std::make_unique<MasterService>(test::two_axes().link(clock), clock);
  const auto answer = ask(RegisterRead{0, 0x0130, 2});
  ASSERT_TRUE(answer.error);
  EXPECT_NE(answer.error->detail.text().find("go online"), std::string::npos);
}

TEST_F(SlaveRequests, RegistersAndEepromInInit) {
  const auto network = test::two_axes();
  go_online(AlState::kInit, network);
  const auto station = ask(RegisterRead{kServo, reg::kAlStatus, 2});
  EXPECT_EQ(station.data, (Bytes{1, 0})) << told(station);
  EXPECT_EQ(told(ask(RegisterWrite{kServo, 0x0F80, {5, 6, 7}})), "");
  const auto back = ask(RegisterRead{kServo, 0x0F80, 3});
  const auto words = ask(EepromRead{kServo, sii::kVendorIdWord, 4});
  ASSERT_EQ(words.data.size(), 8U) << told(words);
  const auto& identity = network.sim.slaves[kServo].device.identity;
  EXPECT_EQ(load_le<std::uint32_t>(words.data), identity.vendor_id);
  EXPECT_EQ(load_le<std::uint32_t>(std::span(words.data).subspan(4)), identity.product_code);
  EXPECT_EQ(back.data, (Bytes{5, 6, 7})) << told(back);
  const auto absent = ask(RegisterRead{kServo, 0x0D00, 2});
  ASSERT_TRUE(absent.error);
  EXPECT_EQ(absent.error->code, ErrorCode::kWorkingCounter) << "the slave is there, the register is not";
  const auto led = ask(StateChange{kServo, AlState::kPreop});
  ASSERT_TRUE(led.error);
  EXPECT_NE(led.error->detail.text().find("whole bus"), std::string::npos);
  const auto refused = ask(SdoRead{kServo, {0x1018, 1}});
  ASSERT_TRUE(refused.error);
  EXPECT_NE(refused.error->detail.text().find("INIT"), std::string::npos) << refused.error->detail.text();
}

TEST_F(SlaveRequests, ObjectsInPreopAndOp) {
  for (const auto state : {AlState::kPreop, AlState::kOp}) {
    const auto network = test::two_axes();
    go_online(state, network);
    const auto vendor = ask(SdoRead{kServo, {0x1018, 1}});
    ASSERT_EQ(vendor.data.size(), 4U) << told(vendor);
    EXPECT_EQ(load_le<std::uint32_t>(vendor.data), network.sim.slaves[kServo].device.identity.vendor_id);
    const auto missing = ask(SdoRead{kServo, {0x5FFF, 1}});
    ASSERT_TRUE(missing.error);
    EXPECT_EQ(missing.error->code, ErrorCode::kSdoAbort);
    EXPECT_EQ(missing.error->received, 0x06020000);
    EXPECT_NE(missing.error->subject.find("object 0x5FFF:01"), std::string::npos);
    const auto list = ask(ObjectListRead{kServo});
    ASSERT_TRUE(list.information) << told(list);
    const auto& indices = std::get<coe::ObjectList>(*list.information).indices;
    EXPECT_NE(std::ranges::find(indices, 0x1018), indices.end());
    const auto object = ask(ObjectRead{kServo, 0x1018});
    ASSERT_TRUE(object.information) << told(object);
    EXPECT_EQ(std::get<coe::ObjectDescription>(*object.information).index, 0x1018);
    const auto entry = ask(EntryRead{kServo, 0x1018, 1});
    ASSERT_TRUE(entry.information) << told(entry);
    EXPECT_EQ(std::get<coe::EntryDescription>(*entry.information).bit_length, 32);
    const auto none = ask(SdoRead{0, {0x1018, 1}});
    ASSERT_TRUE(none.error);
    EXPECT_NE(none.error->detail.text().find("no mailbox"), std::string::npos);
    const auto nobody = ask(SdoRead{9, {0x1018, 1}});
    ASSERT_TRUE(nobody.error);
    EXPECT_NE(nobody.error->detail.text().find("3 slaves"), std::string::npos);
  }
}

TEST_F(SlaveRequests, AnObjectThatIsTooLargeIsRefusedInWords) {
  go_online(AlState::kOp);
  const auto name = ask(SdoRead{kServo, {0x1008, 0}});
  ASSERT_FALSE(name.error) << told(name);
  ASSERT_GT(name.data.size(), 4U);
  const auto refused = ask(SdoRead{kServo, {0x1008, 0}, false, 4});
  ASSERT_TRUE(refused.error);
  EXPECT_NE(refused.error->detail.text().find("more than the 4"), std::string::npos) << refused.error->detail.text();
  EXPECT_EQ(ask(SdoRead{kServo, {0x1008, 0}}).data, name.data) << "the slave is free again";
}

TEST_F(SlaveRequests, FilesOfAnyLengthInOp) {
  go_online(AlState::kOp);
  Bytes file(3000);
  std::iota(file.begin(), file.end(), std::uint8_t{0});
  EXPECT_EQ(told(ask(FileWrite{kServo, "notes", 0, file})), "");
  EXPECT_EQ(ask(FileRead{kServo, "notes"}).data, file);
  const auto longer = ask(FileRead{kServo, "notes", 0, 2000});
  ASSERT_TRUE(longer.error);
  EXPECT_NE(longer.error->detail.text().find("2000"), std::string::npos);
  const auto missing = ask(FileRead{kServo, "nothing"});
  ASSERT_TRUE(missing.error);
  EXPECT_EQ(missing.error->code, ErrorCode::kFileTransfer);
}

TEST_F(SlaveRequests, AnEepromIsWrittenAsAWholeOrNotAtAll) {
  go_online(AlState::kOp);
  const auto before = ask(EepromRead{kServo, 0, 64});
  ASSERT_EQ(before.data.size(), 128U) << told(before);
  // Words behind the configuration area need no checksum.
  EXPECT_EQ(told(ask(EepromWrite{kServo, 0x30, {1, 2, 3, 4}})), "");
  EXPECT_EQ(ask(EepromRead{kServo, 0x30, 2}).data, (Bytes{1, 2, 3, 4}));
  const auto bad = ask(EepromWrite{kServo, 4, {0x34, 0x12}});
  ASSERT_TRUE(bad.error);
  EXPECT_EQ(bad.error->code, ErrorCode::kBadValue);
  EXPECT_EQ(ask(EepromRead{kServo, 0, 8}).data, Bytes(before.data.begin(), before.data.begin() + 16));
  Bytes area(before.data.begin(), before.data.begin() + 16);
  area[8] = 0x34;
  area[9] = 0x12;
  area[14] = sii::checksum(std::span<const std::uint8_t>(area).first(14));
  EXPECT_EQ(told(ask(EepromWrite{kServo, 0, area})), "");
  EXPECT_EQ(ask(EepromRead{kServo, 0, 8}).data, area);
}

TEST_F(SlaveRequests, AnEepromWriteTellsHowFarItIs) {
  go_online(AlState::kOp);
  const auto id = desk().submit(EepromWrite{kServo, 0x30, {1, 2, 3, 4, 5, 6, 7, 8}});
  ASSERT_TRUE(id);
  std::vector<std::uint32_t> told_bytes{0};
  std::optional<SlaveAnswer> answer;
  for (int i = 0; i < 5000 && !answer; ++i) {
    service->step();
    if (desk().progress(*id) != told_bytes.back()) told_bytes.push_back(desk().progress(*id));
    answer = desk().take(*id);
  }
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->error) << told(*answer);
  EXPECT_EQ(told_bytes, (std::vector<std::uint32_t>{0, 2, 4, 6, 8}));
}

/// At whatever moment it is cancelled, the EEPROM holds all of the old or all of the new.
TEST_F(SlaveRequests, ACancelledEepromWritePutsBack) {
  go_online(AlState::kOp);
  const Bytes data{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  const auto old = ask(EepromRead{kServo, 0x30, 5}).data;
  int put_back = 0;
  for (int cycles = 1; cycles < 200; cycles += 13) {
    const auto id = desk().submit(EepromWrite{kServo, 0x30, data});
    ASSERT_TRUE(id);
    for (int i = 0; i < cycles; ++i) service->step();
    desk().cancel(*id);
    const auto answer = wait_for(*id);
    const auto now = ask(EepromRead{kServo, 0x30, 5}).data;
    EXPECT_EQ(now, answer.error ? old : data) << cycles << " " << told(answer);
    put_back += answer.error ? 1 : 0;
    if (answer.error) continue;
    EXPECT_EQ(told(ask(EepromWrite{kServo, 0x30, old})), "");
  }
  EXPECT_GT(put_back, 2);
}

TEST_F(SlaveRequests, OneSlaveIsLedToAnotherStateAndBack) {
  go_online(AlState::kOp);
  EXPECT_EQ(told(ask(StateChange{kServo, AlState::kPreop})), "");
  look();
  EXPECT_EQ(al_state_of(snapshot.slaves[kServo].al_status), AlState::kPreop);
  EXPECT_EQ(al_state_of(snapshot.slaves[kOther].al_status), AlState::kOp);
  EXPECT_EQ(told(ask(StateChange{kServo, AlState::kOp})), "");
  EXPECT_EQ(told(ask(StateChange{kServo, AlState::kInit})), "");
  EXPECT_EQ(told(ask(StateChange{kServo, AlState::kOp})), "");
  look();
  EXPECT_EQ(snapshot.state, AlState::kOp);
}

/// Whoever asked is told the slave's own reason, whichever step it was.
TEST_F(SlaveRequests, ARefusedStateIsAnsweredWithTheCode) {
  for (const auto state : {AlState::kPreop, AlState::kSafeop, AlState::kOp, AlState::kBoot}) {
    SCOPED_TRACE(al_state_name(state));
    auto network = test::two_axes();
    network.project.master.recovery.automatic = false;
    auto& refusal = network.sim.faults.emplace_back();
    refusal.kind = FaultKind::kRefuseState;
    refusal.slave = kServo;
    refusal.at = 6 * kSecond;
    refusal.until = 600 * kSecond;
    refusal.state = state;
    refusal.code = 0x0013;
    go_online(AlState::kOp, network);
    service->run_for(2 * kSecond);
    if (state != AlState::kBoot) {
      EXPECT_EQ(told(ask(StateChange{kServo, AlState::kInit})), "");
    }
    const auto refused = ask(StateChange{kServo, state == AlState::kBoot ? state : AlState::kOp});
    ASSERT_TRUE(refused.error);
    EXPECT_EQ(refused.error->code, ErrorCode::kAlState) << describe(*refused.error);
    EXPECT_EQ(refused.error->extra, 0x0013);
    look();
    EXPECT_NE(al_state_of(snapshot.slaves[kServo].al_status), state);
    EXPECT_EQ(told(ask(StateChange{kOther, AlState::kBoot})), "");
    look();
    EXPECT_EQ(al_state_of(snapshot.slaves[kOther].al_status), AlState::kBoot);
    EXPECT_EQ(told(ask(StateChange{kOther, AlState::kOp})), "");
  }
}

TEST_F(SlaveRequests, AnErrorIsAcknowledged) {
  auto network = test::two_axes();
  network.project.master.recovery.automatic = false;
  network.project.master.recovery.error_tries = 0;
  go_online(AlState::kOp, network);
  // The watchdog's end brings it to SAFEOP with an error: nobody writes its outputs for a while.
  EXPECT_EQ(told(ask(RegisterWrite{kServo, static_cast<std::uint16_t>(reg::sync_manager(2) + 6), {0}})), "");
  service->run_for(kSecond);
  look();
  ASSERT_NE(snapshot.slaves[kServo].al_status & kAlErrorFlag, 0);
  EXPECT_EQ(told(ask(ErrorAcknowledge{kServo})), "");
  look();
  EXPECT_EQ(snapshot.slaves[kServo].al_status & kAlErrorFlag, 0);
}

TEST_F(SlaveRequests, ASlaveThatSaysNothingIsGivenUpAndKeepsNobodyElse) {
  auto network = test::two_axes();
  network.sim.faults.push_back(
      {.kind = FaultKind::kMailboxSilence, .slave = kServo, .at = 6 * kSecond, .until = 60 * kSecond});
  go_online(AlState::kOp, network);
  service->run_for(2 * kSecond);
  const auto mute = desk().submit(SdoRead{kServo, {0x1018, 1}});
  const auto began = clock.now();
  const auto other = ask(SdoRead{kOther, {0x1018, 1}});
  EXPECT_EQ(other.data.size(), 4U) << told(other);
  EXPECT_LT(clock.now() - began, 500 * kMillisecond);
  const auto answer = wait_for(*mute);
  ASSERT_TRUE(answer.error);
  EXPECT_EQ(answer.error->code, ErrorCode::kMailboxTimeout);
}

TEST_F(SlaveRequests, ASlowSlaveGetsItsTime) {
  auto network = test::two_axes();
  network.sim.faults.push_back({.kind = FaultKind::kSlowMailbox,
                                .slave = kServo,
                                .at = 6 * kSecond,
                                .until = 60 * kSecond,
                                .value_ns = 800 * kMillisecond});
  go_online(AlState::kOp, network);
  service->run_for(2 * kSecond);
  const auto began = clock.now();
  const auto answer = ask(SdoRead{kServo, {0x1018, 2}});
  EXPECT_EQ(answer.data, le_bytes(network.sim.slaves[kServo].device.identity.product_code)) << told(answer);
  EXPECT_GT(clock.now() - began, 700 * kMillisecond);
}

/// A mailbox as long as a frame has no room beside the readings of each cycle.
test::SimulatedNetwork machine_with_long_mailboxes() {
  auto device = test::servo();
  const auto place = [&](std::size_t number, std::uint16_t start, std::uint16_t size) {
    auto& manager = device.sync_managers[number];
    manager.start_address = start;
    manager.default_size = manager.max_size = size;
  };
  place(0, 0x1000, 1486);
  place(1, 0x1600, 1486);
  device.sync_managers[2].start_address = 0x1C00;
  device.sync_managers[3].start_address = 0x2000;
  test::SimulatedNetwork network;
  network.add(device, "servo-y");
  network.project.master.dc.sync_window.enabled = true;
  return network;
}

TEST_F(SlaveRequests, AMailboxAsLongAsAFrameIsServedBesideTheReadings) {
  go_online(AlState::kOp, machine_with_long_mailboxes());
  const auto answer = ask(SdoRead{0, {0x1018, 1}});
  EXPECT_EQ(answer.data.size(), 4U) << told(answer);
  look();
  EXPECT_TRUE(snapshot.slaves[0].sm2_missed.valid) << "our own readings, too";
  EXPECT_EQ(snapshot.lost_frames, 0U);
}

/// Whoever asks without end leaves our own readings of the same slave their turns.
TEST_F(SlaveRequests, OurOwnReadingsGoOnMeanwhile) {
  go_online(AlState::kOp);
  Nanoseconds oldest = 0;
  const auto end = clock.now() + 2 * kSecond;
  std::vector<RequestId> ids;
  while (clock.now() < end) {
    while (ids.size() < 4) ids.push_back(desk().submit(SdoRead{kServo, {0x1008, 0}}).value());
    service->step();
    std::erase_if(ids, [&](RequestId id) { return desk().take(id).has_value(); });
    look();
    oldest = std::max(oldest, snapshot.time - snapshot.slaves[kServo].sm2_missed.time);
  }
  EXPECT_LT(oldest, 500 * kMillisecond);
}

TEST_F(SlaveRequests, ASlaveThatIsGoneIsNamedAtOnce) {
  auto network = test::two_axes();
  network.sim.faults.push_back(
      {.kind = FaultKind::kSlaveOff, .slave = kOther, .at = 6 * kSecond, .until = 60 * kSecond});
  go_online(AlState::kOp, network);
  service->run_for(3 * kSecond);
  const auto answer = ask(SdoRead{kOther, {0x1018, 1}});
  ASSERT_TRUE(answer.error);
  EXPECT_EQ(answer.error->code, ErrorCode::kNoResponse);
}

TEST_F(SlaveRequests, GoingOfflineAnswersThemAll) {
  go_online(AlState::kOp);
  const auto file = desk().submit(FileWrite{kServo, "notes", 0, Bytes(50'000)});
  const auto words = desk().submit(EepromWrite{kOther, 0x30, Bytes(40, 9)});
  const auto waits = desk().submit(SdoRead{kServo, {0x1018, 1}});
  for (int i = 0; i < 40; ++i) service->step();
  service->channels().commands.push(GoOfflineCommand{});
  while (service->online() && service->step()) {
  }
  for (const auto& id : {file, words, waits}) {
    const auto answer = desk().take(*id);
    ASSERT_TRUE(answer);
    ASSERT_TRUE(answer->error);
    EXPECT_EQ(answer->error->code, ErrorCode::kCancelled);
  }
}

TEST_F(SlaveRequests, ARequestDuringTheBringUpWaitsForTheMailbox) {
  const auto network = test::two_axes();
  service = std::make_unique<MasterService>(network.link(clock), clock);
  service->channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  const auto early = desk().submit(SdoRead{kServo, {0x1018, 1}});
  service->run_for(5 * kSecond);
  const auto answer = wait_for(*early);
  EXPECT_EQ(answer.data.size(), 4U) << told(answer);
  look();
  EXPECT_EQ(snapshot.state, AlState::kOp);
}

/// Whatever is asked by whomever, in whatever order and state of affairs, each gets the answer to his own question.
TEST_F(SlaveRequests, InAnyInterleavingEachGetsHisOwnAnswer) {
  const auto network = test::two_axes();
  go_online(AlState::kOp, network);
  const auto expected = [&](const SlaveRequest& request) -> Bytes {
    if (const auto* sdo = std::get_if<SdoRead>(&request)) {
      const auto& identity = network.sim.slaves[sdo->slave].device.identity;
      return le_bytes(sdo->object.sub_index == 1 ? identity.vendor_id : identity.product_code);
    }
    if (std::holds_alternative<RegisterRead>(request)) {
      return le_bytes(static_cast<std::uint16_t>(1001 + slave_of(request)));
    }
    return le_bytes(network.sim.slaves[slave_of(request)].device.identity.product_code);
  };
  EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    const auto pick = [&]() -> SlaveRequest {
      const auto slave = static_cast<std::uint16_t>(random.next() % 3);
      const auto kind = slave == 0 ? random.next() % 2 : random.next() % 4;
      if (kind == 0) return RegisterRead{slave, reg::kStationAddress, 2};
      if (kind == 1) return EepromRead{slave, sii::kVendorIdWord + 2, 2};
      return SdoRead{slave, {0x1018, static_cast<std::uint8_t>(1 + random.next() % 2)}};
    };
    std::map<RequestId, SlaveRequest> open;
    std::map<RequestId, bool> cancelled;
    const auto look_for_answers = [&] {
      for (auto it = open.begin(); it != open.end();) {
        const auto answer = desk().take(it->first);
        if (!answer) {
          ++it;
          continue;
        }
        RC_ASSERT(answer->id == it->first);
        const bool ended = answer->error && answer->error->code == ErrorCode::kCancelled;
        const bool right = ended ? cancelled[it->first] : !answer->error && answer->data == expected(it->second);
        RC_ASSERT(right);
        it = open.erase(it);
      }
    };
    const auto count = 1 + random.next() % 30;
    for (std::uint64_t n = 0; n < count; ++n) {
      auto request = pick();
      const auto id = desk().submit(request);
      RC_ASSERT(id.has_value());
      open.emplace(*id, std::move(request));
      if (random.next() % 5 == 0) {
        cancelled[*id] = true;
        desk().cancel(*id);
      }
      for (auto steps = random.next() % 6; steps > 0; --steps) service->step();
      look_for_answers();
    }
    for (int i = 0; i < 3000 && !open.empty(); ++i) {
      service->step();
      look_for_answers();
    }
    RC_ASSERT(open.empty());
  }));
  look();
  EXPECT_EQ(snapshot.lost_frames, 0U);
}

struct Cycles {
  std::vector<CycleSample> samples;
  std::size_t answers = 0, news = 0;
  Snapshot snapshot;
};

/// Four seconds in OP, with requests all the time or without any.
Cycles cycles(bool asking) {
  VirtualClock clock;
  MasterService service(test::two_axes().link(clock), clock);
  auto& channels = service.channels();
  channels.commands.push(GoOnlineCommand{test::two_axes().compiled(), AlState::kOp});
  service.run_for(5 * kSecond);
  Cycles result;
  std::vector<CycleSample> before;
  channels.samples.pop(before);
  (void)channels.events.drain();
  RequestId id = 0;
  for (int step = 0; step < 4000; ++step) {
    if (asking && id == 0) {
      const auto next = channels.requests.submit(step % 2 == 0 ? SlaveRequest(SdoRead{kServo, {0x1008, 0}})
                                                               : SlaveRequest(EepromRead{kOther, 0, 16}));
      if (next) id = *next;
    }
    service.step();
    if (id != 0 && channels.requests.take(id)) {
      id = 0;
      ++result.answers;
    }
    if (step % 100 == 0) channels.samples.pop(result.samples);
  }
  channels.samples.pop(result.samples);
  result.news = channels.events.drain().size();
  channels.snapshot.read(result.snapshot);
  return result;
}

TEST(CyclesWithRequests, AreThoseWithout) {
  const auto quiet = cycles(false), busy = cycles(true);
  EXPECT_GT(busy.answers, 50U);
  EXPECT_EQ(busy.news, quiet.news);
  ASSERT_EQ(busy.samples.size(), quiet.samples.size());
  std::int32_t largest_quiet = 0, largest_busy = 0;
  for (std::size_t i = 0; i < busy.samples.size(); ++i) {
    const auto &with = busy.samples[i], &without = quiet.samples[i];
    EXPECT_EQ(with.cycle, without.cycle);
    EXPECT_EQ(with.frames_lost, 0);
    EXPECT_EQ(with.skipped_cycles, 0);
    EXPECT_EQ(with.wkc_received, without.wkc_received);
    EXPECT_EQ(with.wake_lateness_ns, without.wake_lateness_ns);
    EXPECT_EQ(with.slaves_sync, without.slaves_sync);
    largest_quiet = std::max(largest_quiet, std::abs(without.slave_deviation_ns));
    largest_busy = std::max(largest_busy, std::abs(with.slave_deviation_ns));
  }
  EXPECT_LE(largest_busy, largest_quiet + 10) << "a clock's grain";
}

TEST(RunningCycleWithRequests, NeitherAllocatesNorLocks) {
  VirtualClock clock;
  const auto network = test::two_axes();
  MasterService service(std::make_unique<test::UncountedLink>(network.link(clock)), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  service.run_for(5 * kSecond);
  auto& desk = service.channels().requests;
  std::map<RequestId, std::string> open;
  const std::vector<SlaveRequest> all{SdoRead{kServo, {0x1008, 0}},
                                      SdoRead{kServo, {0x5FFF, 0}},
                                      SdoWrite{kServo, {0x60C2, 1}, {2}},
                                      ObjectListRead{kServo},
                                      ObjectRead{kServo, 0x1018},
                                      EntryRead{kServo, 0x1018, 1},
                                      RegisterRead{kOther, 0, 1024},
                                      RegisterWrite{kOther, 0x0F80, Bytes(16)},
                                      EepromRead{kOther, 0, 64},
                                      EepromWrite{kOther, 0x30, Bytes(8, 3)},
                                      FileWrite{kOther, "f", 0, Bytes(500)},
                                      FileRead{kOther, "none"},
                                      FileRead{kOther, "f"}};
  for (const auto& request : all) {
    const auto id = desk.submit(request);
    ASSERT_TRUE(id);
    open[*id] = subject_of(request);
  }
  test::CycleCounts counts;
  for (int i = 0; i < 5000; ++i) {
    const test::CountingCycle counting(counts);
    service.step();
  }
  std::size_t answered = 0;
  for (const auto& [id, what] : open) {
    const bool back = desk.take(id).has_value();
    EXPECT_TRUE(back) << what;
    answered += back ? 1 : 0;
  }
  EXPECT_EQ(answered, all.size());
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.locks, 0U);
}

}  // namespace
}  // namespace syncline
