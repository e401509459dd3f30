// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/esc.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "protocol/dl_status.h"
#include "protocol/registers.h"
#include "sim/esc/esc_events.h"
#include "sim/registers/esc_ranges.h"
#include "sim/registers/short_copy.h"

namespace syncline::sim {

using namespace esc_events;

namespace {

constexpr std::uint16_t kDcEnd = 0x0A00;  // of the registers of the DC unit

// What a datagram's working counter grows by: read, written, or written by a command that reads too.
constexpr unsigned kRead = 1, kWritten = 1, kReplaced = 2;

}  // namespace

void Esc::frame_at_port(unsigned port, Nanoseconds time, bool first) {
  if (first) port_times_ = {};
  port_times_[port] = time;
}

void Esc::advance_others(Nanoseconds time) {
  as_usual_ = false;
  if (time >= ports_.due()) settings_changed();
  ports_.advance_to(time);
  if (sii_.advance_to(time)) {
    load_configuration();
    settings_changed();  // the alias
  }
  if (pdi_watchdog_.advance_to(time)) raise_event(kEventDlStatus);
  if (watchdog_.advance_to(time)) {
    requests_.raise_al(kAlEventWatchdog);
    if (listener_ != nullptr) listener_->process_data_watchdog_expired(time);
  }
  quiet_until_ = std::min({ports_.due(), sii_.due(), pdi_watchdog_.deadline(), watchdog_.deadline()});
}

bool Esc::mark_circulating(std::span<PassingDatagram> datagrams) {
  if (std::ranges::any_of(datagrams, &PassingDatagram::circulating)) {
    ports_.count_processing_unit_error();
    return false;
  }
  for (auto& datagram : datagrams) datagram.circulating = true;
  return true;
}

// Every slave and frame goes through this and frame_end(): calls inside would cost a fifth of all the time of a
// simulation.
[[gnu::flatten]] bool Esc::process(PassingFrame& frame, Nanoseconds time) {
  if (ports_.port0_automatically_closed() && !mark_circulating(frame.datagrams())) return false;
  protection_.start_of_frame();
  as_usual_ = false;
  if (renewed_by_signal_ != 0) count_renewals();
  if (cycles_.repeating) wake_up();
  frame_time_ = time;
  if (managers_.stale()) reload_maps();
  frame.add_event(requests_.told());
  touched_ = reset_.begun() || ports_.changed();
  if (const auto* plan = plan_for(frame)) {
    if (managers_.any_pending()) open_buffers(*plan);
    follow(*plan, frame.bytes().data());
    read_buffers(plan->read);
    take_up(*plan, frame.bytes().data());
    frame.pass(plan->kind);
  } else {
    execute_all(frame);
  }
  return true;
}

[[gnu::noinline, gnu::flatten]] void Esc::execute_all(PassingFrame& frame) {
  frame.settle();
  if (frame.touches_clock()) dc_.start_of_frame(frame_time_);
  for (auto& datagram : frame.datagrams()) {
    datagram.wkc = static_cast<std::uint16_t>(datagram.wkc + execute(datagram));
    datagram.adp = static_cast<std::uint16_t>(datagram.adp + datagram.step);
  }
}

unsigned Esc::execute(const PassingDatagram& datagram) {
  touched_ = touched_ || !is_fixed_address(datagram.command) || datagram.command == Command::kFrmw ||
             addresses_.has(datagram.adp);
  switch (datagram.command) {
    case Command::kNop:
      return 0;
    case Command::kAprd:
      return read(datagram, datagram.adp == 0);
    case Command::kApwr:
      return write(datagram, datagram.adp == 0);
    case Command::kAprw:
      return read_and_write(datagram, datagram.adp == 0);
    case Command::kFprd:
      return read(datagram, addresses_.has(datagram.adp));
    case Command::kFpwr:
      return write(datagram, addresses_.has(datagram.adp));
    case Command::kFprw:
      return read_and_write(datagram, addresses_.has(datagram.adp));
    case Command::kBrd:
      return read_memory(datagram.ado, datagram.data, true) ? kRead : 0;
    case Command::kBwr:
      return write(datagram, true);
    case Command::kBrw:
      return read_and_write(datagram, true);
    case Command::kLrd:
      return fmmus_.read(datagram, frame_time_) ? kRead : 0;
    case Command::kLwr:
      return fmmus_.write(datagram, frame_time_) ? kWritten : 0;
    case Command::kLrw: {
      if (!options_.logical_read_write) return 0;
      // The write side takes the bytes as they came in; the read side replaces them afterwards.
      const bool written = fmmus_.write(datagram, frame_time_);
      const bool read = fmmus_.read(datagram, frame_time_);
      return (read ? kRead : 0) + (written ? kReplaced : 0);
    }
    case Command::kArmw:
      return datagram.adp == 0 ? read(datagram, true) : write(datagram, true);
    case Command::kFrmw:
      return addresses_.has(datagram.adp) ? read(datagram, true) : write(datagram, true);
  }
  return 0;
}

unsigned Esc::read(const PassingDatagram& datagram, bool addressed) {
  return addressed && read_memory(datagram.ado, datagram.data, false) ? kRead : 0;
}

unsigned Esc::write(const PassingDatagram& datagram, bool addressed) {
  return addressed && write_memory(datagram.command, datagram.ado, datagram.data) ? kWritten : 0;
}

unsigned Esc::read_and_write(const PassingDatagram& datagram, bool addressed) {
  if (!addressed || !options_.physical_read_write) return 0;
  // Shadowed: the read sees the old value.
  const bool written = write_memory(datagram.command, datagram.ado, datagram.data);
  const bool read = read_memory(datagram.ado, datagram.data, datagram.command == Command::kBrw);
  return (read ? kRead : 0) + (written ? kReplaced : 0);
}

bool Esc::read_memory(std::uint16_t address, std::span<std::uint8_t> out, bool or_into) {
  if (address + out.size() <= managers_.begin()) return read_registers(address, out, or_into);
  if (address + out.size() > EscMemory::kSize || !managers_.allow(address, out.size(), false)) return false;
  managers_.open(address, out.size());
  if (!read_registers(address, out, or_into)) return false;
  managers_.note_access(address, out.size(), false);
  return true;
}

bool Esc::read_registers(std::uint16_t address, std::span<std::uint8_t> out, bool or_into) {
  if (overlaps(address, out.size(), DcUnit::kShownBegin, DcUnit::kShownSize)) dc_.refresh_registers();
  if (overlaps(address, out.size(), reg::kSyncManager, reg::kSyncManagersSize)) managers_.buffers().show();
  const bool latches = overlaps(address, out.size(), reg::kLatch0Status, kDcEnd - reg::kLatch0Status);
  if (latches) dc_.latches().before_read(address, out.size());
  const auto from = std::as_const(memory_).at(address, out.size());
  if (memory_.is_readable(address, out.size())) {
    or_into ? short_or(from, out) : short_copy(from, out);
  } else if (!read_what_is_there(address, from, out, or_into)) {
    return false;
  }
  if (latches) read_latches(address, out.size());
  if (address < reg::kAlStatus + 2) {
    if (overlaps(address, out.size(), reg::kDlStatus, 2)) clear_event(kEventDlStatus);
    if (overlaps(address, out.size(), reg::kAlStatus, 2)) clear_event(kEventAlStatus);
  }
  return true;
}

bool Esc::read_what_is_there(std::uint16_t address, std::span<const std::uint8_t> from, std::span<std::uint8_t> out,
                             bool or_into) const {
  bool any = false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool readable = (memory_.rights(static_cast<std::uint32_t>(address + i)) & EscMemory::kRead) != 0;
    if (!readable && !any) continue;
    any = true;
    const auto value = readable ? from[i] : std::uint8_t{0};
    out[i] = or_into ? static_cast<std::uint8_t>(out[i] | value) : value;
  }
  return any;
}

