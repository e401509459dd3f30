// SPDX-License-Identifier: Apache-2.0
#include "config/sync0_cycle.h"

#include <algorithm>

#include "config/dc_description.h"
#include "config/dc_settings.h"
#include "config/slave_settings.h"
#include "protocol/assign_activate.h"

namespace syncline::compiler {
namespace {

/// Files may say any number. The registers hold 4.3 s; what is bounded here is far beyond, and no product of two such
/// numbers overflows.
constexpr Nanoseconds kBound = 1'000 * kSecond;
constexpr std::int64_t kFactorBound = 1'000'000;

Nanoseconds bounded(Nanoseconds time) { return std::clamp(time, -kBound, kBound); }
std::int64_t bounded_factor(const std::optional<int>& factor) {
  return std::clamp<std::int64_t>(factor.value_or(0), -kFactorBound, kFactorBound);
}

class Calculation {
 public:
  explicit Calculation(Nanoseconds bus_cycle) : bus_cycle_(bounded(bus_cycle)) {}

  /// factor > 0 multiplies, < 0 divides the bus cycle, 0 gives 0.
  Nanoseconds scaled(std::int64_t factor) {
    if (factor >= 0) {
      return bounded(factor * bus_cycle_);
    }
    exact_ = exact_ && bus_cycle_ % -factor == 0;
    return bus_cycle_ / -factor;
  }

  /// A mode that switches SYNC0 on and says nothing of its cycle (no CycleTimeSync0) means the bus cycle: a SYNC0 of
  /// cycle 0 would come once.
  Nanoseconds cycle0(const DcTime& esi, const SyncUnitSettings& user, bool sync0_on) {
    if (const auto chosen = user_cycle(user)) {
      return *chosen;
    }
    if (sync0_on && esi.value_ns == 0 && !esi.factor) {
      return bus_cycle_;
    }
    return esi.value_ns != 0 ? bounded(esi.value_ns) : scaled(bounded_factor(esi.factor));
  }

  Nanoseconds cycle1(const DcTime& esi, const SyncUnitSettings& user, Nanoseconds cycle0) {
    if (const auto chosen = user_cycle(user)) {
      return *chosen;
    }
    if (esi.value_ns != 0) {
      return bounded(esi.value_ns);
    }
    const std::int64_t factor = bounded_factor(esi.factor);
    return bounded(factor >= 0 ? factor * cycle0 : -factor * bus_cycle_);
  }

  Nanoseconds shift(const DcTime& esi, const SyncUnitSettings& user) {
    return user.shift ? bounded(*user.shift) : bounded(bounded(esi.value_ns) + scaled(bounded_factor(esi.factor)));
  }

  [[nodiscard]] bool exact() const { return exact_; }

 private:
  std::optional<Nanoseconds> user_cycle(const SyncUnitSettings& user) {
    if (user.user_cycle) {
      return bounded(*user.user_cycle);
    }
    return user.cycle_factor ? std::optional(scaled(bounded_factor(user.cycle_factor))) : std::nullopt;
  }

  Nanoseconds bus_cycle_;
  bool exact_ = true;
};

}  // namespace

const DcOpMode* selected_op_mode(const SlaveSettings& slave) {
  if (!slave.device.dc || slave.dc.op_mode.empty()) {
    return nullptr;
  }
  const auto& modes = slave.device.dc->op_modes;
  const auto found = std::ranges::find(modes, slave.dc.op_mode, &DcOpMode::name);
  return found == modes.end() ? nullptr : &*found;
}

bool is_input_based(const DcOpMode& mode, const DcSlaveSettings& user) {
  return user.input_reference.value_or(mode.shift_time_sync0.input);
}

DcTimes dc_times(const DcOpMode& mode, const DcSlaveSettings& user, Nanoseconds bus_cycle, Nanoseconds input_shift) {
  Calculation calculation(bus_cycle);
  DcTimes times;
  times.cycle_time0 =
      calculation.cycle0(mode.cycle_time_sync0, user.sync0, AssignActivate{mode.assign_activate}.sync0());
  times.shift_time = calculation.shift(mode.shift_time_sync0, user.sync0);
  if (is_input_based(mode, user)) times.shift_time = bounded(times.shift_time + bounded(input_shift));
  if (AssignActivate{mode.assign_activate}.sync1()) {
    const Nanoseconds cycle1 = calculation.cycle1(mode.cycle_time_sync1, user.sync1, times.cycle_time0);
    const Nanoseconds beyond_sync0 = cycle1 == 0 ? 0 : cycle1 - times.cycle_time0;
    times.cycle_time1 = beyond_sync0 + calculation.shift(mode.shift_time_sync1, user.sync1);
  }
  times.exact = calculation.exact();
  return times;
}

Nanoseconds scaled_cycle(Nanoseconds bus_cycle, std::int64_t factor) { return Calculation(bus_cycle).scaled(factor); }

// SYNC1 is given as the distance from SYNC0, its shift included; with a shift of 0 the cycle is the sum.
Nanoseconds sync_cycle(const DcOpMode& mode, const DcSlaveSettings& user, int unit, Nanoseconds bus_cycle) {
  auto asked = user;
  if (unit == 1) asked.sync1.shift = 0;
  const auto times = dc_times(mode, asked, bus_cycle);
  return unit == 0 ? times.cycle_time0 : times.cycle_time0 + times.cycle_time1;
}

Nanoseconds shift_of_mode(const DcTime& shift, Nanoseconds bus_cycle) {
  return Calculation(bus_cycle).shift(shift, {});
}

}  // namespace syncline::compiler
