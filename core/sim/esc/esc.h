// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "sim/dc/dc_unit.h"
#include "sim/esc/al_registers.h"
#include "sim/esc/esc_ports.h"
#include "sim/esc/event_requests.h"
#include "sim/esc/fmmu_unit.h"
#include "sim/esc/frame_plan.h"
#include "sim/esc/frame_planner.h"
#include "sim/esc/frame_writes.h"
#include "sim/esc/passing_frame.h"
#include "sim/esc/pdi_watchdog.h"
#include "sim/esc/process_data_watchdog.h"
#include "sim/esc/repeated_cycles.h"
#include "sim/esc/reset_sequence.h"
#include "sim/esc/sii_interface.h"
#include "sim/esc/station_addresses.h"
#include "sim/esc/sync_managers.h"
#include "sim/registers/esc_memory.h"
#include "sim/registers/write_protection.h"

namespace syncline::sim {

/// EtherCAT slave controller: executes the datagrams of passing frames on its register file and RAM
/// (ESC data sheet I, chapters 2 to 8). Register writes become effective at the end of the frame. Its units (ports,
/// SyncManagers, FMMUs, clock, EEPROM, watchdogs, events ...) have their registers and what follows from them; here is
/// what they do together in the course of a frame.
class Esc {
 public:
  struct Options {
    std::uint8_t fmmu_count = 8;
    std::uint8_t sync_manager_count = 8;
    bool device_emulation = false;
    std::uint8_t ram_kbytes = 4;
    bool logical_read_write = true;   // LRW
    bool physical_read_write = true;  // APRW, FPRW, BRW
    bool counts_at_once = true;       // what nobody minds; otherwise it is done each time, which is the same and slower
  };
  Esc(const SimSlaveConfig& config, std::vector<std::uint8_t> sii, const Options& options, Nanoseconds power_on,
      std::uint64_t seed);

  /// Events of the PDI side, in the order in which they happen; times are true time.
  struct Listener {
    virtual ~Listener() = default;
    virtual void al_control_written(Nanoseconds time) = 0;
    virtual void sync_manager_written(unsigned number, Nanoseconds time) = 0;  // last byte, good frame
    virtual void sync_manager_read(unsigned number, Nanoseconds time) = 0;
    /// The master wrote the activation register: switched it on or off, or asks for a repeated message.
    virtual void sync_manager_set(unsigned number, Nanoseconds time) = 0;
    virtual void process_data_watchdog_expired(Nanoseconds time) = 0;
    virtual void sync_signal(SyncGenerator::Signal signal, Nanoseconds time) = 0;
    /// Of the SYNC0 that nobody wanted to know, the last one came at `time`.
    virtual void signals_passed(Nanoseconds) {}
    /// So many of the cycles that were only counted are over; the last SYNC0 came at `time`.
    virtual void cycles_passed(std::uint64_t, Nanoseconds) {}
  };
  /// The listener must outlive the ESC; the ESC must not move afterwards.
  void set_listener(Listener* listener);