bool Esc::write_memory(Command command, std::uint16_t address, std::span<const std::uint8_t> data) {
  if (address + data.size() > EscMemory::kSize || !managers_.allow(address, data.size(), true)) return false;
  if (!protection_.allows(address, data.size())) return false;
  std::size_t closed = 0;  // bytes that cannot be written
  while (closed < data.size() &&
         (memory_.rights(static_cast<std::uint32_t>(address + closed)) & EscMemory::kWrite) == 0)
    ++closed;
  if (closed == data.size()) return false;
  if (address >= EscMemory::kRegisterEnd) {  // RAM has no shadow
    std::copy(data.begin(), data.end(), memory_.at(address, data.size()).begin());
  } else {
    const bool system_time = address == reg::kSystemTime && data.size() >= 4;  // in every cycle
    if (!system_time && overlaps(address, data.size(), DcUnit::kShownBegin, DcUnit::kShownSize))
      dc_.refresh_registers();
    writes_.add(address, data);
    if (overlaps(address, data.size(), reg::kReceiveTimePort0, 4)) {
      latch_unit_ = true;
      latch_ports_ = latch_ports_ || command == Command::kBwr || command == Command::kFpwr;
    }
  }
  managers_.note_access(address, data.size(), true);
  return true;
}

void Esc::commit_register(const FrameWrites::Write& write, Nanoseconds time) {
  if (write.address >= reg::kReceiveTimePort0) {  // nothing else has a meaning from here on
    if (write.address < kDcEnd) dc_.registers_written(write.address, write.length, time);
    return;
  }
  const auto hit = [&write](std::uint16_t address, std::size_t size) {
    return overlaps(write.address, write.length, address, size);
  };
  quiet_until_ = INT64_MIN;  // a setting for a while may begin or end by it
  if (hit(reg::kFmmu, 0x100) || hit(reg::kSyncManager, reg::kSyncManagersSize)) {
    managers_.outdate();
    if (hit(reg::kSyncManager, reg::kSyncManagersSize)) managers_.set_up_anew();
  }
  if (hit(reg::kWatchdogDivider, reg::kWatchdogStatus - reg::kWatchdogDivider)) {
    watchdog_.settings_written();
    pdi_watchdog_.settings_written();
  }
  if (hit(reg::kDlControl, 4)) ports_.control_written(time);
  if (hit(reg::kRxErrorCounter, 0x0C)) std::ranges::fill(memory_.at(reg::kRxErrorCounter, 0x0C), std::uint8_t{0});
  if (hit(reg::kProcessingUnitErrorCounter, 1)) memory_.set<std::uint8_t>(reg::kProcessingUnitErrorCounter, 0);
  if (hit(reg::kPdiErrorCounter, 1)) memory_.set<std::uint8_t>(reg::kPdiErrorCounter, 0);
  if (hit(reg::kWatchdogCounterProcessData, 2)) memory_.set<std::uint16_t>(reg::kWatchdogCounterProcessData, 0);
  if (hit(reg::kLostLinkCounter, 4)) std::ranges::fill(memory_.at(reg::kLostLinkCounter, 4), std::uint8_t{0});
  if (hit(reg::kSiiConfiguration, 2)) sii_.configuration_written();
  for (unsigned i = 0; i < options_.sync_manager_count; ++i) {  // what was in one that is switched off is gone
    if (hit(static_cast<std::uint16_t>(reg::sync_manager(i) + 6), 1) && !sync_manager(i).enabled())
      set_mailbox_full(i, false);
  }
  if (listener_ == nullptr) return;
  for (unsigned i = 0; i < options_.sync_manager_count; ++i) {
    if (!hit(static_cast<std::uint16_t>(reg::sync_manager(i) + 6), 1)) continue;
    requests_.raise_al(kAlEventSyncManagerSet);
    const auto sm = sync_manager(i);
    if (!sm.enabled() && (sm.control & SyncManager::kControlWatchdog) != 0) watchdog_.stop();
    listener_->sync_manager_set(i, time);
  }
  if (hit(reg::kAlControl, 2)) {
    requests_.raise_al(kAlEventControl);
    listener_->al_control_written(time);
  }
}

