// SPDX-License-Identifier: Apache-2.0
#include "sim/device.h"

#include <algorithm>

#include "protocol/registers.h"
#include "sim/sii_from_device.h"

namespace syncline::sim {
namespace {

constexpr Nanoseconds kFirmwareReaction = 150 * kMicrosecond;  // to an AL request
constexpr Nanoseconds kMailboxReaction = 250 * kMicrosecond;
constexpr unsigned kMaxObjects = 64;
constexpr unsigned kServoMaxObjects = 16;

constexpr std::uint16_t kInvalidRequest = 0x0011, kUnknownRequest = 0x0012, kNoBoot = 0x0013, kInvalidMailbox = 0x0016,
                        kInvalidSyncManager = 0x0017, kNoOutputs = 0x0019, kWatchdog = 0x001B,
                        kInvalidOutputs = 0x001D, kInvalidInputs = 0x001E, kInvalidBootMailbox = 0x0015,
                        kInvalidSyncConfiguration = 0x0030;

// Emergency codes and error registers (ETG.1020; CiA 301).
constexpr std::uint16_t kPreopToSafeopFailed = 0xA000, kSafeopToOpFailed = 0xA001;
constexpr std::uint8_t kCommunicationErrorRegister = 0x11, kDeviceErrorRegister = 0x81;

// Bits of the AL event request (0x0220).
constexpr std::uint32_t kAlEventControl = 0x01, kAlEventSyncManagerSet = 0x10, kAlEventWatchdog = 0x40,
                        kAlEventSyncManager0 = 0x100;

constexpr std::uint16_t kIdentificationRequest = 0x0020;  // AL control and AL status, bit 5
constexpr std::size_t kBootStrapSize = 8;

bool is_allowed(AlState from, AlState to) {
  if (to == AlState::kInit || to == from) return true;
  switch (to) {
    case AlState::kPreop: return from != AlState::kBoot;
    case AlState::kBoot: return from == AlState::kInit;
    case AlState::kSafeop: return from == AlState::kPreop || from == AlState::kOp;
    case AlState::kOp: return from == AlState::kSafeop;
    default: return false;
  }
}

std::size_t size_of(std::uint8_t bits) { return (bits + 7U) / 8U; }

}  // namespace

Device::Device(const SimSlaveConfig& config, Esc& esc)
    : config_(config),
      esc_(esc),
      pdos_(identify(), dictionary_, config.behaviour == "servo-y" ? kServoMaxObjects : kMaxObjects),
      mailbox_(dictionary_, config.device.mailbox.value_or(MailboxDescription{}), config.foe_password),
      history_(dictionary_) {
  if (dictionary_.find(diagnosis_history::kIndex, 0) != nullptr) history_.enable();
  esc_.set_listener(this);
}

const DeviceDescription& Device::identify() {
  const auto& device = config_.device;
  dictionary_.add<std::uint32_t>(0x1000, 0, "Device type", device.profiles.empty() ? 0 : device.profiles[0].profile_no);
  constexpr std::uint16_t kVisibleString = 0x09;
  dictionary_.add(0x1008, 0, "Device name", std::vector<std::uint8_t>(device.type.begin(), device.type.end())).data_type =
      kVisibleString;
  const auto managers = std::min<std::size_t>(device.sync_managers.size(), 32);
  dictionary_.set_object_name(0x1C00, "Sync manager type");
  dictionary_.add(0x1C00, 0, "Number of entries", static_cast<std::uint8_t>(managers));
  for (std::size_t i = 0; i < managers; ++i) {
    dictionary_.add(0x1C00, static_cast<std::uint8_t>(i + 1), "Communication type",
                    static_cast<std::uint8_t>(device.sync_managers[i].type));
  }
  dictionary_.add<std::uint8_t>(0x1018, 0, "Identity", 4);
  dictionary_.add<std::uint32_t>(0x1018, 1, "Vendor ID", device.identity.vendor_id);
  dictionary_.add<std::uint32_t>(0x1018, 2, "Product code", device.identity.product_code);
  dictionary_.add<std::uint32_t>(0x1018, 3, "Revision", device.identity.revision_no);
  dictionary_.add<std::uint32_t>(0x1018, 4, "Serial number", config_.serial_no);
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    for (const auto& pdo : device.pdos(direction)) {
      for (const auto& entry : pdo.entries) {
        if (entry.index == 0 || dictionary_.find(entry.index, entry.sub_index) != nullptr) continue;
        auto& added = dictionary_.add(entry.index, entry.sub_index, entry.name,
                                      std::vector<std::uint8_t>((entry.bit_length + 7U) / 8U), direction == PdoDirection::kRx);
        added.bit_length = entry.bit_length;
        added.data_type = data_type_code(entry.data_type);
        added.extra_access = direction == PdoDirection::kRx ? coe::access::kRxPdo : coe::access::kTxPdo;
      }
    }
  }
  for (const auto& object : device.dictionary) {
    dictionary_.set_object_name(object.index, object.name);
    for (const auto& entry : object.entries) {
      if (dictionary_.find(object.index, entry.sub_index) != nullptr) continue;
      auto value = entry.default_data;
      value.resize(std::max<std::size_t>((entry.bit_length + 7U) / 8U, value.size()));
      auto& added = dictionary_.add(object.index, entry.sub_index, entry.name, std::move(value), entry.writable);
      added.bit_length = entry.bit_length;
      added.data_type = data_type_code(entry.data_type);
      added.readable = entry.readable || !entry.writable;
    }
  }
  return device;
}

