// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include "protocol/registers.h"
#include "sim/esc/esc.h"
#include "sim/esc/esc_events.h"

/// What the device's side of an ESC sees and does: events, SyncManagers, pins.
namespace syncline::sim {

using namespace esc_events;

void Esc::set_listener(Listener* listener) {
  listener_ = listener;
  dc_.on_sync = [this](SyncGenerator::Signal signal, Nanoseconds time) { sync_fired(signal, time); };
}

void Esc::raise_event(std::uint16_t event) {
  if (requests_.raise(event)) request_changed();
}

void Esc::clear_event(std::uint16_t event) {
  if (requests_.clear(event)) request_changed();
}

void Esc::request_changed() {
  as_usual_ = false;
  ++*event_changes_;
}

void Esc::tell_al_status() { raise_event(kEventAlStatus); }

void Esc::raise_buffer_event(unsigned number) { prompt_ ? take_written(number) : leave_written(number); }

void Esc::leave_written(unsigned number) { requests_.raise_al(kAlEventSyncManager0 << number); }

void Esc::take_written(unsigned number) { acknowledge_events(kAlEventSyncManager0 << number); }

void Esc::set_mailbox_full(unsigned number, bool full) {
  managers_.set_mailbox_full(number, full);
  // The ECAT event request mirrors the state of the first eight SyncManagers (0x0210, bits 11..4).
  if (number < 8) {
    const auto event = static_cast<std::uint16_t>(kEventSyncManager0 << number);
    full ? raise_event(event) : clear_event(event);
  }
}

void Esc::acknowledge_repeat(unsigned number) {
  managers_.acknowledge_repeat(number);
  as_usual_ = false;
}

void Esc::deactivate_sync_manager(unsigned number, bool deactivated) {
  managers_.deactivate(number, deactivated);
  as_usual_ = false;
}

void Esc::put_buffer(unsigned number, std::span<const std::uint8_t> bytes) {
  if (!managers_.has(number)) return;
  put_same_buffers(1U << number);
  if (!managers_.put(number, bytes)) as_usual_ = false;
}

/// Signals that have not been counted yet may be so later: writes into a buffer are all alike.
void Esc::put_same_buffers(std::uint32_t managers) { renew(managers, 1); }

bool Esc::latch_input(unsigned number, bool level, Nanoseconds time) {
  const bool output = (memory_.u8(reg::kSyncLatchConfiguration) >> (2 + 4 * number) & 1U) != 0;
  const bool taken = !output && dc_.latch_input(number, level, time);
  follow_latch_events();
  return taken;
}

void Esc::follow_latch_events() {
  dc_.latches().master_event() ? raise_event(kEventLatch) : clear_event(kEventLatch);
  dc_.latches().pdi_event() ? requests_.raise_al(kAlEventLatch) : acknowledge_events(kAlEventLatch);
}

void Esc::read_latches(std::uint16_t address, std::size_t length) {
  if (address >= reg::kLatch1NegativeEdge + 8 || address + length <= reg::kLatch0PositiveEdge) return;
  dc_.latches().acknowledge(address, length);
  follow_latch_events();
}

void Esc::sync_fired(SyncGenerator::Signal signal, Nanoseconds time) {
  if (sync_silent_) return;
  const unsigned number = signal == SyncGenerator::Signal::kSync0 ? 0 : 1;
  const bool mapped = (memory_.u8(reg::kSyncLatchConfiguration) >> (3 + 4 * number) & 1U) != 0;
  if (mapped) requests_.raise_al(kAlEventSync0 << number);
  if (listener_ != nullptr) listener_->sync_signal(signal, time);
}

void Esc::leave_signals_unminded(std::uint32_t renewed) {
  if (!options_.counts_at_once || sync_silent_) return;  // signals that the device is not told of are missed by it
  dc_.leave_signals_unminded();
  renewed_by_signal_ = dc_.signals_unminded() ? renewed : 0;
}

void Esc::leave_transfers_unminded(std::uint32_t managers) {
  if (!options_.counts_at_once) return;
  // What is pending since the device hung is dealt with at the next transfer.
  const auto pending = requests_.al_requested() / kAlEventSyncManager0;
  minded_ = ~managers | pending;
}

void Esc::renew_at_transfers(unsigned by, std::uint32_t renewed) {
  if ((minded_ >> by & 1U) == 0) renewed_by_transfer_ = {1U << by, renewed};
}

[[gnu::noinline]] void Esc::count_renewals() {
  if (const auto signals = dc_.count_unminded(); signals > 0) renew(renewed_by_signal_, signals);
}

void Esc::renew(std::uint32_t managers, std::uint64_t times) {
  for (; managers != 0; managers &= managers - 1)
    managers_.buffers().write(static_cast<unsigned>(std::countr_zero(managers)), times);
}

void Esc::mind_signals() {
  count_renewals();
  renewed_by_signal_ = 0;
  const auto last = dc_.mind_signals();
  if (listener_ != nullptr && last) listener_->signals_passed(*last);
}

void Esc::repeat_cycles(const RepeatedCycles::Work& work, Nanoseconds time) {
  const bool told = options_.counts_at_once && !sync_silent_ && listener_ != nullptr;
  if (!told || cycles_.repeating || !dc_.has_regular_signals()) return;
  leave_transfers_unminded(work.renewed | 1U << work.outputs);
  cycles_ = {.work = work, .repeating = true, .quiet_from = time};
  repeat_until(time + RepeatedCycles::surely(dc_.until_sync0(dc_.moment(time))));
}

void Esc::end_cycles() {
  const auto cycles = std::exchange(cycles_, {});
  const auto whole = cycles.outputs_taken - (cycles.awaits_sync0 ? 1 : 0);
  if (whole > 0) listener_->cycles_passed(whole, LocalClock::time_before(cycles.behind_sync0, cycles.sync0));
  if (cycles.awaits_sync0) listener_->sync_manager_written(cycles.work.outputs, cycles.taken_at);
  dc_.deliver_from(cycles.quiet_from);
}

void Esc::pdi_works() {
  if (pdi_watchdog_.pdi_works()) raise_event(kEventDlStatus);
}

void Esc::acknowledge_sync(SyncGenerator::Signal signal) {
  dc_.acknowledge_sync(signal);
  acknowledge_events(signal == SyncGenerator::Signal::kSync0 ? kAlEventSync0 : kAlEventSync0 << 1);
}

}  // namespace syncline::sim
