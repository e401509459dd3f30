// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "channels/values/miss_cause.h"
#include "dc/sync0_arrival.h"
#include "support/counter_total.h"
#include "support/types.h"

namespace syncline::dc {

/// The missed SM2 events of one slave with SYNC0, and its internal error counter (0x10F1: 3 more for each miss, 1 less
/// for each good period, never below 0), driven cycle by cycle from what the master knows of each cycle and corrected
/// by the readings of the slave's own counter. Source: 0x1C32 and 0x10F1, ETG.1020; the integrator as the Yaskawa
/// manual has it (+3, -1). Values only, allocates nothing; one thread.
class SyncEventAccount {
 public:
  explicit SyncEventAccount(const Sync0Grid& grid) : grid_(grid) {}

  struct Cycle {
    Nanoseconds time = 0;        // system time when the outputs were at the slave, or would have been
    bool delivered = false;      // the frame came back
    std::uint32_t left_out = 0;  // cycles that the host left out just before this one
    Nanoseconds need = 0;        // what the slave takes at most from its outputs to SYNC0 (0x1C32:06)
    Nanoseconds held = 0;        // of `time`: so much longer than it usually takes was the frame on its way
  };
  /// One bus cycle in OP. Outputs that leave less than `need` to SYNC0 may have been too late, and only the slave
  /// knows: its next reading tells.
  void observe(const Cycle& cycle);
  /// So many cycles that were not delivered have come back since, later than anybody waited for them: what was missed
  /// by them was not lost, but held up on the way. Also after the slave has left OP.
  void came_late(std::uint32_t cycles);
  /// System time at which the period behind the running one begins, while cycles are regular: each delivers its outputs
  /// in the period behind the one before, and there is no error to be counted down. Such a cycle changes nothing that
  /// can be asked for; nothing when they are not.
  [[nodiscard]] std::optional<Nanoseconds> regular_until() const {
    if ((frames_lost_ | held_up_ | left_out_ | integrator_) != 0) return std::nullopt;
    if (candidate_ != 0 && !in_doubt()) return std::nullopt;
    if (!evaluated_ || delivered_ != evaluated_) return std::nullopt;
    return grid_.first + (*evaluated_ + 1) * grid_.period;
  }
  /// So many regular cycles at once.
  void pass_regular(std::int64_t cycles) {
    evaluated_ = *evaluated_ + cycles;
    delivered_ = evaluated_;
    any_since_reading_ = any_since_reading_ || cycles > 0;
  }
  /// A reading of the slave's counter of missed events; 16 bits (ETG.1020).
  void read(std::uint32_t counter);
  /// The computed error counter has reached the limit: the slave has left OP, or soon proves that it did not miss so
  /// many. Nothing is counted on until then.
  [[nodiscard]] bool at_limit() const { return limit_ > 0 && integrator_ >= limit_; }
  /// The slave is known to be in OP still: whatever was computed, it has not reached its limit.
  void confirm_op();
  /// It was away for a while: what went on meanwhile only its counter knows.
  void came_back();
  /// The slave left OP: what it did not tell any more is taken from what was computed.
  void left_op();
  /// It left OP by its own count of misses, and its outputs nominally leave less than it needs: what it had missed at
  /// least, and nobody has read, were late outputs. Behind left_op().
  void gave_up_late();
  /// The same where it is not known what they leave nominally, because nobody holds the frames in their place: late
  /// were those that left less than it needs, if there were enough of them since its last readings. False: there were
  /// not.
  bool gave_up_in_doubt();
  /// OP again, with SYNC0 as it was started this time: the error counter begins at 0; the sums stay.
  void entered_op(const Sync0Grid& grid);
  /// 0x10F1:02, at which the slave gives up; 0: never, or not known.
  void set_limit(std::uint32_t limit) { limit_ = limit; }

  /// Misses since the first reading, those that were only computed included.
  [[nodiscard]] std::uint32_t missed() const;
  /// Part of missed() that no reading has confirmed, because the slave fell, or has no such counter.
  [[nodiscard]] std::uint32_t computed() const { return readable_ ? computed_ : missed(); }
  [[nodiscard]] bool at_least() const { return counter_.at_least() || uncounted_; }
  [[nodiscard]] MissesByCause by_cause() const;
  [[nodiscard]] std::uint32_t integrator() const;
  /// The most that it has reached. What the slave's next readings may yet take back does not count before they came.
  [[nodiscard]] std::uint32_t integrator_highest() const;

 private:
  [[nodiscard]] std::uint32_t missing_to_limit() const;
  void take_uncounted(std::uint32_t misses);
  void end_periods(std::int64_t ended, std::int64_t missed);
  void presume(std::uint32_t missed);
  std::uint32_t explain(std::uint32_t debt);
  std::uint32_t explain_by_doubt(std::uint32_t debt);
  std::uint32_t explain_rest();
  void correct(std::int64_t misses);
  /// Misses are presumed that the slave has not told yet.
  [[nodiscard]] bool in_doubt() const;
  void settle_peaks();
  void take_back_peaks(std::uint32_t misses);

  Sync0Grid grid_;
  std::uint32_t limit_ = 0;
  std::optional<std::int64_t> evaluated_;                       // number of the SYNC0 period that is running
  std::optional<std::int64_t> delivered_;                       // the last period with outputs
  std::uint32_t frames_lost_ = 0, held_up_ = 0, left_out_ = 0;  // since then
  MissesByCause presumed_{}, carried_{};                        // since the last reading, and left over from before it
  /// Periods whose outputs left less than the slave needs; likewise.
  struct Doubt {
    std::uint32_t late = 0, held_up = 0;
  };
  Doubt doubtful_, doubted_;
  std::uint32_t counted_down_ = 0;  // of the error counter, since the last reading
  std::uint32_t unexplained_ = 0;   // told by the last reading, and not presumed yet
  CounterTotal counter_{16, CounterTotal::End::kWraps};
  bool readable_ = false, any_since_reading_ = false;
  bool uncounted_ = false;                         // it may have missed more than its limit proves
  std::uint32_t computed_ = 0, before_first_ = 0;  // told by the first readings in OP
  MissesByCause by_cause_{};
  std::uint32_t integrator_ = 0, highest_ = 0;
  /// Of the error counter, and not known to be true: since the last reading, and between the two before it.
  std::uint32_t candidate_ = 0, earlier_ = 0;
};

}  // namespace syncline::dc
