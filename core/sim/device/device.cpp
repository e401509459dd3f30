// SPDX-License-Identifier: Apache-2.0
#include "sim/device/device.h"

#include <algorithm>
#include <utility>

#include "families/device_family.h"
#include "families/families.h"
#include "protocol/diagnosis_message.h"
#include "protocol/registers.h"
#include "sim/device/device_objects.h"
#include "sim/esc/esc_events.h"

namespace syncline::sim {

using namespace esc_events;

namespace {

constexpr Nanoseconds kFirmwareReaction = 150 * kMicrosecond;  // to an AL request
constexpr std::uint16_t kStatusCodeType = 0x0006;              // data type of CoE
constexpr Nanoseconds kMailboxReaction = 250 * kMicrosecond;
constexpr Nanoseconds kLongestWaitForSync = 200 * kMillisecond;
constexpr unsigned kMaxObjects = 64;

// Emergency codes and error registers (ETG.1020; CiA 301).
constexpr std::uint16_t kPreopToSafeopFailed = 0xA000, kSafeopToOpFailed = 0xA001;
constexpr std::uint8_t kCommunicationErrorRegister = 0x11, kDeviceErrorRegister = 0x81;

constexpr std::uint16_t kIdentificationRequest = 0x0020;  // AL control and AL status, bit 5
constexpr std::size_t kBootStrapSize = 8;

bool is_allowed(AlState from, AlState to) {
  if (to == AlState::kInit || to == from) return true;
  switch (to) {
    case AlState::kPreop:
      return from != AlState::kBoot;
    case AlState::kBoot:
      return from == AlState::kInit;
    case AlState::kSafeop:
      return from == AlState::kPreop || from == AlState::kOp;
    case AlState::kOp:
      return from == AlState::kSafeop;
    default:
      return false;
  }
}

/// Firmware can take at least what it assigns by itself.
unsigned most_objects(const SimSlaveConfig& config) {
  const auto* family = families::of_behaviour(config.behaviour);
  if (family != nullptr && family->objects.per_direction > 0) return family->objects.per_direction;
  std::size_t most = kMaxObjects;
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    std::size_t objects = 0;
    for (const auto& pdo : config.device.pdos(direction)) objects += pdo.sync_manager ? pdo.entries.size() : 0;
    most = std::max(most, objects);
  }
  return static_cast<unsigned>(most);
}

}  // namespace

Device::Device(const SimSlaveConfig& config, Esc& esc)
    : config_(config),
      esc_(esc),
      process_data_(identify(), dictionary_, esc, most_objects(config)),
      checks_(config_, esc, process_data_),
      mailbox_(dictionary_, config.device.mailbox.value_or(MailboxDescription{}), config.foe_password),
      handshake_(esc, mailbox_),
      history_(dictionary_) {
  if (dictionary_.find(diagnosis_history::kIndex, 0) != nullptr) history_.enable();
  esc_.set_listener(this);
  esc_.serve_promptly(true);
}

const DeviceDescription& Device::identify() {
  add_device_objects(config_, dictionary_);
  return config_.device;
}

void Device::refuse(AlState state, std::uint16_t code) {
  refused_state_ = state;
  refusal_code_ = code;
}

// ---- time --------------------------------------------------------------------------------------

void Device::tell_error(std::uint16_t error_code, std::uint8_t error_register, std::uint16_t text_id) {
  catch_up();
  if (!has_mailbox()) return;
  coe::Emergency emergency{error_code, error_register, {}};
  store_le(std::span(emergency.data).first(2), text_id);
  mailbox_.queue_emergency(emergency);
  DiagnosisMessage message;
  message.code = 0xE000U | static_cast<std::uint32_t>(error_code) << 16;  // ETG.1020: emergency code in the high word
  message.type = DiagnosisMessage::Type::kError;
  message.text_id = text_id;
  message.time_stamp = dc().system_time(now());
  message.parameters = {{kStatusCodeType, le_bytes(text_id)}};  // the texts of our ESI files show it
  history_.add(message);
  process_data_.forget_objects();
  if (mail_due_ == kNever) mail_due_ = now() + kMailboxReaction;
  esc_.wake_up();
}