void Device::refuse(AlState state, std::uint16_t code) {
  refused_state_ = state;
  refusal_code_ = code;
}

// ---- time --------------------------------------------------------------------------------------

void Device::tell_error(std::uint16_t error_code, std::uint8_t error_register, std::uint16_t text_id) {
  if (!has_mailbox()) return;
  coe::Emergency emergency{error_code, error_register, {}};
  store_le(std::span(emergency.data).first(2), text_id);
  mailbox_.queue_emergency(emergency);
  DiagnosisMessage message;
  message.code = 0xE000U | static_cast<std::uint32_t>(error_code) << 16;  // ETG.1020: emergency code in the high word
  message.type = DiagnosisMessage::Type::kError;
  message.text_id = text_id;
  message.time_stamp = esc_.dc().system_time(now_);
  history_.add(message);
  if (!mail_due_) mail_due_ = now_ + kMailboxReaction;
}

void Device::advance_to(Nanoseconds time) {
  for (;;) {
    const auto request = request_due_.value_or(INT64_MAX);
    const auto mail = mail_due_.value_or(INT64_MAX);
    const auto next = std::min(request, mail);
    if (next > time) break;
    esc_.advance_to(next);
    now_ = std::max(now_, next);
    if (request <= mail) {
      request_due_.reset();
      take_request(next);
    } else {
      mail_due_.reset();
      answer_mail(next);
    }
  }
  esc_.advance_to(time);
  now_ = std::max(now_, time);
  if (state_ == AlState::kOp) check_running(time);
}

// ---- AL state machine ----------------------------------------------------------------------------

void Device::al_control_written(Nanoseconds time) {
  if (esc_.device_emulation()) {
    const auto control = esc_.memory().u16(reg::kAlControl);
    state_ = al_state_of(control);
    esc_.memory().set<std::uint16_t>(reg::kAlStatus, control & 0x000F);
    if (state_ == AlState::kSafeop || state_ == AlState::kOp) map_process_data();
    on_state(state_);
    return;
  }
  request_due_ = time + kFirmwareReaction;
}

void Device::report(AlState state, std::uint16_t code) {
  error_ = code != 0;
  const auto status = static_cast<std::uint16_t>(static_cast<unsigned>(state) | (error_ ? kAlErrorFlag : 0U));
  esc_.memory().set<std::uint16_t>(reg::kAlStatusCode, code);
  esc_.memory().set<std::uint16_t>(reg::kAlStatus, status);
  esc_.memory().set<std::uint16_t>(reg::kEcatEventRequest,
                                   static_cast<std::uint16_t>(esc_.memory().u16(reg::kEcatEventRequest) | 0x0008));
}

