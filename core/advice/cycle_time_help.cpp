// SPDX-License-Identifier: Apache-2.0
#include "advice/cycle_time_help.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "compile/coe_init_cmds.h"
#include "compile/compile.h"
#include "compile/cyclic_frames.h"
#include "config/dc_description.h"
#include "config/frame_time.h"
#include "config/project.h"
#include "config/startup_origin.h"
#include "config/sync0_cycle.h"
#include "config/sync_unit_cycle.h"
#include "families/device_family.h"
#include "families/families.h"
#include "families/family_problems.h"
#include "protocol/assign_activate.h"
#include "reasons/because.h"
#include "settings/limits.h"
#include "settings/predicates.h"

namespace syncline {
namespace {

constexpr Nanoseconds kShortest = limits::kShortestCycle, kLongest = limits::kLongestCycle;

using families::microseconds;

/// What one slave demands of the cycle of its task.
struct Demand {
  int slave = 0;
  const SlaveSettings* settings = nullptr;
  const families::Family* family = nullptr;
  std::optional<Nanoseconds> minimum;  // of its dictionary
  const DcOpMode* mode = nullptr;      // with SYNC0, else null
  std::uint32_t multiple = 1;          // cycles of the bus that its task takes
  bool dc = false;                     // a SYNC signal is on
  std::vector<Nanoseconds> fixed;      // SYNC cycles that do not follow the bus
  std::vector<std::int64_t> divisors;  // of negative factors
  bool interpolates = false;           // 0x60C2 of the ESI follows the cycle
};

void add_unit(Demand& demand, const DcTime& time, const SyncUnitSettings& user) {
  if (user.user_cycle) {
    // It replaces the factor and does not follow the bus.
    if (*user.user_cycle > 0) demand.fixed.push_back(*user.user_cycle);
    return;
  }
  const std::int64_t factor = user.cycle_factor ? *user.cycle_factor : time.value_ns != 0 ? 0 : time.factor.value_or(0);
  if (factor < -1) demand.divisors.push_back(-factor);
  if (factor == 0 && time.value_ns > 0) demand.fixed.push_back(time.value_ns);
}

Demand demand_of(const Project& project, std::size_t position, const std::vector<std::size_t>& tasks) {
  const SlaveSettings& slave = project.slaves[position];
  const auto multiple = [&](const std::string& unit) {
    const std::size_t task = tasks[compiler::sync_unit_number(project.master, unit)];
    return static_cast<std::uint32_t>(compiler::task_cycle(project.master, task) / project.master.cycle_time);
  };
  Demand demand;
  demand.slave = static_cast<int>(position);
  demand.settings = &slave;
  demand.family = families::find(slave.device);
  demand.minimum = families::minimum_cycle(slave.device);
  demand.multiple = std::max<std::uint32_t>(std::min(multiple(slave.output_unit), multiple(slave.input_unit)), 1);
  const DcOpMode* mode = project.master.dc.enabled ? compiler::selected_op_mode(slave) : nullptr;
  if (mode != nullptr && mode->assign_activate != 0) {
    demand.dc = true;
    const AssignActivate activate{mode->assign_activate};
    if (activate.sync0()) {
      add_unit(demand, mode->cycle_time_sync0, slave.dc.sync0);
      demand.mode = mode;
    }
  }
  demand.interpolates = std::ranges::any_of(slave.startup, [&](const StartupCommand& command) {
    return command.index == 0x60C2 && is_from_esi(command, slave.device);
  });
  return demand;
}

struct Refusal {
  Reason reason;  // empty: it takes the cycle
  bool partly = false;
};

/// Why a slave does not take a bus cycle.
Refusal refusal(const Demand& demand, Nanoseconds bus_cycle) {
  const Nanoseconds cycle = bus_cycle * demand.multiple;
  if (demand.minimum && cycle < *demand.minimum) {
    return {because("{limit} is the shortest cycle that its object 0x1C32:05 names", microseconds(*demand.minimum))};
  }
  // A free-running drive takes process data whenever they come.
  if (demand.family != nullptr && demand.mode != nullptr) {
    const auto times = compiler::dc_times(*demand.mode, demand.settings->dc, cycle);
    if (auto judgement = families::judge_cycle(*demand.family, times.cycle_time0); !judgement.reason.empty()) {
      return {std::move(judgement.reason), !judgement.refused};
    }
  }
  for (const Nanoseconds fixed : demand.fixed) {
    if (!settings::keeps_step(fixed, cycle)) {
      return {
          because("its operation mode {mode} has a SYNC0 every {cycle}, which is neither a multiple nor a part of it",
                  demand.settings->dc.op_mode, microseconds(fixed))};
    }
  }
  for (const std::int64_t divisor : demand.divisors) {
    if (cycle % divisor != 0) {
      return {because("its operation mode {mode} divides the cycle by {divisor}, which leaves a rest",
                      demand.settings->dc.op_mode, divisor)};
    }
  }
  if (demand.interpolates && !compiler::interpolation_time(cycle)) {
    return {because("its object 0x60C2 (interpolation time) cannot express it")};
  }
  return {};
}

class Help {
 public:
  Help(const Project& project, const NetworkConfig& config) : project_(project), need_(cycle_need(config, true)) {
    const auto tasks = compiler::unit_tasks(project.master);
    for (std::size_t i = 0; i < project.slaves.size(); ++i) demands_.push_back(demand_of(project, i, tasks));
  }

