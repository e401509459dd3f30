// SPDX-License-Identifier: Apache-2.0
#include "compile/dcm_check.h"

#include <algorithm>

#include "compile/cyclic_frames.h"
#include "config/external_clock.h"
#include "config/frame_time.h"
#include "findings/project_master_words.h"
#include "findings/sentence.h"
#include "protocol/dcm_error.h"
#include "protocol/registers.h"
#include "settings/dc_check.h"
#include "settings/predicates.h"
#include "settings/setting_type.h"

namespace syncline {
namespace {

template <FigureName... kNames>
Finding problem(std::type_identity_t<FindingSentence<words::kProjectMaster, kNames...>> code, Place place,
                Named<kNames>... figures) {
  return make_finding<words::kProjectMaster, kNames...>(code, std::move(place), std::move(figures)...);
}

bool any_slave_uses_dc(const NetworkConfig& config) {
  return std::ranges::any_of(config.slaves, [](const SlaveConfig& slave) { return slave.dc.has_value(); });
}

/// An ENI holds the bus cycle in whole microseconds.
constexpr Nanoseconds kRounding = kMicrosecond;

/// SYNC0 must come with the frames: every so many cycles, or so many times in one.
void check_sync_periods(const NetworkConfig& config, std::vector<DcmProblem>& problems) {
  const auto cycle = config.cycle_time();
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto& slave = config.slaves[i];
    if (!slave.dc || slave.dc->assign_activate == 0 || slave.dc->cycle_time0 == 0) continue;
    const auto sync = slave.dc->cycle_time0;
    if (settings::keeps_step(sync, cycle, kRounding)) continue;
    problems.push_back({problem("sync-period-out-of-step", static_cast<int>(i), fig::text<"name">(slave.name),
                                fig::time<"sync0">(sync), fig::time<"cycle">(cycle)),
                        dc::kDcmErrorInvalidSyncPeriod});
  }
}

void check_set_value(const NetworkConfig& config, Nanoseconds delay, std::vector<DcmProblem>& problems) {
  const auto& set_value = config.dc.dcm.set_value;
  const auto least = least_set_value(config, delay);
  if (!set_value || *set_value >= least || *set_value <= 0) return;
  problems.push_back({problem("set-value-too-small", -1, fig::time<"set_value">(*set_value), fig::time<"least">(least),
                              fig::time<"most">(settings::set_values(config.cycle_time()).high)),
                      dc::kDcmErrorInvalidSetValue});
}

}  // namespace

bool bus_shift_configured(const NetworkConfig& config) {
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      const bool found = std::ranges::any_of(frame.commands, [](const CyclicCmd& c) {
        return c.ado == reg::kSystemTime && (c.command == Command::kApwr || c.command == Command::kFpwr);
      });
      if (found) return true;
    }
  }
  return false;
}

Nanoseconds least_set_value(const NetworkConfig& config, Nanoseconds propagation_delay) {
  Nanoseconds wire = propagation_delay;
  if (!config.cyclic.empty()) {
    for (const auto& frame : config.cyclic.front().frames) wire += wire_time(frame);
  }
  return wire;
}

std::vector<DcmProblem> dcm_problems(const NetworkConfig& config, Nanoseconds propagation_delay) {
  std::vector<DcmProblem> problems;
  const auto& dcm = config.dc.dcm;
  if (auto status = check_dcm_settings(dcm, config.cycle_time()); !status) {
    problems.push_back(
        {problem("dcm-setting-invalid", {-1, status.error().subject}, fig::reason<"reason">(status.error().detail)),
         status.error().subject == "master.dc.set_value_us" ? dc::kDcmErrorInvalidSetValue : 0});
  }
  if (!config.dc.enabled || !any_slave_uses_dc(config)) return problems;
  check_sync_periods(config, problems);
  if (dcm.mode == DcmMode::kOff) return problems;
  check_set_value(config, propagation_delay, problems);
  if (steers_reference_clock(dcm.mode) && !bus_shift_configured(config)) {
    problems.push_back(
        {problem("bus-shift-without-command", -1, fig::text<"mode">(std::string(dcm_mode_name(dcm.mode)))),
         dc::kDcmErrorInvalidData});
  }
  if (dcm.mode == DcmMode::kDcx && !find_external_clock(config)) {
    problems.push_back({problem("external-clock-missing", -1), dc::kDcxErrorNoExternalClock});
  }
  return problems;
}

Status check_dcm(const NetworkConfig& config) {
  if (!config.dc.enabled) return {};
  const auto problems = dcm_problems(config);
  if (problems.empty()) return {};
  const Finding& first = problems.front().finding;
  auto facts = facts_text(first);
  if (facts.ends_with('.')) facts.pop_back();
  Error error{ErrorCode::kBadValue, first.place.key, Reason::verbatim(std::move(facts))};
  error.received = problems.front().code;
  return fail(std::move(error));
}

}  // namespace syncline
