// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/can_gateway.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kInconsistentSettings = 0x0026;   // AL status code
constexpr std::uint8_t kNodeInTime = 0x00, kNodeTooLate = 0x28;
constexpr std::uint32_t kCanFrame = 130 * kMicrosecond;   // 8 data bytes at 1 Mbit/s, stuff bits included
constexpr std::uint32_t kCanCycle = 300 * kMicrosecond;   // output, SYNC and input message

// 0xF800: parameters of the CAN bus; times in ns.
constexpr std::uint16_t kParameters = 0xF800;
constexpr std::uint8_t kCycleTime = 4, kTxPdoDelay = 5, kInputShift = 6, kBusOccupied = 7;

constexpr std::uint16_t kSyncObject = 0x1C32;
constexpr std::uint8_t kSyncType = 0x01, kBusCycle = 0x02, kCycleExceeded = 0x0B;

constexpr std::uint16_t kOutputs = 0x7000, kInputs = 0x6000, kDiagnosis = 0xA000;
constexpr std::uint8_t kNodeState = 1, kSyncMessages = 2;

}  // namespace

CanGateway::CanGateway(const SimSlaveConfig& config, Esc& esc) : Device(config, esc) {
  auto& d = dictionary_;
  d.set_object_name(kParameters, "CAN bus parameters");
  d.add<std::uint8_t>(kParameters, 0, "Number of parameters", kBusOccupied);
  const auto parameter = [&](std::uint8_t sub_index, const char* name, std::uint32_t value) {
    d.add<std::uint32_t>(kParameters, sub_index, name, value, true).preop_only = true;
  };
  parameter(kCycleTime, "Cycle time", 0);
  parameter(kTxPdoDelay, "TxPDO delay", 0);
  parameter(kInputShift, "Input shift time", 0);
  parameter(kBusOccupied, "Time that a cycle occupies the bus", kCanCycle);
  d.set_object_name(kSyncObject, "SM output parameter");
  d.add<std::uint8_t>(kSyncObject, 0, "Number of parameters", kCycleExceeded);
  d.add<std::uint16_t>(kSyncObject, kSyncType, "Synchronization type", 1, true).preop_only = true;
  d.add<std::uint32_t>(kSyncObject, kBusCycle, "Cycle time", 0, true);
  d.add<std::uint16_t>(kSyncObject, kCycleExceeded, "Cycle exceeded counter", 0);
}

std::uint16_t CanGateway::check_sync(AlState) {
  const auto& dc = esc().dc();
  const auto bus = dc.sync0_enabled() ? dc.settings().cycle0 : dictionary_.get<std::uint32_t>(kSyncObject, kBusCycle);
  const auto can = dictionary_.get<std::uint32_t>(kParameters, kCycleTime);
  multiplier_ = 1;
  if (can == 0) return 0;
  // Without DC the gateway knows the bus cycle from the master's start-up list only.
  if (bus == 0 || can % bus != 0) return kInconsistentSettings;
  multiplier_ = can / bus;
  return 0;
}

void CanGateway::on_state(AlState state) {
  const auto& dc = esc().dc();
  if (state == AlState::kSafeop && dc.sync0_enabled()) {
    dictionary_.set<std::uint16_t>(kSyncObject, kSyncType, dc.settings().sync1 ? 3 : 2);
    dictionary_.set<std::uint32_t>(kSyncObject, kBusCycle, dc.settings().cycle0);
  }
  if (state != AlState::kOp) return;
  bus_cycles_ = 0;
  busy_until_ = 0;
  latch_at_.reset();
  sync_due_.reset();
  answer_at_.reset();
  dictionary_.set<std::uint16_t>(kSyncObject, kCycleExceeded, 0);
}

void CanGateway::on_outputs(Nanoseconds time) {
  if (!esc().dc().sync0_enabled()) bus_cycle(time);
}

void CanGateway::on_inputs_read(Nanoseconds time) {
  if (!has_outputs() && !esc().dc().sync0_enabled()) bus_cycle(time);
}

void CanGateway::on_sync0(Nanoseconds time) { bus_cycle(time); }

void CanGateway::on_sync1(Nanoseconds time) {
  if (sync_due_) send_sync_message(time);
}

void CanGateway::bus_cycle(Nanoseconds time) {
  if (state() != AlState::kOp || bus_cycles_++ % multiplier_ != 0) return;
  if (time < busy_until_) {
    const auto count = dictionary_.get<std::uint16_t>(kSyncObject, kCycleExceeded);
    dictionary_.set(kSyncObject, kCycleExceeded, static_cast<std::uint16_t>(count + 1));
    return;
  }
  if (answer_at_) latch_inputs(time);
  busy_until_ = time + dictionary_.get<std::uint32_t>(kParameters, kBusOccupied);
  const auto shift = dictionary_.get<std::uint32_t>(kParameters, kInputShift);
  latch_at_ = shift == 0 ? std::nullopt : std::optional(time + shift);
  sent_ = dictionary_.get<std::uint32_t>(kOutputs, 1);
  sync_due_ = time;
  if (!esc().dc().settings().sync1) send_sync_message(time);
}

void CanGateway::send_sync_message(Nanoseconds time) {
  sync_due_.reset();
  const auto count = dictionary_.get<std::uint8_t>(kDiagnosis, kSyncMessages);
  dictionary_.set(kDiagnosis, kSyncMessages, static_cast<std::uint8_t>(count + 1));
  answer_at_ = time + dictionary_.get<std::uint32_t>(kParameters, kTxPdoDelay) + kCanFrame;
}

void CanGateway::latch_inputs(Nanoseconds time) {
  const bool in_time = *answer_at_ <= latch_at_.value_or(time);
  if (in_time) dictionary_.set(kInputs, 1, sent_);
  dictionary_.set(kDiagnosis, kNodeState, in_time ? kNodeInTime : kNodeTooLate);
  answer_at_.reset();
  latch_at_.reset();
  inputs_from_dictionary();
}

void CanGateway::check_running(Nanoseconds time) {
  if (answer_at_ && latch_at_ && time >= *latch_at_) latch_inputs(time);
}

}  // namespace syncline::sim
