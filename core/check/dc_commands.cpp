// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "check/network_view.h"
#include "config/command_text.h"
#include "config/network_config.h"
#include "protocol/assign_activate.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

bool uses_clock(const NetworkView& view, std::size_t slave) {
  const auto& dc = view.config.slaves[slave].dc;
  return (dc && (dc->reference_clock || dc->cycle_time0 > 0)) || AssignActivate{view.assign_activate(slave)}.unit_on();
}

class DcCommandCheck {
 public:
  DcCommandCheck(const NetworkView& view, Findings& findings) : view_(view), findings_(findings) {
    for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
      if (uses_clock(view, i)) clocks_.push_back(i);
      if (view.config.slaves[i].dc && view.config.slaves[i].dc->reference_clock) references_.push_back(i);
    }
  }

  void run() {
    if (view_.drift_compensation) {
      check_drift_compensation(*view_.drift_compensation);
    } else if (!clocks_.empty()) {
      findings_.add("ENI-DC-01", {PlaceKind::kDc, clocks_.front()}, fig::count<"slaves">(clocks_.size()));
    }
    if (references_.size() > 1) {
      findings_.add("ENI-DC-04", {PlaceKind::kDc, references_[1]}, view_.slave<"first">(references_[0]),
                    view_.slave<"second">(references_[1]));
    }
    for (const CyclicPlace& cyclic : view_.cyclic) {
      check_length(cyclic);
      check_steering(cyclic);
      if (is_sync_window(*cyclic.cmd) && clocks_.size() < 2) {
        findings_.add("ENI-DC-06", cyclic.place(), fig::count<"slaves">(clocks_.size()));
      }
    }
  }

 private:
  static bool is_sync_window(const CyclicCmd& cmd) {
    return cmd.command == Command::kBrd && cmd.ado == reg::kSystemTimeDifference;
  }

  void check_drift_compensation(const CyclicPlace& armw) {
    const CyclicCmd& cmd = *armw.cmd;
    const auto& commands = view_.config.cyclic[armw.task].frames[armw.frame].commands;
    const bool room = std::any_of(
        commands.begin(), commands.begin() + static_cast<std::ptrdiff_t>(armw.index), [](const CyclicCmd& c) {
          return c.ado == reg::kReceiveTimePort0 && (c.command == Command::kNop || c.command == Command::kBwr);
        });
    if (!room) {
      findings_.add("ENI-DC-02", armw.place(), fig::text<"command">(address_text(cmd)));
    }
    for (const AlState state : {AlState::kPreop, AlState::kSafeop, AlState::kOp}) {
      if (has(cmd, state)) continue;
      findings_.add("ENI-DC-09", armw.place(), fig::text<"command">(address_text(cmd)),
                    fig::text<"state">(std::string(al_state_name(state))));
      break;
    }
    const auto addressee = view_.addressee(cmd.command, cmd.adp);
    if (!addressee) return;  // reported as addressing no slave
    if (references_.empty()) {
      findings_.add("ENI-DC-03/none", armw.place(), fig::text<"command">(address_text(cmd)),
                    view_.slave<"slave">(*addressee));
    } else if (std::ranges::find(references_, *addressee) == references_.end()) {
      findings_.add("ENI-DC-03", armw.place(), fig::text<"command">(address_text(cmd)),
                    view_.slave<"slave">(*addressee), view_.slave<"reference">(references_.front()));
    }
    for (const std::size_t slave : clocks_) {
      if (slave >= *addressee) break;
      findings_.add("ENI-DC-07", {PlaceKind::kDc, slave}, view_.slave<"reference">(*addressee));
    }
  }

  void check_length(const CyclicPlace& cyclic) {
    const CyclicCmd& cmd = *cyclic.cmd;
    if (is_logical(cmd.command) || cmd.command == Command::kNop) return;
    const bool time = cmd.ado == reg::kSystemTime && cmd.length() != 4 && cmd.length() != 8;
    const bool difference = cmd.ado == reg::kSystemTimeDifference && cmd.length() != 4;
    const auto place = cyclic.place();
    if (time) {
      findings_.add("ENI-DC-08", place, fig::text<"command">(address_text(cmd)), fig::count<"bytes">(cmd.length()));
    } else if (difference) {
      findings_.add("ENI-DC-08/difference", place, fig::text<"command">(address_text(cmd)),
                    fig::count<"bytes">(cmd.length()));
    }
  }

  /// The write that steers the reference clock (bus shift).
  void check_steering(const CyclicPlace& cyclic) {
    const CyclicCmd& cmd = *cyclic.cmd;
    if (cmd.ado != reg::kSystemTime || (cmd.command != Command::kApwr && cmd.command != Command::kFpwr)) return;
    const auto steered = view_.addressee(cmd.command, cmd.adp);
    const auto& armw = view_.drift_compensation;
    if (!armw) {
      findings_.add("ENI-DC-05/nothing", cyclic.place(), fig::text<"command">(address_text(cmd)));
    } else if (steered && steered != view_.addressee(armw->cmd->command, armw->cmd->adp)) {
      findings_.add("ENI-DC-05", cyclic.place(), fig::text<"command">(address_text(cmd)),
                    view_.slave<"slave">(*steered), fig::text<"distributor">(address_text(*armw->cmd)));
    } else if (std::tie(cyclic.task, cyclic.frame, cyclic.index) < std::tie(armw->task, armw->frame, armw->index)) {
      findings_.add("ENI-DC-21", cyclic.place(), fig::text<"command">(address_text(cmd)),
                    fig::text<"distributor">(address_text(*armw->cmd)));
    }
  }

  const NetworkView& view_;
  Findings& findings_;
  std::vector<std::size_t> clocks_, references_;
};

}  // namespace

void check_dc_commands(const NetworkView& view, Findings& findings) { DcCommandCheck(view, findings).run(); }

}  // namespace syncline::checker