void Esc::frame_damaged() {
  writes_.clear();
  time_size_ = 0;
  latch_unit_ = latch_ports_ = false;
  managers_.forget_transfers();
}

void Esc::take_over(const FrameWrites::Write& write, std::span<const std::uint8_t> bytes) {
  // In every cycle: the system time.
  if (write.address >= reg::kSystemTime && write.length <= EscMemory::kWord &&
      memory_.all_have(EscMemory::kWrite, write.address, write.length)) {
    short_copy(bytes, memory_.at(write.address, write.length));
    return;
  }
  const bool sync_managers = overlaps(write.address, write.length, reg::kSyncManager, reg::kSyncManagersSize);
  if (sync_managers) managers_.buffers().show();
  const bool sii = overlaps(write.address, write.length, reg::kSiiControl, 0x20);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto address = static_cast<std::uint32_t>(write.address + i);
    // Receive times are what the latch shows, never what was written to start it; the EEPROM may be busy.
    const bool receive_time = address >= reg::kReceiveTimePort0 && address < reg::kSystemTime;
    if (sync_managers && managers_.locks_register(address)) continue;
    if ((memory_.rights(address) & EscMemory::kWrite) != 0 && !receive_time && !(sii && sii_.blocks(address))) {
      memory_.set<std::uint8_t>(static_cast<std::uint16_t>(address), bytes[i]);
    }
  }
}

