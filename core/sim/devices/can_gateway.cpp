// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/can_gateway.h"

#include "families/families.h"

namespace syncline::sim {
namespace {

constexpr std::uint8_t kNodeInTime = 0x00;
constexpr std::uint32_t kCanFrame = 130 * kMicrosecond;  // 8 data bytes at 1 Mbit/s, stuff bits included
constexpr std::uint32_t kCanCycle = 300 * kMicrosecond;  // output, SYNC and input message
constexpr Nanoseconds kSyncMessage = 47 * kMicrosecond;  // 0 data bytes
constexpr Nanoseconds kPreparation =
    20 * kMicrosecond;  // up to this, of the transmit PDOs in front of the SYNC message

// 0xF800: parameters of the CAN bus as in the ESI of an EL6751. :07 and :08 are something else there: with us they say
// how long a cycle occupies the bus (ns), and that the node has asynchronous PDOs.
constexpr std::uint8_t kCycleTime = 0x04, kBusOccupied = 0x07, kAsynchronous = 0x08, kTxPdoDelay = 0x0E;

constexpr std::uint16_t kOutputs = 0x7000, kInputs = 0x6000, kDiagnosis = 0xA000;
constexpr std::uint8_t kNodeState = 1, kSyncMessages = 2;

const families::Family& gateway_family() {
  static const families::Family& found = *families::of_behaviour("can-gateway");
  return found;
}
const families::CanGateway& objects() { return *gateway_family().gateway; }
std::uint16_t parameters() { return objects().can_cycle.index; }

SyncHabits habits() {
  constexpr std::uint16_t kDynamic = 0x8000;  // of the EL6751's ESI, with the others
  SyncHabits habits(gateway_family(),
                    SyncHabits::kFreeRun | SyncHabits::kSyncManager | SyncHabits::kSync0 | SyncHabits::kLocalShift |
                        SyncHabits::kMeasures | kDynamic,
                    static_cast<std::uint32_t>(gateway_family().cycle->shortest));
  habits.cycle_writable = true;
  return habits;
}

}  // namespace

CanGateway::CanGateway(const SimSlaveConfig& config, Esc& esc)
    : Device(config, esc),
      outputs_sync_(dictionary_, SyncObject::kOutputs, habits()),
      inputs_sync_(dictionary_, SyncObject::kInputs, habits()) {
  outputs_sync_.set_type(SyncType::kOwnSyncManager);
  inputs_sync_.set_type(SyncType::kSyncManager2);
  add_parameters();
}

void CanGateway::add_parameters() {
  auto& d = dictionary_;
  const auto add = [&](std::uint8_t sub_index, const char* name, auto value) {
    d.add(parameters(), sub_index, name, value, true).preop_only = true;
  };
  d.set_object_name(parameters(), "CAN Bus Parameter Set");
  d.add<std::uint8_t>(parameters(), 0, "Number of entries", kTxPdoDelay);
  add(0x01, "Master Node Address", std::uint8_t{0});
  add(0x02, "Baudrate", std::uint8_t{0});
  add(0x03, "COB ID SYNC", std::uint16_t{0});
  add(kCycleTime, "SYNC cycle time", std::uint32_t{0});
  add(0x05, "Bustiming registers", std::uint32_t{0});
  add(kBusOccupied, "Time that a cycle occupies the bus", kCanCycle);
  add(kAsynchronous, "Node has asynchronous PDOs", std::uint32_t{0});
  add(kTxPdoDelay, "Delay for sending synchronous RxPDOs in %", std::uint8_t{0});
  d.find(parameters(), kTxPdoDelay)->on_write = [](std::span<const std::uint8_t> data) {
    return data[0] <= 100 ? abort::kNone : abort::kRange;
  };
  d.set_object_name(objects().node_states, "Node states");
  d.add<std::uint8_t>(objects().node_states, 0, "Number of entries", 1);
  d.add<std::uint8_t>(objects().node_states, 1, "State of node 1", kNodeInTime);
}

Nanoseconds CanGateway::parameter(std::uint8_t sub_index) {
  return dictionary_.get<std::uint32_t>(parameters(), sub_index);
}

/// From the SYNC message to the first synchronous RxPDO: a part of the CAN cycle.
Nanoseconds CanGateway::tx_pdo_delay() {
  const Nanoseconds percent = dictionary_.get<std::uint8_t>(parameters(), kTxPdoDelay);
  return bus_cycle_ns_ * static_cast<Nanoseconds>(multiplier_) * percent / 100;
}

Nanoseconds CanGateway::vary(Nanoseconds largest) {
  noise_ = noise_ * 1'664'525U + 1'013'904'223U;
  return static_cast<Nanoseconds>(noise_ >> 16) * largest / 0xFFFF;
}

// ---- AL state ------------------------------------------------------------------------------------

std::uint16_t CanGateway::check_sync(AlState) {
  const auto& unit = dc();
  // Without DC the gateway knows the bus cycle from the master's start-up list only.
  const Nanoseconds bus = unit.sync0_enabled() ? unit.settings().cycle0 : outputs_sync_.cycle();
  if (unit.sync0_enabled()) {
    if (bus < gateway_family().cycle->shortest) return al_code::kCycleTooSmall;
    if (outputs_sync_.contradicts(unit.settings().cycle0)) return al_code::kInvalidSyncCycle;
  }
  const auto can = parameter(kCycleTime);
  bus_cycle_ns_ = bus;
  multiplier_ = 1;
  if (can == 0 || bus == 0) return 0;
  if (can % bus != 0) return al_code::kInconsistentSettings;
  if (parameter(kAsynchronous) == 0) multiplier_ = static_cast<std::uint32_t>(can / bus);
  return 0;
}

void CanGateway::on_state(AlState state) {
  const auto& unit = dc();
  if (state == AlState::kInit) outputs_sync_.forget_told_cycle();
  if (state == AlState::kSafeop) {
    const bool sync0 = unit.sync0_enabled();
    outputs_sync_.set_type(sync0 ? SyncType::kSync0 : SyncType::kOwnSyncManager);
    inputs_sync_.set_type(sync0           ? SyncType::kSync0
                          : has_outputs() ? SyncType::kSyncManager2
                                          : SyncType::kOwnSyncManager);
    for (auto* object : {&outputs_sync_, &inputs_sync_}) {
      if (sync0) object->set_cycle(unit.settings().cycle0);
      object->set_sync0_cycle(sync0 ? unit.settings().cycle0 : 0);
    }
  }
  if (state != AlState::kOp) return;
  bus_cycles_ = 0;
  busy_until_ = 0;
  fresh_outputs_ = unchecked_ = check_at_next_ = false;
  update_at_.reset();
  check_at_.reset();
  sync_due_.reset();
  answer_at_.reset();
  outputs_sync_.clear_counters();
  inputs_sync_.clear_counters();
}

// ---- triggers ------------------------------------------------------------------------------------

void CanGateway::on_outputs(Nanoseconds time) {
  fresh_outputs_ = true;
  if (!dc().sync0_enabled()) bus_cycle(time);
}

void CanGateway::on_inputs_read(Nanoseconds time) {
  if (!has_outputs() && !dc().sync0_enabled()) bus_cycle(time);
}

void CanGateway::on_sync0(Nanoseconds time) {
  if (state() == AlState::kOp && has_outputs()) {
    if (!fresh_outputs_) outputs_sync_.count_missed();
    outputs_sync_.set_sync_error(!fresh_outputs_);
  }
  fresh_outputs_ = false;
  bus_cycle(time);
}

void CanGateway::on_sync1(Nanoseconds time) {
  if (sync_due_) send_sync_message(time + vary(objects().sync1_jitter));
}

void CanGateway::bus_cycle(Nanoseconds time) {
  if (state() != AlState::kOp) return;
  check_running(time);
  if (parameter(kAsynchronous) != 0) return asynchronous_cycle(time);
  const Nanoseconds shift = inputs_sync_.shift();
  const auto number = bus_cycles_++ % multiplier_;
  if (number == 0) {
    synchronous_cycle(time);
    if (multiplier_ > 1 && answer_at_ && shift > 0) update_at_ = time + shift;
  }
  // In the last bus cycle of the CAN cycle the answers are looked for.
  if (number + 1 == multiplier_ && unchecked_) {
    if (shift > 0) {
      check_at_ = time + shift;
    } else {
      check_at_next_ = true;
    }
  }
}

void CanGateway::synchronous_cycle(Nanoseconds time) {
  if (time < busy_until_) {
    (has_outputs() ? outputs_sync_ : inputs_sync_).count_exceeded();
    return;
  }
  if (check_at_next_) check_node(time);
  const auto times = outputs_sync_.next_cycle(application_delay());
  busy_until_ = time + parameter(kBusOccupied) + application_delay();
  sent_ = dictionary_.get<std::uint32_t>(kOutputs, 1);
  sync_due_ = time;
  unchecked_ = true;
  if (!dc().settings().sync1) {
    send_sync_message(time + vary(kPreparation));
  } else if (dc().settings().cycle1 < times.calc_and_copy) {
    outputs_sync_.count_shift_too_short();  // SYNC1 comes before the transmit PDOs are prepared
  }
}

/// Data that have changed are sent, and what came since the last cycle is taken; no SYNC messages.
void CanGateway::asynchronous_cycle(Nanoseconds time) {
  update_inputs(time);
  const auto wanted = dictionary_.get<std::uint32_t>(kOutputs, 1);
  if (wanted == sent_ || time < busy_until_) return;
  sent_ = wanted;
  busy_until_ = time + kCanFrame;
  answer_at_ = time + 2 * static_cast<Nanoseconds>(kCanFrame);
}

void CanGateway::send_sync_message(Nanoseconds time) {
  sync_due_.reset();
  const auto count = dictionary_.get<std::uint8_t>(kDiagnosis, kSyncMessages);
  dictionary_.set(kDiagnosis, kSyncMessages, static_cast<std::uint8_t>(count + 1));
  can_sync_.pulse(time, time + kSyncMessage);
  answer_at_ = time + tx_pdo_delay() + kCanFrame;
}

// ---- inputs --------------------------------------------------------------------------------------

void CanGateway::update_inputs(Nanoseconds time) {
  if (answer_at_ && *answer_at_ <= time) {
    dictionary_.set(kInputs, 1, sent_);
    answer_at_.reset();
  }
  inputs_from_dictionary();
}

void CanGateway::check_node(Nanoseconds time) {
  check_at_.reset();
  unchecked_ = check_at_next_ = false;
  const bool too_late = sync_due_ || (answer_at_ && *answer_at_ > time);
  set_node_state(too_late ? objects().node_late : kNodeInTime);
  update_inputs(time);
  answer_at_.reset();
}

void CanGateway::set_node_state(std::uint8_t state) {
  dictionary_.set(kDiagnosis, kNodeState, state);
  dictionary_.set(objects().node_states, 1, state);
}

void CanGateway::check_running(Nanoseconds time) {
  if (update_at_ && time >= *update_at_) {
    update_inputs(*update_at_);
    update_at_.reset();
  }
  if (check_at_ && time >= *check_at_) check_node(*check_at_);
}

}  // namespace syncline::sim