void Device::take_request(Nanoseconds) {
  esc_.acknowledge_events(kAlEventControl);
  const auto control = esc_.memory().u16(reg::kAlControl);
  const bool acknowledge = (control & kAlErrorFlag) != 0;
  const auto wanted = al_state_of(control);
  if (error_ && !acknowledge) return;  // nothing is executed until the error is acknowledged
  switch (wanted) {
    case AlState::kInit:
    case AlState::kPreop:
    case AlState::kSafeop:
    case AlState::kOp: break;
    case AlState::kBoot:
      if (config_.device.eeprom.boot_strap.size() >= kBootStrapSize) break;
      return report(state_, kNoBoot);
    default: return report(state_, kUnknownRequest);
  }
  const auto refuse_with = [&](std::uint16_t code) {
    report(state_, code);
    if (state_ == AlState::kPreop && wanted == AlState::kSafeop) tell_error(kPreopToSafeopFailed, kDeviceErrorRegister, code);
    if (state_ == AlState::kSafeop && wanted == AlState::kOp) tell_error(kSafeopToOpFailed, kDeviceErrorRegister, code);
  };
  if (!is_allowed(state_, wanted)) return refuse_with(kInvalidRequest);
  if (wanted == refused_state_ && refusal_code_ != 0) return refuse_with(refusal_code_);
  if (const auto code = check(state_, wanted); code != 0) return refuse_with(code);
  enter(wanted);
  report(state_, 0);
  // Explicit device identification: the answer stands where the AL status code would (ETG.1020, 18.4.1).
  if ((control & kIdentificationRequest) != 0) {
    esc_.memory().set<std::uint16_t>(reg::kAlStatus,
                                     static_cast<std::uint16_t>(esc_.memory().u16(reg::kAlStatus) | kIdentificationRequest));
    esc_.memory().set<std::uint16_t>(reg::kAlStatusCode, config_.device_id);
  }
}

void Device::enter(AlState state) {
  const auto from = state_;
  state_ = state;
  if (state == AlState::kInit) mailbox_.reset();
  if (from == AlState::kPreop && state == AlState::kSafeop) {
    map_process_data();
    last_outputs_.reset();
  }
  on_state(state);
}

std::uint16_t Device::check(AlState from, AlState to) {
  if (to == AlState::kBoot) return check_bootstrap();
  if (to <= from) return 0;
  if (to == AlState::kPreop) return has_mailbox() ? check_mailbox() : 0;
  if (to == AlState::kSafeop) {
    if (const auto code = check_process_data(); code != 0) return code;
    if (const auto code = check_dc(); code != 0) return code;
    return check_sync(to);
  }
  if (output_sm_ && !last_outputs_ && pdos_.byte_length(PdoDirection::kRx) > 0) return kNoOutputs;
  return check_sync(to);
}

std::uint16_t Device::check_mailbox() const {
  for (unsigned i = 0; i < 2 && i < config_.device.sync_managers.size(); ++i) {
    const auto& wanted = config_.device.sync_managers[i];
    const auto sm = esc_.sync_manager(i);
    const bool size_fits = sm.length >= wanted.min_size.value_or(wanted.default_size.value_or(sm.length)) &&
                           sm.length <= wanted.max_size.value_or(wanted.default_size.value_or(sm.length));
    if (!sm.enabled() || !sm.is_mailbox() || sm.start != wanted.start_address || !size_fits) return kInvalidMailbox;
  }
  return 0;
}

std::uint16_t Device::check_bootstrap() const {
  const std::span<const std::uint8_t> area(config_.device.eeprom.boot_strap);
  for (unsigned i = 0; i < 2; ++i) {
    const auto sm = esc_.sync_manager(i);
    if (!sm.enabled() || !sm.is_mailbox() || sm.start != load_le<std::uint16_t>(area.subspan(4 * i)) ||
        sm.length != load_le<std::uint16_t>(area.subspan(4 * i + 2))) {
      return kInvalidBootMailbox;
    }
  }
  return 0;
}