[[gnu::flatten]] void Esc::frame_end(Nanoseconds time) {
  dc_.advance_to(time);
  if (time_size_ != 0) dc_.system_time_received(std::exchange(time_size_, std::uint8_t{0}), time_received_, time);
  if (!writes_.empty() || latch_unit_ || reset_.begun()) commit_all(time);
  if ((managers_.written() | managers_.read()) != 0) end_transfers(time);
}

[[gnu::noinline]] void Esc::commit_all(Nanoseconds time) {
  if (!writes_.only_system_time()) {
    wake_up();
    settings_changed();
  }
  bool reset_written = false, sii_command = false;
  writes_.for_each([&](const FrameWrites::Write& write, std::span<const std::uint8_t> bytes) {
    if (write.address < reg::kReceiveTimePort0) {
      sii_command =
          sii_command || (overlaps(write.address, write.length, reg::kSiiControl, 2) && !sii_.blocks(reg::kSiiControl));
      reset_written = reset_written || overlaps(write.address, write.length, reg::kEscReset, 1);
    }
    take_over(write, bytes);
    commit_register(write, time);
  });
  if (sii_command) {  // the enable bit and the command may come in two datagrams of one frame
    sii_.control_written(time);
    quiet_until_ = INT64_MIN;
    if (sii_.advance_to(time)) load_configuration();
  }
  if (reset_written || reset_.begun()) reset_.end_of_frame(reset_written);
  writes_.clear();
  if (latch_unit_) dc_.latch_processing_unit();
  if (latch_ports_) dc_.latch_ports(port_times_);
  latch_unit_ = latch_ports_ = false;
}

void Esc::restart_watchdog(Nanoseconds time) {
  watchdog_.trigger(time);
  if (watchdog_.deadline() >= quiet_until_) return;  // later than before, mostly
  quiet_until_ = watchdog_.deadline();
  idle_until_ = std::min(idle_until_, quiet_until_);
}

[[gnu::noinline]] void Esc::end_transfers(Nanoseconds time) {
  const auto written = managers_.written();
  auto read = managers_.read();
  if (!managers_.any_pending())
    read &= minded_ | managers_.mailboxes();  // of the others nobody is told, and nothing changes
  for (auto touched = written | read; touched != 0; touched &= touched - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(touched));
    const auto bit = 1U << i;
    const auto& manager = managers_.decoded(i);
    if ((written & bit) != 0) {
      if (manager.is_mailbox()) set_mailbox_full(i, true);
      if ((manager.control & SyncManager::kControlWatchdog) != 0) restart_watchdog(time);
      if ((renewed_by_transfer_.by & bit) != 0) renew(renewed_by_transfer_.renewed, 1);
      if ((minded_ & bit) != 0) {
        raise_buffer_event(i);
        if (listener_ != nullptr) listener_->sync_manager_written(i, time);
      }
    }
    if ((read & bit) != 0) {
      if (manager.is_mailbox()) set_mailbox_full(i, false);
      if (managers_.any_pending()) managers_.show_pending(i);
      if ((minded_ & bit) != 0) {
        raise_buffer_event(i);
        if (listener_ != nullptr) listener_->sync_manager_read(i, time);
      }
    }
  }
  managers_.set_transfers(0, 0);
}

/// Their registers were written: what is decoded of them is decoded again.
void Esc::reload_maps() {
  settings_changed();
  managers_.reload();
  fmmus_.reload();
}

}  // namespace syncline::sim