void Device::run_until(Nanoseconds time) {
  catch_up();
  if (time >= std::min(request_due_, mail_due_) && !stopped_) answer_until(time);
  esc_.advance_to(time);
  now_ = std::max(now_, time);
  if (state_ == AlState::kOp && !stopped_) stay_in_op(time);
  if (state_ == AlState::kOp && !stopped_) {
    if (!minds_inputs_read()) esc_.leave_transfers_unminded(process_data_.buffered_inputs());
    if (rests()) rest();
    if (const auto calculation = repeats()) repeat(*calculation, time);
  }
  if (!esc_.repeats_cycles()) esc_.stay_idle_until(idle_until());
}

void Device::repeat(Nanoseconds calculation, Nanoseconds time) {
  const auto& outputs = process_data_.sync_managers(PdoDirection::kRx);
  const auto inputs = process_data_.input_managers(), buffered = process_data_.buffered_managers();
  const bool busy =
      std::min(request_due_, mail_due_) != kNever || minds_inputs_read() || sees_frames_ || esc_.device_emulation();
  if (busy || outputs.size() != 1 || (buffered >> outputs.front() & 1U) == 0 || (inputs & ~buffered) != 0) return;
  if (!process_data_.inputs_stay() || !process_data_.outputs_stay()) return;
  esc_.repeat_cycles({.outputs = outputs.front(), .renewed = inputs, .calculation = calculation}, time);
}

void Device::rest() {
  const auto renewed = process_data_.input_managers();
  if (last_sync0_ && !esc_.device_emulation()) esc_.leave_signals_unminded(renewed);
  // Without a mailbox nobody can ask what outputs are in the dictionary.
  if (has_mailbox() || (needs_outputs() && !last_outputs_)) return;
  esc_.leave_transfers_unminded(process_data_.buffered_managers());
  const auto outputs = process_data_.sync_manager(PdoDirection::kRx);
  if (outputs && !dc().sync0_enabled()) esc_.renew_at_transfers(*outputs, renewed);
}

Nanoseconds Device::idle_until() {
  if (sees_frames_) return INT64_MIN;
  if (stopped_) return kNever;
  const auto due = std::min(request_due_, mail_due_);
  return state_ == AlState::kOp ? std::min({due, sync_patience(), runs_alone_until()}) : due;
}

Nanoseconds Device::sync_patience() const {
  return sync0_cycle_ > 0 && last_sync0_ && !dc().signals_unminded() ? *last_sync0_ + kMissingSyncs * sync0_cycle_ + 1
                                                                     : kNever;
}

void Device::silence_mailbox(bool silent) {
  mailbox_silent_ = silent;
  // What came meanwhile lies there, and nobody can write over it: no further event tells of it.
  if (!silent && mail_due_ == kNever) mail_due_ = now() + kMailboxReaction;
  esc_.wake_up();
}

void Device::stop_application(Nanoseconds time) {
  catch_up();
  if (std::exchange(stopped_, true)) return;
  esc_.serve_promptly(false);
  esc_.pdi_stops(std::max(now(), time));
}

void Device::resume_application(Nanoseconds time) {
  if (!std::exchange(stopped_, false)) return;
  esc_.serve_promptly(true);
  esc_.wake_up();
  esc_.pdi_works();
  const auto then = std::max(now(), time);
  for (auto* due : {&request_due_, &mail_due_}) {
    if (*due != kNever) *due = std::max(*due, then);
  }
  // Who stood still has not counted the SYNC0 that did not come to him; the next one is due any time.
  if (last_sync0_) last_sync0_ = std::max(*last_sync0_, then);
  on_resumed(then);
  if (state_ == AlState::kOp && esc_.outputs_expired()) process_data_watchdog_expired(then);
}

