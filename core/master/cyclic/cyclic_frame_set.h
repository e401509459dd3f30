// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/clocks/ored_deviation.h"
#include "master/cyclic/task_slots.h"
#include "master/exchange/frame_exchange.h"
#include "protocol/al_state.h"

namespace syncline {

struct CyclicCmd;
struct CyclicTask;
struct NetworkConfig;

/// The cyclic frames of a configuration with their process image: what is sent each cycle and what its
/// answers say. Everything is sized at construction; a cycle allocates nothing.
class CyclicFrameSet {
 public:
  explicit CyclicFrameSet(const NetworkConfig& config);
  CyclicFrameSet(const CyclicFrameSet&) = delete;
  CyclicFrameSet& operator=(const CyclicFrameSet&) = delete;

  /// Which commands are sent: those whose State list names `state`.
  void select(AlState state);
  /// True when a command that is sent in the selected state reads 0x092C from all slaves.
  [[nodiscard]] bool reads_deviation() const;

  /// Fills the frames of cycle number `cycle`. `steer`: the reference clock is to be written (bus shift); if not, that
  /// command travels as a NOP, because any value written to 0x0910 steers the clock.
  void prepare(std::int64_t slot, bool steer);
  /// Times in the frame that is being sent, which depend on that moment; system time. `reference_time`: what the
  /// reference clock will show; slaves in front of it are written what the master sends, before the clock has put its
  /// own time into the datagram.
  void stamp(const PendingFrame* frame, Nanoseconds reference_time, std::optional<Nanoseconds> reference_write);
  [[nodiscard]] std::span<PendingFrame* const> frames() const { return active_; }
  /// Whether the frames of the configuration's task go out with this cycle. After prepare().
  [[nodiscard]] bool is_due(std::size_t task) const { return task < tasks_.size() && tasks_[task].due; }
  /// The one that carries the reference clock's time in this cycle, if any does.
  [[nodiscard]] const PendingFrame* time_frame() const { return time_frame_; }
  /// The one that writes the reference clock a time in this cycle, if any does.
  [[nodiscard]] const PendingFrame* write_frame() const { return write_frame_; }

  /// Whose clock the commands read and steer that the configuration means for the reference clock: that one,
  /// another slave's, or nobody's (then they travel as NOP: a clock that has just been switched on must not
  /// be handed to the others).
  struct Leader {
    enum class Who : std::uint8_t { kConfigured, kOther, kNobody } who = Who::kConfigured;
    std::uint16_t station = 0;  // of the other
    bool operator==(const Leader&) const = default;
  };
  void follow(Leader leader);
  [[nodiscard]] Leader leader() const { return leader_; }
  /// It is known again who is there: whoever answers the reference clock's command now is who it means.
  void take_attendance();
  /// The commands as they are configured read and steer this slave's clock.
  [[nodiscard]] bool configured_for(std::uint16_t position, std::uint16_t station) const;

  /// The time that is written to the reference clock is corrected by the link while it sends.
  void correct_by_link();

  /// Working counters count without the slaves that are marked: they are lost, or in a state without process data.
  void expect_without(const std::vector<bool>& slaves);
  /// Expected process-data counters of all commands, by the configuration and now.
  [[nodiscard]] std::uint16_t wkc_configured() const;
  [[nodiscard]] std::uint16_t wkc_expected() const;

  /// The frames of this cycle with the slave's outputs have come back; all of them, where the configuration does not
  /// say which these are. Of a task that is not due nothing is asked for.
  [[nodiscard]] bool brought_outputs(std::size_t slave) const;

  /// The one in this cycle with all outputs of the slave that go at all, or all its inputs; null where there is none,
  /// or not one alone. After prepare().
  [[nodiscard]] PendingFrame* frame_with(bool outputs, std::size_t slave);

  /// What the answers of this cycle say.
  struct Reading {
    std::uint16_t wkc_expected = 0, wkc_received = 0;       // process data
    std::optional<std::uint16_t> al_status, al_status_wkc;  // all slaves ored
    std::optional<std::uint64_t> reference_time;            // as wide as it was read
    bool reference_is_64bit = false;
    std::optional<OredDeviation> deviation_ored;
  };
  /// Takes the answers over into the process image and performs the slave-to-slave copies.
  Reading evaluate();