  // ---- the frame's way ----
  /// Of a frame that takes port times. `first`: here begins its way through the slave.
  void frame_at_port(unsigned port, Nanoseconds time, bool first);
  /// Which datagrams for single slaves are for this one, until its settings change: as PassingFrame::is_for() takes
  /// them.
  [[nodiscard]] StationAddresses::Pair address() { return addresses_.of(generation_); }
  /// As long as its settings stay, no frame is its matter that is not for it.
  [[nodiscard]] bool is_indifferent() const {
    return requests_.none_is_told() && !reset_.begun() && !ports_.port0_automatically_closed();
  }
  /// Every frame is: it carries the ESC's events, ends its reset sequence or shows that it circulates. It stays so
  /// until settings or events change.
  [[nodiscard]] bool looks_at_all_frames() const {
    return reset_.begun() || ports_.port0_automatically_closed() || requests_.told() != 0;
  }
  /// Counts the changes of the settings, and those of the ECAT event request, there, too, where those of many ESCs come
  /// together.
  void count_changes_in(std::uint64_t& settings, std::uint64_t& events) {
    changes_ = &settings;
    event_changes_ = &events;
  }
  /// The frame passes the processing unit: executes every datagram in place. False: it is destroyed there.
  [[nodiscard]] bool process(PassingFrame& frame, Nanoseconds time);
  /// Both of process() and frame_end(), for a frame with a shape that no slave sees damaged: possible where nothing is
  /// due before `end` and nothing unusual is under way. `asked`: datagrams for single slaves are for this one, too, all
  /// of them as is_only_asked_by() says; otherwise none is. False: it has done nothing.
  [[nodiscard]] bool pass_at_once(PassingFrame& frame, bool asked, Nanoseconds begin, Nanoseconds end) {
    const auto& shape = *frame.shape();
    const auto& plan = plans_[shape.place];
    const bool known = plan.shape == shape.id && plan.generation == generation_ && !plan.executed;
    return known && pass_at_once(plan, frame, asked, begin, end);
  }
  /// The same for a frame in which everything is for single slaves, as is_only_asked_by() says where it is for this
  /// one.
  [[nodiscard]] bool answer_at_once(PassingFrame& frame, Nanoseconds begin, Nanoseconds end) {
    static constexpr FramePlan kNothing{.executed = false};
    return pass_at_once(kNothing, frame, true, begin, end);
  }
  /// What is for this one alone is behind all else in the frame, and only reads registers.
  [[nodiscard]] bool is_only_asked_by(const PassingFrame& frame);
  /// The last byte has passed with a good FCS.
  void frame_end(Nanoseconds time);
  /// The FCS was bad: nothing of what the frame wrote becomes effective, except in RAM.
  void frame_damaged();
  void advance_to(Nanoseconds time) {
    dc_.advance_to(time);
    if (time >= quiet_until_) advance_others(time);
  }
  /// The frame that process() has seen last found something to do here, and its frame_end() must follow.
  [[nodiscard]] bool touched() const { return touched_; }

  // ---- when something happens ----
  /// Nothing is due before, neither in the ESC nor in the device behind it. Whatever may bring something forward ends
  /// it.
  [[nodiscard]] Nanoseconds idle_until() const { return idle_until_; }
  void stay_idle_until(Nanoseconds time) { idle_until_ = std::min({time, dc_.quiet_until(), quiet_until_}); }
  void wake_up() {
    idle_until_ = INT64_MIN;
    as_usual_ = false;
    minded_ = ~0U;
    renewed_by_transfer_ = {};
    if (dc_.signals_unminded()) mind_signals();
    if (cycles_.repeating) end_cycles();
  }
  /// When the last frame began to pass.
  [[nodiscard]] Nanoseconds frame_time() const { return frame_time_; }
  /// Time passes, and nothing happens.
  void pass_idly(Nanoseconds time) { dc_.pass_quietly(time); }
  /// Nobody wants to know of each SYNC0 until something wakes up the ESC; Listener::signals_passed() then tells the
  /// last. The device does no more with them than to write the same inputs again into these SyncManagers (a bit each).
  void leave_signals_unminded(std::uint32_t renewed);
  /// Nobody wants to know of transfers in these SyncManagers (a bit each) until something wakes up the ESC.
  void leave_transfers_unminded(std::uint32_t managers);
  /// At each transfer in SyncManager `by` that nobody minds the device writes the same inputs again into `renewed`.
  void renew_at_transfers(unsigned by, std::uint32_t renewed);
  /// In each cycle the device does the same until something wakes up the ESC or the cycle is another one: cycles are
  /// counted, and Listener::cycles_passed() then tells how many. The last SYNC0 has been delivered, and the outputs
  /// for the next one are still to come.
  void repeat_cycles(const RepeatedCycles::Work& work, Nanoseconds time);
  [[nodiscard]] bool repeats_cycles() const { return cycles_.repeating; }
  /// The frames come from elsewhere: what an ESC does with them by its position is another thing.
  void forget_plans() { settings_changed(); }
  /// Another one after each change of the settings.
  [[nodiscard]] std::uint32_t generation() const { return generation_; }