void Device::answer_until(Nanoseconds time) {
  while (!stopped_) {
    const auto next = std::min(request_due_, mail_due_);
    if (next > time || next == kNever) break;
    esc_.advance_to(next);
    esc_.wake_up();  // what follows may be seen at the next SYNC0
    now_ = std::max(now_, next);
    if (request_due_ <= mail_due_) {
      request_due_ = kNever;
      take_request(next);
    } else {
      mail_due_ = kNever;
      answer_mail();
    }
  }
}

void Device::stay_in_op(Nanoseconds time) {
  check_running(time);
  // The signal was there when OP was entered; a unit that was switched off or has lost its time fires no more.
  if (state_ == AlState::kOp && time >= sync_patience()) drop_to_safeop(al_code::kSyncStopped);
}

// ---- AL state machine ----------------------------------------------------------------------------

void Device::al_control_written(Nanoseconds time) {
  if (esc_.device_emulation()) {
    const auto control = esc_.al().control();
    state_ = al_state_of(control);
    esc_.al().set_status(control & 0x000F);
    if (exchanges_process_data()) process_data_.map();
    on_state(state_);
    return;
  }
  requested_at_ = time;
  request_due_ = time + kFirmwareReaction;
}

void Device::report(AlState state, std::uint16_t code) {
  error_ = code != 0;
  const auto status = static_cast<std::uint16_t>(static_cast<unsigned>(state) | (error_ ? kAlErrorFlag : 0U));
  esc_.al().set_code(code);
  esc_.al().set_status(status);
  esc_.tell_al_status();
}

/// OP needs SYNC0: the answer waits for the first one as long as it may still come.
bool Device::waits_for_sync(Nanoseconds waited) const {
  const auto& unit = dc();
  return unit.sync0_enabled() && !last_sync0_ && !unit.start_missed() && waited < kLongestWaitForSync &&
         (!needs_outputs() || last_outputs_);
}

void Device::take_request(Nanoseconds time) {
  esc_.acknowledge_events(kAlEventControl);
  const auto control = esc_.al().control();
  const bool acknowledge = (control & kAlErrorFlag) != 0;
  const auto wanted = al_state_of(control);
  if (error_ && !acknowledge) return;  // nothing is executed until the error is acknowledged
  switch (wanted) {
    case AlState::kInit:
    case AlState::kPreop:
    case AlState::kSafeop:
    case AlState::kOp:
      break;
    case AlState::kBoot:
      if (config_.device.eeprom.boot_strap.size() >= kBootStrapSize) break;
      return report(state_, al_code::kNoBoot);
    default:
      return report(state_, al_code::kUnknownRequest);
  }
  const auto refuse_with = [&](std::uint16_t code) {
    report(state_, code);
    if (state_ == AlState::kPreop && wanted == AlState::kSafeop)
      tell_error(kPreopToSafeopFailed, kDeviceErrorRegister, code);
    if (state_ == AlState::kSafeop && wanted == AlState::kOp) tell_error(kSafeopToOpFailed, kDeviceErrorRegister, code);
  };
  if (!is_allowed(state_, wanted)) return refuse_with(al_code::kInvalidRequest);
  if (wanted == refused_state_ && refusal_code_ != 0) return refuse_with(refusal_code_);
  const auto waited = time - requested_at_;
  if (state_ < wanted && ((wanted == AlState::kOp && waits_for_sync(waited)) || settling(wanted, waited))) {
    request_due_ = time + kMillisecond;  // asks itself again
    return;
  }
  if (const auto code = check(state_, wanted); code != 0) return refuse_with(code);
  enter(wanted);
  report(state_, 0);
  // Explicit device identification: the answer stands where the AL status code would (ETG.1020, 18.4.1).
  if ((control & kIdentificationRequest) != 0) {
    esc_.al().set_status(static_cast<std::uint16_t>(esc_.al().status() | kIdentificationRequest));
    esc_.al().set_code(config_.device_id);
  }
}