  /// A byte of the logical address space that a command reads from slaves.
  struct LogicalByte {
    std::size_t entry = 0, offset = 0;
  };
  [[nodiscard]] std::optional<LogicalByte> find_logical(std::uint32_t address) const;
  /// The bytes of an entry as they came back in the cycle that was evaluated last, whatever the working counter
  /// expected; nothing when it did not.
  [[nodiscard]] std::span<const std::uint8_t> read_logical(std::size_t entry) const;

  /// Ones for the bytes of inputs() that came back lately with the expected working counter (0.1 s, or the last time
  /// that a slower task read them); zeros for the others, which keep what they were. As long as inputs().
  void mark_known_inputs(std::span<std::uint8_t> known) const;
  /// A command that carries some bytes of the image.
  struct Carrier {
    std::uint16_t entry = 0;
    std::uint16_t bytes = 0;  // a bit a byte, the first in bit 0
  };
  /// Those of at most 16 bytes from `first_byte` on, of the inputs or the outputs; how many there are, the first of
  /// which are put into `out`.
  std::size_t find_carriers(bool output, std::size_t first_byte, std::size_t count, std::span<Carrier> out) const;
  /// Its inputs are those of the last time that it was due, which is in this cycle or belongs to a slower task: they
  /// came back with the expected working counter. After evaluate().
  [[nodiscard]] bool has_news(Carrier carrier) const {
    return entries_[carrier.entry].read && entries_[carrier.entry].unread == 0;
  }
  /// It goes out with this cycle; in the state that is selected at all. After prepare().
  [[nodiscard]] bool is_sent(Carrier carrier) const { return entries_[carrier.entry].sent; }
  [[nodiscard]] bool is_selected(Carrier carrier) const { return entries_[carrier.entry].selected; }
  [[nodiscard]] std::span<const std::uint8_t> outputs() const { return outputs_; }
  [[nodiscard]] std::span<std::uint8_t> outputs() { return outputs_; }
  [[nodiscard]] std::span<const std::uint8_t> inputs() const { return inputs_; }

 private:
  enum class Role : std::uint8_t { kOther, kProcessData, kAlStatus, kReferenceTime, kReferenceWrite, kDeviation };
  struct Entry {
    const CyclicCmd* command = nullptr;
    Role role = Role::kOther;
    std::size_t frame = 0;
    std::size_t task = 0;
    bool selected = false;
    bool sent = false;
    Nanoseconds period = 0;         // between two times that it is sent
    bool read = false;              // its answer was taken since it was selected
    std::uint32_t unread = 0;       // times that it was sent without, since then
    std::uint16_t wkc_without = 0;  // part of the expected counter that does not come now
    std::uint16_t wkc_of_all = 0;   // of the reference clock's command: the most since attendance was taken
    int doubted = 0;                // cycles in a row in which it was less
    std::uint32_t told = 0;         // the lower half of the time that it was sent with
    std::vector<std::uint8_t> data;
    Datagram datagram;
  };

  /// Part of a command's working counter that one slave makes.
  struct Share {
    std::size_t slave = 0, entry = 0;
    std::uint16_t wkc = 0;
  };

  struct Task {
    TaskTurn turn;
    bool due = false;
  };

  static Role role_of(const CyclicCmd& command);
  void add_task(const CyclicTask& task, Nanoseconds base_cycle);
  void size_images(const NetworkConfig& config);
  void share_counters(const NetworkConfig& config);
  [[nodiscard]] static bool answered_by_leader(Entry& entry);
  void address_leader(Entry& entry);
  void fill(Entry& entry, bool steer);
  static void fill_time(Entry& entry, Nanoseconds time);
  void read(Entry& entry, Reading& reading);
  void store_inputs(const Entry& entry);
  void copy_slave_to_slave(const Entry& entry);

  std::uint32_t data_offset_;
  std::vector<Task> tasks_;
  std::vector<Entry> entries_;
  std::vector<Share> shares_;
  std::vector<std::vector<std::uint16_t>> writers_, readers_;  // by slave: entries that carry its outputs, its inputs
  Leader leader_;
  std::vector<PendingFrame> frames_;
  std::vector<PendingFrame*> active_;
  const PendingFrame* time_frame_ = nullptr;
  const PendingFrame* write_frame_ = nullptr;
  std::vector<std::uint8_t> inputs_, outputs_;
};

}  // namespace syncline
