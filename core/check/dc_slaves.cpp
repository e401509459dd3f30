// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "check/network_view.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "protocol/assign_activate.h"
#include "protocol/registers.h"
#include "settings/predicates.h"

namespace syncline::checker {
namespace {

/// A number that an init command on PS writes, and where; the last one counts.
struct Written {
  std::uint32_t value = 0;
  std::size_t cmd = 0;
};

class DcSlaveCheck {
 public:
  DcSlaveCheck(const NetworkView& view, std::size_t slave, Findings& findings)
      : view_(view), slave_(slave), config_(view.config.slaves[slave]), findings_(findings) {
    activation_ = last_written(reg::kCyclicUnitControl, 2);
    cycle0_ = last_written(reg::kSync0CycleTime, 4);
    cycle1_ = last_written(reg::kSync1CycleTime, 4);
    start_ = last_written(reg::kStartTimeCyclicOperation, 4);
  }

  void run() {
    if (activation_ && AssignActivate{activated()}.unit_on()) {
      check_activation(AssignActivate{activated()}, *activation_);
    } else if (config_.dc && config_.dc->cycle_time0 > 0 && !config_.init_cmds.empty()) {
      add("ENI-DC-17/off", dc_place(), fig::time<"cycle">(config_.dc->cycle_time0));
    }
    if (config_.dc) check_element(*config_.dc);
  }

 private:
  template <FigureName... kNames>
  void add(Sentence<kNames...> code, const ConfigPlace& place, Named<kNames>... figures) {
    findings_.add<kNames...>(code, place, std::move(figures)...);
  }
  [[nodiscard]] ConfigPlace dc_place() const { return {PlaceKind::kDc, slave_}; }
  [[nodiscard]] ConfigPlace place(const Written& written) const {
    return {PlaceKind::kSlaveInitCmd, slave_, written.cmd};
  }
  [[nodiscard]] std::uint16_t activated() const { return static_cast<std::uint16_t>(activation_->value); }

  [[nodiscard]] std::optional<Written> last_written(std::uint16_t ado, std::size_t bytes) const {
    std::optional<Written> found;
    for (std::size_t i = 0; i < config_.init_cmds.size(); ++i) {
      if (!has_transition(config_.init_cmds[i], Transition::kPS)) continue;
      if (const auto value = written_number(config_.init_cmds[i], ado, bytes)) found = Written{*value, i};
    }
    return found;
  }

  void check_activation(const AssignActivate& assign, const Written& written) {
    if (assign.sync1() && !assign.sync0()) {
      add("ENI-DC-12", place(written), fig::hex<"activation">(assign.value));
    }
    if (assign.sync0()) {
      if (!cycle0_ || cycle0_->value == 0) {
        cycle0_ ? add("ENI-DC-10", place(written)) : add("ENI-DC-10/never", place(written));
      } else if (cycle0_->cmd > written.cmd) {
        add("ENI-DC-13", place(written));
      }
      if (!start_) {
        add("ENI-DC-14", place(written));
      } else if (start_->cmd > written.cmd) {
        add("ENI-DC-13/start", place(written));
      }
      check_switched_off(written);
    }
    if (!config_.dc) {
      add("ENI-DC-17", {PlaceKind::kSlave, slave_}, fig::hex<"activation">(assign.value));
    }
  }

  void check_switched_off(const Written& written) {
    for (const Transition transition : {Transition::kSP, Transition::kSI}) {
      const bool off = std::ranges::any_of(config_.init_cmds, [&](const InitCmd& cmd) {
        return has_transition(cmd, transition) && (written_number(cmd, reg::kActivation, 1) == 0U);
      });
      if (off) return;
    }
    add("ENI-DC-16", place(written));
  }

  void check_element(const SlaveDcConfig& dc) {
    if (cycle0_ && static_cast<std::int64_t>(cycle0_->value) != dc.cycle_time0) {
      add("ENI-DC-11", place(*cycle0_), fig::time<"written">(cycle0_->value), fig::time<"said">(dc.cycle_time0));
    }
    // CycleTime1 is the distance of SYNC1 from SYNC0 and may be negative.
    if (cycle1_ && static_cast<std::int64_t>(cycle1_->value) != dc.cycle_time1 &&
        static_cast<std::int32_t>(cycle1_->value) != dc.cycle_time1) {
      add("ENI-DC-11/sync1", place(*cycle1_), fig::time<"written">(cycle1_->value), fig::time<"said">(dc.cycle_time1));
    }
    if (start_ && static_cast<std::int32_t>(start_->value) != dc.shift_time) {
      add("ENI-DC-15", place(*start_), fig::time<"written">(static_cast<std::int32_t>(start_->value)),
          fig::time<"said">(dc.shift_time));
    }
    if (dc.cycle_time1 != 0 && activation_ && AssignActivate{activated()}.sync0() &&
        !AssignActivate{activated()}.sync1()) {
      add("ENI-DC-20", dc_place(), fig::time<"time">(dc.cycle_time1), fig::hex<"activation">(activated()));
    }
    if (dc.cycle_time0 > 0) check_cycle(dc);
  }

  void check_cycle(const SlaveDcConfig& dc) {
    if (!settings::within_period(dc.shift_time, dc.cycle_time0)) {
      add("ENI-DC-19", dc_place(), fig::time<"shift">(dc.shift_time), fig::time<"cycle">(dc.cycle_time0));
    }
    const auto fits = [&](const CyclicTask& task) {
      return task.cycle_time > 0 && (dc.cycle_time0 % task.cycle_time == 0 || task.cycle_time % dc.cycle_time0 == 0);
    };
    const auto& tasks = view_.config.cyclic;
    if (!tasks.empty() && std::ranges::none_of(tasks, fits)) {
      add("ENI-DC-18", dc_place(), fig::time<"sync0">(dc.cycle_time0), fig::time<"cycle">(tasks.front().cycle_time));
    }
  }

  const NetworkView& view_;
  std::size_t slave_;
  const SlaveConfig& config_;
  Findings& findings_;
  std::optional<Written> activation_, cycle0_, cycle1_, start_;
};

}  // namespace

void check_dc_slaves(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    DcSlaveCheck(view, i, findings).run();
  }
}

}  // namespace syncline::checker