void Device::enter(AlState state) {
  const auto from = state_;
  state_ = state;
  if (state == AlState::kInit) mailbox_.reset();
  if (state == AlState::kInit || state == AlState::kPreop) last_sync0_.reset();
  if (from == AlState::kInit && state == AlState::kPreop) checks_.note_mailbox();
  if (state == AlState::kOp) sync0_cycle_ = dc().sync0_enabled() ? dc().settings().cycle0 : 0;
  if (from == AlState::kPreop && state == AlState::kSafeop) {
    process_data_.map();
    checks_.note_process_data();
    last_outputs_.reset();
  }
  on_state(state);
}

std::uint16_t Device::check(AlState from, AlState to) {
  if (to == AlState::kBoot) return checks_.bootstrap();
  if (to <= from) return 0;
  if (to == AlState::kPreop) return checks_.mailbox();
  if (to == AlState::kSafeop) {
    const auto code = checks_.safeop();
    return code != 0 ? code : check_sync(to);
  }
  if (needs_outputs() && !last_outputs_) return al_code::kNoOutputs;
  if (const auto code = checks_.op(); code != 0) return code;
  if (const auto code = check_sync(to); code != 0) return code;
  return dc().sync0_enabled() && !last_sync0_ ? al_code::kNoSync : std::uint16_t{0};
}

void Device::drop_to_safeop(std::uint16_t code, std::uint16_t error_code) {
  if (state_ != AlState::kOp) return;
  esc_.wake_up();
  state_ = AlState::kSafeop;
  report(state_, code);
  tell_error(error_code, kCommunicationErrorRegister, code);
  on_state(state_);
}

void Device::process_data_watchdog_expired(Nanoseconds) {
  if (stopped_) return;
  esc_.acknowledge_events(kAlEventWatchdog);
  if (esc_.device_emulation()) {
    // Digital outputs are the ESC's own: it switches them off itself (ESC data sheet II, 3.8).
    for (const unsigned number : process_data_.sync_managers(PdoDirection::kRx)) {
      std::ranges::fill(esc_.sync_manager_area(number), std::uint8_t{0});
    }
    return;
  }
  process_data_.clear_outputs();
  drop_to_safeop(al_code::kWatchdog);
}

void Device::sync_manager_written(unsigned number, Nanoseconds time) {
  if (number == 0 && has_mailbox()) {
    mail_due_ = time + kMailboxReaction + mailbox_delay_;
    esc_.wake_up();
  } else if (!stopped_ && exchanges_process_data() && process_data_.take_outputs(number, state_ == AlState::kOp)) {
    // The device works by its first SyncManager; further ones (safety) come with it.
    last_outputs_ = time;
    on_outputs(time);
  }
}

void Device::sync_manager_read(unsigned number, Nanoseconds time) {
  if (number == 1 && has_mailbox() && mailbox_.waiting()) {
    mail_due_ = time + kMailboxReaction;
    esc_.wake_up();
  }
  if (!stopped_ && exchanges_process_data() && process_data_.carries(PdoDirection::kTx, number)) {
    if (process_data_.leads(number)) on_inputs_read(time);
    process_data_.offer_inputs(number);
  }
}

void Device::sync_manager_set(unsigned number, Nanoseconds time) {
  if (!stopped_) esc_.acknowledge_events(kAlEventSyncManagerSet);
  if (has_mailbox() && number == 1 && esc_.repeat_requested(1)) mail_due_ = time + kMailboxReaction;
}

void Device::sync_signal(SyncGenerator::Signal signal, Nanoseconds time) {
  if (stopped_) return;
  if (!esc_.device_emulation()) esc_.acknowledge_sync(signal);
  if (signal == SyncGenerator::Signal::kSync0) last_sync0_ = time;
  if (signal == SyncGenerator::Signal::kSync0) on_sync0(time);
  if (signal == SyncGenerator::Signal::kSync1) on_sync1(time);
}

void Device::answer_mail() {
  process_data_.forget_objects();
  if (!mailbox_silent_ && state_ != AlState::kInit) handshake_.serve(state_ == AlState::kPreop);
}

}  // namespace syncline::sim