  // ---- the device's side ----
  [[nodiscard]] EscMemory& memory() { return memory_; }
  [[nodiscard]] const EscMemory& memory() const { return memory_; }
  [[nodiscard]] const DcUnit& dc() const { return dc_; }
  /// For what changes it from outside: faults, and tests.
  [[nodiscard]] DcUnit& dc() {
    wake_up();
    return dc_;
  }
  /// Brings those up to date that are only when somebody reads them.
  void refresh_registers() {
    dc_.refresh_registers();
    managers_.buffers().show();
  }
  [[nodiscard]] SyncManager sync_manager(unsigned number) const { return managers_.in_registers(number); }
  [[nodiscard]] bool has_sync_manager(unsigned number) const { return managers_.has(number); }
  /// Its memory, cut where a master has set it up beyond the address space.
  [[nodiscard]] std::span<std::uint8_t> sync_manager_area(unsigned number) { return managers_.area(number); }
  [[nodiscard]] std::span<const std::uint8_t> sync_manager_area(unsigned number) const {
    return managers_.area(number);
  }
  void set_mailbox_full(unsigned number, bool full);
  /// Repeat request of the master against the PDI's acknowledgement (0x0806 bit 1, 0x0807 bit 1).
  [[nodiscard]] bool repeat_requested(unsigned number) const { return managers_.repeat_requested(number); }
  void acknowledge_repeat(unsigned number);
  /// The PDI locks the memory of a SyncManager against the master, or gives it free (0x0807 bit 0).
  void deactivate_sync_manager(unsigned number, bool deactivated);
  /// Bytes that the master reads from a buffered SyncManager: a transfer under way still shows the buffer before.
  void put_buffer(unsigned number, std::span<const std::uint8_t> bytes);
  /// The PDI writes what the buffers of these SyncManagers (a bit each) hold already.
  void put_same_buffers(std::uint32_t managers);
  /// The level at a LATCH input (0, 1) as of `time`; false: no time taken, or the pin is a SYNC output (0x0151).
  bool latch_input(unsigned number, bool level, Nanoseconds time);
  /// The PDI has read 0x098E or 0x098F.
  void acknowledge_sync(SyncGenerator::Signal signal);
  /// The device is not told of SYNC signals, whatever its pins show.
  void silence_sync(bool silent) {
    wake_up();
    sync_silent_ = silent;
  }
  [[nodiscard]] AlRegisters& al() { return al_; }
  /// The PDI has written the AL status: the ECAT event request tells the master (0x0210, bit 3).
  void tell_al_status();
  /// The PDI has dealt with these bits of the AL event request (0x0220).
  void acknowledge_events(std::uint32_t events) { requests_.acknowledge_al(events); }
  /// The PDI deals with the events of SyncManagers as soon as it is told of them: nobody sees them pending.
  void serve_promptly(bool promptly) { prompt_ = promptly; }
  /// The device has not read yet what the master wrote to this SyncManager; or does so now.
  void leave_written(unsigned number);
  void take_written(unsigned number);
  /// The device stops to ask the ESC, or does so again.
  void pdi_stops(Nanoseconds time) {
    pdi_watchdog_.pdi_stops(time);
    quiet_until_ = std::min(quiet_until_, pdi_watchdog_.deadline());
    wake_up();
  }
  void pdi_works();
  /// The process data watchdog has expired and not been triggered since.
  [[nodiscard]] bool outputs_expired() const { return memory_.u16(reg::kWatchdogStatus) == 0; }
  [[nodiscard]] bool device_emulation() const { return options_.device_emulation; }
  [[nodiscard]] EscPorts& ports() {
    as_usual_ = false;
    return ports_;
  }
  /// R, E and S were written to 0x0040 by three consecutive frames: the slave starts anew.
  [[nodiscard]] bool reset_requested() const { return reset_.complete(); }
  /// What the EEPROM holds, over power cycles.
  [[nodiscard]] SiiInterface& sii() { return sii_; }
  [[nodiscard]] const std::vector<std::uint8_t>& sii_content() const { return sii_.content(); }