std::optional<unsigned> Device::find_sync_manager(SyncManagerType type) const {
  const auto& managers = config_.device.sync_managers;
  for (unsigned i = 0; i < managers.size(); ++i) {
    if (managers[i].type == type) return i;
  }
  return std::nullopt;
}

std::uint16_t Device::check_process_data() {
  const auto fits = [this](std::optional<unsigned> number, PdoDirection direction) {
    const auto bytes = pdos_.byte_length(direction);
    if (!number) return bytes == 0;
    const auto sm = esc_.sync_manager(*number);
    return bytes == 0 ? !sm.enabled() || sm.length == 0 : sm.enabled() && sm.length == bytes;
  };
  const auto in_place = [this](std::optional<unsigned> number, PdoDirection direction) {
    if (!number) return true;
    const auto sm = esc_.sync_manager(*number);
    return !sm.enabled() || sm.length == 0 ||
           (sm.start == config_.device.sync_managers[*number].start_address && !sm.is_mailbox() &&
            sm.ecat_writes() == (direction == PdoDirection::kRx));
  };
  if (!in_place(find_sync_manager(SyncManagerType::kOutputs), PdoDirection::kRx) ||
      !in_place(find_sync_manager(SyncManagerType::kInputs), PdoDirection::kTx)) {
    return kInvalidSyncManager;
  }
  if (!fits(find_sync_manager(SyncManagerType::kOutputs), PdoDirection::kRx)) return kInvalidOutputs;
  if (!fits(find_sync_manager(SyncManagerType::kInputs), PdoDirection::kTx)) return kInvalidInputs;
  return 0;
}

std::uint16_t Device::check_dc() const {
  const auto& dc = config_.device.dc;
  if (!dc || dc->op_modes.empty() || !esc_.dc().sync_active()) return 0;
  constexpr std::uint16_t kSignals = 0x0700;  // of AssignActivate: unit on, SYNC0, SYNC1
  const auto written = esc_.memory().u16(reg::kCyclicUnitControl);
  const bool known = std::ranges::any_of(
      dc->op_modes, [&](const DcOpMode& mode) { return ((mode.assign_activate ^ written) & kSignals) == 0; });
  return known ? 0 : kInvalidSyncConfiguration;
}

void Device::drop_to_safeop(std::uint16_t code, std::uint16_t error_code) {
  if (state_ != AlState::kOp) return;
  state_ = AlState::kSafeop;
  report(state_, code);
  tell_error(error_code, kCommunicationErrorRegister, code);
  on_state(state_);
}

void Device::process_data_watchdog_expired(Nanoseconds) {
  esc_.acknowledge_events(kAlEventWatchdog);
  if (esc_.device_emulation()) {
    // Digital outputs are the ESC's own: it switches them off itself (ESC data sheet II, 3.8).
    if (const auto number = find_sync_manager(SyncManagerType::kOutputs)) {
      const auto sm = esc_.sync_manager(*number);
      std::ranges::fill(esc_.memory().at(sm.start, sm.length), std::uint8_t{0});
    }
    return;
  }
  clear_outputs();
  drop_to_safeop(kWatchdog);
}

// ---- process data --------------------------------------------------------------------------------

void Device::map_process_data() {
  output_sm_ = find_sync_manager(SyncManagerType::kOutputs);
  input_sm_ = find_sync_manager(SyncManagerType::kInputs);
  const auto copies = [this](PdoDirection direction) {
    std::vector<Copy> list;
    std::uint32_t offset = 0;
    for (const auto& object : pdos_.layout(direction)) {
      auto* entry = object.index == 0 ? nullptr : dictionary_.find(object.index, object.sub_index);
      if (entry != nullptr && entry->value.size() >= size_of(object.bits)) list.push_back({entry, offset, object.bits});
      offset += object.bits;
    }
    return list;
  };
  outputs_ = copies(PdoDirection::kRx);
  inputs_ = copies(PdoDirection::kTx);
}

