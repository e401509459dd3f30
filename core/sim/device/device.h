// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "config/sim_config.h"
#include "protocol/al_state.h"
#include "sim/device/al_checks.h"
#include "sim/device/process_data.h"
#include "sim/esc/esc.h"
#include "sim/mailbox/mailbox_handshake.h"
#include "sim/mailbox/mailbox_server.h"
#include "sim/objects/diagnosis_history.h"
#include "sim/objects/object_dictionary.h"

namespace syncline::sim {

class PinTrace;

/// Firmware behind an ESC: AL state machine with its checks, mailbox, process data. Behaviours of kinds
/// of devices derive from it and say what they do at SM2, at SYNC0 and when the state changes.
class Device : public Esc::Listener {
 public:
  Device(const SimSlaveConfig& config, Esc& esc);
  ~Device() override = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Runs what is due up to `time` in order: requests in work, SYNC signals, the watchdog.
  void advance_to(Nanoseconds time) {
    if (time < esc_.idle_until()) {
      now_ = std::max(now_, time);
      esc_.pass_idly(time);
    } else {
      run_until(time);
    }
  }
  [[nodiscard]] AlState state() const { return state_; }
  [[nodiscard]] ObjectDictionary& dictionary() {
    catch_up();
    return dictionary_;
  }

  // Faults.
  void refuse(AlState state, std::uint16_t code);
  void silence_mailbox(bool silent);
  /// The application takes so much longer to answer mailbox requests; 0: as usual.
  void slow_mailbox(Nanoseconds delay) { mailbox_delay_ = delay; }
  /// The application needs so much longer for each cycle, at most an hour; 0: as usual.
  void slow_application(Nanoseconds delay) {
    esc_.wake_up();
    application_delay_ = std::clamp<Nanoseconds>(delay, 0, 3600 * kSecond);
  }

  /// The firmware hangs: it sees nothing of what its ESC does, until it goes on with what it finds there.
  void stop_application(Nanoseconds time);
  void resume_application(Nanoseconds time);

  /// A frame passes the slave from `begin` to `end`.
  virtual void frame_received(Nanoseconds, Nanoseconds) {}
  /// frame_received() does something: no frame passes the ESC at once.
  [[nodiscard]] bool sees_frames() const { return sees_frames_; }
  /// Output pin `number` (from 1), as far as the device has pins that show edges.
  [[nodiscard]] virtual const PinTrace* output_pin(unsigned) const { return nullptr; }

  // Esc::Listener
  void al_control_written(Nanoseconds time) override;
  void sync_manager_written(unsigned number, Nanoseconds time) override;
  void sync_manager_read(unsigned number, Nanoseconds time) override;
  void sync_manager_set(unsigned number, Nanoseconds time) override;
  void process_data_watchdog_expired(Nanoseconds time) override;
  void sync_signal(SyncGenerator::Signal signal, Nanoseconds time) override;
  void signals_passed(Nanoseconds time) override { last_sync0_ = time; }
  void cycles_passed(std::uint64_t count, Nanoseconds time) override {
    last_sync0_ = time;
    on_cycles_passed(count, time);
  }

 protected:
  static constexpr std::uint16_t kCommunicationError = 0x8100;  // CiA 301 emergency code
  static constexpr int kMissingSyncs = 8;                       // in a row: the signal has stopped

  // What a behaviour adds.
  virtual void on_outputs(Nanoseconds) {}      // SM2 event with fresh outputs in the dictionary
  virtual void on_inputs_read(Nanoseconds) {}  // SM3 event: the master has fetched the inputs
  virtual void on_sync0(Nanoseconds) {}
  virtual void on_sync1(Nanoseconds) {}
  virtual void on_state(AlState) {}
  virtual std::uint16_t check_sync(AlState) { return 0; }  // AL status code, 0 = fine
  /// A request for a higher state has waited so long, and is to wait a little more: something is still on its way.
  virtual bool settling(AlState, Nanoseconds) { return false; }
  virtual void check_running(Nanoseconds) {}  // in OP, whenever time has passed
  virtual void on_resumed(Nanoseconds) {}     // its application goes on
  /// Nobody could tell whether check_running() is called before; the beginning of time: it must be, whenever time
  /// passes.
  [[nodiscard]] virtual Nanoseconds runs_alone_until() { return INT64_MIN; }

  /// Until the ESC is woken up, SYNC0 and process data that come and go would change nothing in OP but the outputs in
  /// the dictionary, and only that the same inputs are written again: with each SYNC0, or without one with new outputs.
  [[nodiscard]] virtual bool rests() { return false; }

  /// How long before SYNC0 outputs must come, when a cycle like the last one would change nothing that anybody could
  /// see: outputs that hold what they held, then SYNC0. Empty: one must look at each cycle.
  [[nodiscard]] virtual std::optional<Nanoseconds> repeats() { return std::nullopt; }
  /// There were `count` such cycles; the last SYNC0 came at `time`.
  virtual void on_cycles_passed(std::uint64_t, Nanoseconds) {}