 private:
  void mind_signals();
  /// What the device has written again with the SYNC signals that nobody minds, up to now.
  void count_renewals();
  void renew(std::uint32_t managers, std::uint64_t times);
  /// The rest of frame_end() after a frame that has written registers.
  void commit_all(Nanoseconds time);
  /// What happens in SyncManagers at the end of the frame.
  void end_transfers(Nanoseconds time);
  /// All that time does to an ESC but its clock.
  void advance_others(Nanoseconds time);
  void raise_event(std::uint16_t event);
  /// Of SyncManager `number`.
  void raise_buffer_event(unsigned number);
  void clear_event(std::uint16_t event);
  void request_changed();
  /// What its working counter grows by.
  [[nodiscard]] unsigned execute(const PassingDatagram& datagram);
  [[nodiscard]] unsigned read(const PassingDatagram& datagram, bool addressed);
  [[nodiscard]] unsigned write(const PassingDatagram& datagram, bool addressed);
  [[nodiscard]] unsigned read_and_write(const PassingDatagram& datagram, bool addressed);
  /// Has a datagram for single slaves that is for this one. Its addresses are remembered as long as the settings stay.
  [[nodiscard]] bool is_called_by(const PassingFrame& frame) {
    const auto& [station, alias] = addresses_.of(generation_);
    return frame.is_for(station, alias);
  }
  void settings_changed() {
    as_usual_ = false;
    ++generation_;
    ++*changes_;
  }
  bool read_memory(std::uint16_t address, std::span<std::uint8_t> out, bool or_into);
  /// Registers, and RAM that is no SyncManager's matter.
  bool read_registers(std::uint16_t address, std::span<std::uint8_t> out, bool or_into);
  /// Registers with gaps between them.
  bool read_what_is_there(std::uint16_t address, std::span<const std::uint8_t> from, std::span<std::uint8_t> out,
                          bool or_into) const;
  bool write_memory(Command command, std::uint16_t address, std::span<const std::uint8_t> data);
  void read_latches(std::uint16_t address, std::size_t length);
  void follow_latch_events();
  void sync_fired(SyncGenerator::Signal signal, Nanoseconds time);
  void take_over(const FrameWrites::Write& write, std::span<const std::uint8_t> bytes);
  void commit_register(const FrameWrites::Write& write, Nanoseconds time);
  /// Forwarding rule for a circulating frame; false: it is destroyed.
  [[nodiscard]] bool mark_circulating(std::span<PassingDatagram> datagrams);
  void load_configuration();
  void reload_maps();
  void implement_registers();