void Device::outputs_to_dictionary() {
  if (!output_sm_) return;
  const auto sm = esc_.sync_manager(*output_sm_);
  const auto bytes = std::as_const(esc_).memory().at(sm.start, sm.length);
  for (const auto& copy : outputs_) {
    if (copy.bit_offset + copy.bits > 8U * sm.length) continue;
    copy_bits(copy.entry->value, 0, bytes, copy.bit_offset, copy.bits);
  }
}

void Device::clear_outputs() {
  for (const auto& copy : outputs_) std::ranges::fill(copy.entry->value, std::uint8_t{0});
}

void Device::inputs_from_dictionary() {
  if (!input_sm_) return;
  const auto sm = esc_.sync_manager(*input_sm_);
  auto bytes = esc_.memory().at(sm.start, sm.length);
  for (const auto& copy : inputs_) {
    if (copy.bit_offset + copy.bits > 8U * sm.length) continue;
    copy_bits(bytes, copy.bit_offset, copy.entry->value, 0, copy.bits);
  }
}

void Device::sync_manager_written(unsigned number, Nanoseconds time) {
  esc_.acknowledge_events(kAlEventSyncManager0 << number);
  if (has_mailbox() && number == 0) {
    mail_due_ = time + kMailboxReaction + mailbox_delay_;
  } else if (output_sm_ == number) {
    last_outputs_ = time;
    if (state_ == AlState::kOp) outputs_to_dictionary();
    on_outputs(time);
  }
}

void Device::sync_manager_read(unsigned number, Nanoseconds time) {
  esc_.acknowledge_events(kAlEventSyncManager0 << number);
  if (has_mailbox() && number == 1 && mailbox_.waiting()) mail_due_ = time + kMailboxReaction;
  if (input_sm_ == number) on_inputs_read(time);
}

void Device::sync_manager_set(unsigned number, Nanoseconds time) {
  esc_.acknowledge_events(kAlEventSyncManagerSet);
  if (has_mailbox() && number == 1 && esc_.repeat_requested(1)) mail_due_ = time + kMailboxReaction;
}

void Device::sync_signal(SyncGenerator::Signal signal, Nanoseconds time) {
  if (signal == SyncGenerator::Signal::kSync0) on_sync0(time);
  if (signal == SyncGenerator::Signal::kSync1) on_sync1(time);
}

// ---- mailbox ---------------------------------------------------------------------------------------

void Device::answer_mail(Nanoseconds) {
  const auto in = esc_.sync_manager(0);
  const auto out = esc_.sync_manager(1);
  if (mailbox_silent_ || state_ == AlState::kInit) return;
  if ((in.status & SyncManager::kStatusMailboxFull) != 0) {
    mailbox_.receive(std::as_const(esc_).memory().at(in.start, in.length), out.length, state_ == AlState::kPreop);
    esc_.set_mailbox_full(0, false);
  }
  if (!out.enabled()) return;
  const bool full = (out.status & SyncManager::kStatusMailboxFull) != 0;
  if (esc_.repeat_requested(1)) {
    if (const auto& again = mailbox_.repeat(full); !again.empty()) load_send_mailbox(again);
    esc_.acknowledge_repeat(1);
    return;
  }
  if (!mailbox_.waiting() || full) return;
  if (const auto bytes = mailbox_.next(out.length)) load_send_mailbox(*bytes);
}

void Device::load_send_mailbox(std::span<const std::uint8_t> bytes) {
  const auto out = esc_.sync_manager(1);
  const auto size = std::min<std::size_t>(bytes.size(), out.length);
  std::ranges::copy(bytes.first(size), esc_.memory().at(out.start, out.length).begin());
  esc_.set_mailbox_full(1, true);
}

}  // namespace syncline::sim