  /// on_inputs_read() does something.
  [[nodiscard]] virtual bool minds_inputs_read() const { return false; }

  /// `code`: AL status code; `error_code`: of the emergency that goes with it.
  void drop_to_safeop(std::uint16_t code, std::uint16_t error_code = kCommunicationError);
  /// Tells the master: emergency and an entry in the diagnosis history. `text_id` of the ESI's DiagMessages.
  void tell_error(std::uint16_t error_code, std::uint8_t error_register, std::uint16_t text_id);
  [[nodiscard]] Nanoseconds application_delay() const { return application_delay_; }
  [[nodiscard]] MailboxServer& mailbox() { return mailbox_; }
  /// Behaviours that keep a diagnosis history although their ESI has none.
  void enable_diagnosis_history() { history_.enable(); }
  void inputs_from_dictionary() { process_data_.inputs_from_dictionary(); }
  void renew_inputs() { process_data_.renew_inputs(); }
  /// They are what they were, as long as the behaviour has changed nothing in the dictionary.
  [[nodiscard]] bool inputs_stay() const { return process_data_.inputs_stay(); }
  /// Another number whenever objects that the master writes may have changed.
  [[nodiscard]] std::uint32_t outputs_taken() const { return process_data_.outputs_taken(); }
  [[nodiscard]] bool inputs_map(std::uint16_t index) { return process_data_.inputs_map(index); }
  [[nodiscard]] bool has_outputs() const { return process_data_.has_outputs(); }
  /// The SyncManager by which the device works.
  [[nodiscard]] std::optional<unsigned> output_manager() const { return process_data_.sync_manager(PdoDirection::kRx); }
  [[nodiscard]] bool has_mailbox() const { return config_.device.mailbox.has_value(); }
  [[nodiscard]] Esc& esc() { return esc_; }
  [[nodiscard]] const DcUnit& dc() const { return std::as_const(esc_).dc(); }
  /// Up to when the device has run: a frame that passes its ESC at once does not tell it.
  [[nodiscard]] Nanoseconds now() const { return std::max(now_, esc_.frame_time()); }
  /// frame_received() does something, or no longer.
  void see_frames(bool see) {
    esc_.wake_up();
    sees_frames_ = see;
  }
  [[nodiscard]] const SimSlaveConfig& config() const { return config_; }

  ObjectDictionary dictionary_;

 private:
  void run_until(Nanoseconds time);
  /// What nobody would notice need not be told by the ESC.
  void rest();
  /// Cycles that are all alike need only be counted by the ESC.
  void repeat(Nanoseconds calculation, Nanoseconds time);
  /// What the ESC has only counted is done.
  void catch_up() {
    if (esc_.repeats_cycles()) esc_.wake_up();
  }
  /// Nothing of the device's own is due before.
  [[nodiscard]] Nanoseconds idle_until();
  /// When SYNC0 will have stayed away for too long.
  [[nodiscard]] Nanoseconds sync_patience() const;
  /// Does what AL control and the mailbox ask for, in the order in which it is due.
  void answer_until(Nanoseconds time);
  void stay_in_op(Nanoseconds time);
  void take_request(Nanoseconds time);
  void enter(AlState state);
  void report(AlState state, std::uint16_t code);
  [[nodiscard]] bool waits_for_sync(Nanoseconds waited) const;
  [[nodiscard]] bool needs_outputs() const { return process_data_.byte_length(PdoDirection::kRx) > 0; }
  [[nodiscard]] std::uint16_t check(AlState from, AlState to);
  void answer_mail();
  [[nodiscard]] bool exchanges_process_data() const { return has_process_data_communication(state_); }
  /// Adds the objects that every device has; they must be there before the PDOs map them.
  const DeviceDescription& identify();

  SimSlaveConfig config_;
  Esc& esc_;
  ProcessData process_data_;
  AlChecks checks_;
  MailboxServer mailbox_;
  MailboxHandshake handshake_;
  DiagnosisHistory history_;
  AlState state_ = AlState::kInit;
  bool error_ = false;
  static constexpr Nanoseconds kNever = INT64_MAX;
  Nanoseconds request_due_ = kNever, mail_due_ = kNever;
  std::optional<Nanoseconds> last_outputs_;
  std::optional<Nanoseconds> last_sync0_;  // since PREOP
  Nanoseconds sync0_cycle_ = 0;            // when OP was entered; 0: none
  Nanoseconds now_ = 0, requested_at_ = 0;
  bool mailbox_silent_ = false;
  bool stopped_ = false;  // the firmware hangs
  bool sees_frames_ = false;
  Nanoseconds mailbox_delay_ = 0, application_delay_ = 0;
  AlState refused_state_ = AlState::kNone;
  std::uint16_t refusal_code_ = 0;
};

/// Behaviour by its scenario name; "generic" for any other device.
[[nodiscard]] std::unique_ptr<Device> make_device(const SimSlaveConfig& config, Esc& esc);

}  // namespace syncline::sim