  // Plans of frames (esc_plans.cpp).
  /// Null: the datagrams must be executed.
  [[nodiscard]] const FramePlan* plan_for(PassingFrame& frame);
  /// `first`: of the steps; those before are done.
  void follow(const FramePlan& plan, std::uint8_t* frame, unsigned first = 0);
  /// One that is not usual. `memory`: the ESC's, from the step's address on.
  void follow(const FramePlan::Step& step, std::uint8_t* memory, std::uint8_t* data);
  void tell_events(std::uint8_t told);
  /// Adds the bits of 0x092C.
  void or_difference(std::uint8_t* data) const;
  /// The master has read these SyncManagers (a bit each).
  void read_buffers(std::uint32_t managers);
  /// Those of which it gives.
  void open_buffers(const FramePlan& plan);
  /// Nothing is under way: found out once, and again after whatever may have begun something.
  [[nodiscard]] bool is_as_usual() { return as_usual_ || becomes_usual(); }
  [[nodiscard]] bool becomes_usual();
  /// What frames do to it depends on more than its settings, or they do more than its plans say.
  [[nodiscard]] bool has_something_under_way() const {
    return managers_.stale() || managers_.any_pending() || reset_.begun() || ports_.changed() || protection_.lifted() ||
           ports_.port0_automatically_closed();
  }
  [[nodiscard]] bool pass_at_once(const FramePlan& plan, PassingFrame& frame, bool asked, Nanoseconds begin,
                                  Nanoseconds end) {
    if (end >= idle_until_ || !is_as_usual()) [[unlikely]]
      return false;
    if (cycles_.repeating && (asked || !plan.is_passive())) return repeat_at_once(plan, frame, asked, begin, end);
    if (asked) [[unlikely]]
      answer(frame, begin);
    plan.is_passive() ? follow_passively(plan, frame, begin, end) : follow_at_once(plan, frame, begin, end);
    return true;
  }
  void follow_at_once(const FramePlan& plan, PassingFrame& frame, Nanoseconds begin, Nanoseconds end);
  /// The same by a plan that is_passive().
  void follow_passively(const FramePlan& plan, PassingFrame& frame, Nanoseconds begin, Nanoseconds end);
  /// The same while cycles are counted; false: this one is another, and nothing has been done.
  [[nodiscard]] bool repeat_at_once(const FramePlan& plan, PassingFrame& frame, bool asked, Nanoseconds begin,
                                    Nanoseconds end);
  /// Gives what it is asked for, before anything else that the frame does: the registers show the time before its end.
  void answer(PassingFrame& frame, Nanoseconds begin);
  /// The outputs that it brings are those that are there.
  [[nodiscard]] bool holds_outputs_of(const FramePlan& plan, PassingFrame& frame) const;
  [[nodiscard]] bool only_reads_registers(const PassingDatagram& datagram) const;
  /// What is done with the frame's data, and what follows from it at once.
  void follow_data(const FramePlan& plan, PassingFrame& frame, Nanoseconds end, unsigned first = 0);
  /// Something else happens then, unless the cycle goes on.
  void repeat_until(Nanoseconds time) {
    const auto& clock = dc_.clock();
    idle_until_ = clock.runs_nearly_true() ? std::min({time, quiet_until_, clock.next_change()}) : INT64_MIN;
  }
  void end_cycles();
  void take_up(const FramePlan& plan, const std::uint8_t* frame);
  [[nodiscard]] static std::uint64_t time_in(const FramePlan& plan, const std::uint8_t* frame);
  void restart_watchdog(Nanoseconds time);
  void execute_all(PassingFrame& frame);
  Options options_;
  EscMemory memory_;
  EscPorts ports_;

  // Of every frame, and therefore together, in few lines of the processor's cache:
  DcUnit dc_;
  ProcessDataWatchdog watchdog_;
  Nanoseconds idle_until_ = INT64_MIN;
  Nanoseconds quiet_until_ = INT64_MIN;  // nothing is due before that is not the clock's
  Nanoseconds frame_time_ = 0;           // when the last frame began to pass
  std::uint32_t generation_ = 1;         // of the settings that plans are made by
  std::uint32_t minded_ = ~0U;           // SyncManagers whose transfers the device is told of
  std::uint32_t renewed_by_signal_ = 0;  // bit per SyncManager
  struct Renewal {
    std::uint32_t by = 0, renewed = 0;  // bit per SyncManager
  };
  Renewal renewed_by_transfer_;
  bool as_usual_ = false;                       // has_something_under_way() has said no
  std::uint16_t events_ = 0, told_events_ = 0;  // ECAT event request, and what of it frames carry, since then
  RepeatedCycles cycles_;
  SyncManagers managers_;
  std::array<FramePlan, FramePlan::kPlaces> plans_{};

  SiiInterface sii_;
  PdiWatchdog pdi_watchdog_;
  AlRegisters al_;
  FramePlanner planner_;
  // Of every frame that must be executed, and therefore together, too:
  FmmuUnit fmmus_;
  StationAddresses addresses_;
  EventRequests requests_;
  WriteProtection protection_;
  ResetSequence reset_;
  Listener* listener_ = nullptr;
  std::uint64_t own_changes_ = 0, *changes_ = &own_changes_;  // of the settings; here or of a whole bus
  std::uint64_t* event_changes_ = &own_changes_;              // of the ECAT event request, likewise
  bool sync_silent_ = false, prompt_ = false;

  // Of the frame that is passing:
  bool touched_ = false;
  std::uint8_t time_size_ = 0;  // bytes of the system time that a plan has received; 0: none
  std::uint64_t time_received_ = 0;
  std::array<std::optional<Nanoseconds>, 4> port_times_{};
  bool latch_unit_ = false, latch_ports_ = false;
  FrameWrites writes_;
};

}  // namespace syncline::sim