  CycleTimeHelp build() {
    find_limits();
    std::set<Nanoseconds> cycles{project_.master.cycle_time};
    for (const Nanoseconds usual :
         std::initializer_list<Nanoseconds>{kShortest, 62'500, 125'000, 250'000, 500'000, 1'000'000, 2'000'000,
                                            4'000'000, 5'000'000, 8'000'000, 10'000'000, 16'000'000, 20'000'000}) {
      cycles.insert(usual);
    }
    for (const Nanoseconds found : shortest_accepted()) cycles.insert(found);
    for (const Nanoseconds cycle : cycles) help_.candidates.push_back(judge(cycle));
    help_.current = judge(project_.master.cycle_time);
    return std::move(help_);
  }

 private:
  /// Least common multiple, bounded: beyond the longest cycle nothing is left to accept.
  static Nanoseconds common_multiple(Nanoseconds a, Nanoseconds b) {
    const Nanoseconds part = b / std::gcd(a, b);
    return a > kLongest / part ? kLongest + 1 : a * part;
  }

  /// `time` of the slave's cycle, in cycles of the bus; rounded up.
  static Nanoseconds on_bus(Nanoseconds time, const Demand& demand) {
    return (time + demand.multiple - 1) / static_cast<Nanoseconds>(demand.multiple);
  }

  void find_limits() {
    for (const Demand& demand : demands_) {
      if (demand.minimum) raise_shortest(on_bus(*demand.minimum, demand));
      if (demand.family == nullptr || demand.mode == nullptr || !demand.family->cycle || !follows_bus(demand)) continue;
      const families::CycleLimits& limits = *demand.family->cycle;
      const auto multiple = static_cast<Nanoseconds>(demand.multiple);
      help_.step = common_multiple(help_.step, limits.full_step / std::gcd(limits.full_step, multiple));
      const Nanoseconds least = std::max(limits.shortest, limits.full_step > 1 ? limits.full_step : 0);
      if (least > 0) raise_shortest(on_bus(least, demand));
      if (limits.longest > 0) help_.longest = std::min(help_.longest.value_or(kLongest), limits.longest / multiple);
    }
  }

  void raise_shortest(Nanoseconds least) { help_.shortest = std::max(help_.shortest.value_or(0), least); }

  /// SYNC0 comes once in each cycle of the slave's data; with factors and fixed cycles only trying tells.
  static bool follows_bus(const Demand& demand) {
    return compiler::dc_times(*demand.mode, demand.settings->dc, kMillisecond).cycle_time0 == kMillisecond;
  }

  /// A few of the shortest cycles in whole steps that everybody accepts.
  [[nodiscard]] std::vector<Nanoseconds> shortest_accepted() const {
    constexpr std::size_t kWanted = 3;
    constexpr int kTries = 4000;
    std::vector<Nanoseconds> found;
    const Nanoseconds step = std::max<Nanoseconds>(help_.step, 1);
    const Nanoseconds grid = step >= kShortest ? step : common_multiple(step, kShortest);
    Nanoseconds cycle = grid;
    for (int i = 0; i < kTries && cycle <= kLongest && found.size() < kWanted; ++i, cycle += grid) {
      if (judge(cycle).refusals.empty()) found.push_back(cycle);
    }
    return found;
  }

  [[nodiscard]] CycleCandidate judge(Nanoseconds cycle) const {
    CycleCandidate candidate{cycle, {}};
    if (cycle < kShortest || cycle > kLongest) {
      candidate.refusals.push_back(
          {-1,
           {},
           because("the bus cycle is {shortest} to {longest}", microseconds(kShortest), microseconds(kLongest))});
    }
    if (need_.wire >= cycle) {
      candidate.refusals.push_back(
          {-1, {}, because("the cyclic frames take {time} of wire time", microseconds(need_.wire))});
    } else if (need_.all() > cycle) {
      candidate.refusals.push_back(
          {-1,
           {},
           because("the cyclic frames take {time} of wire time and about {travel} through the slaves",
                   microseconds(need_.wire), microseconds(need_.travel)),
           true});
    }
    for (const Demand& demand : demands_) {
      auto refused = refusal(demand, cycle);
      if (refused.reason.empty()) continue;
      candidate.refusals.push_back({demand.slave, demand.settings->name, std::move(refused.reason), refused.partly});
    }
    return candidate;
  }

  const Project& project_;
  CycleNeed need_;
  std::vector<Demand> demands_;
  CycleTimeHelp help_;
};

}  // namespace

Result<CycleTimeHelp> cycle_time_help(const Project& project) {
  const auto compiled = compile(project);
  if (!compiled) return tl::unexpected(compiled.error());
  return Help(project, compiled->config).build();
}

}  // namespace syncline
