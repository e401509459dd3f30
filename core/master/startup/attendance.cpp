// SPDX-License-Identifier: Apache-2.0
#include "master/startup/attendance.h"

#include <algorithm>
#include <utility>

#include "channels/event.h"
#include "config/master_settings.h"
#include "config/slave_config.h"
#include "master/exchange/bus.h"
#include "master/exchange/run_state.h"
#include "master/scan/bus_match.h"
#include "master/startup/bus_survey.h"
#include "master/startup/hot_connect.h"
#include "master/startup/slave_commands.h"

namespace syncline {

bool Attendance::complete() const {
  return std::ranges::none_of(missing_, [](bool missing) { return missing; });
}

Status Attendance::check(std::uint16_t count) {
  const auto& slaves = run_.config().slaves;
  const bool groups =
      std::ranges::any_of(slaves, [](const SlaveConfig& slave) { return slave.hot_connect.has_value(); });
  if (count == slaves.size() && !groups) return {};
  const auto found = look(count);
  if (!found) return tl::unexpected(found.error());
  if (found->allowed) return {};
  if (count == slaves.size() && !found->errors.empty()) return fail(found->errors.front());
  Error error{ErrorCode::kSlaveCount};
  error.expected = static_cast<std::int64_t>(slaves.size());
  error.received = count;
  return fail(std::move(error));
}

Status Attendance::explain_refusal(Status status) {
  const auto found = look(static_cast<std::uint16_t>(run_.config().slaves.size()));
  return found ? std::move(status) : Status(tl::unexpected(found.error()));
}

Result<Attendance::Differences> Attendance::look(std::uint16_t count) {
  const auto& config = run_.config();
  auto found = survey_bus(bus_, count);
  if (!found) return tl::unexpected(found.error());
  if (auto known = identify_groups(bus_, config, *found); !known) return tl::unexpected(known.error());
  std::vector<WantedDevice> wanted;
  for (std::size_t i = 0; i < config.slaves.size(); ++i) wanted.push_back(wanted_device(config, i));
  const auto match = match_bus(wanted, *found);
  Differences differences{.errors = explain(match, config, *found)};
  for (const auto& error : differences.errors) run_.teller.error(error, bus_.clock().now());
  const bool any = match.missing.size() + match.absent.size() < config.slaves.size();
  const bool usable = match.swapped.empty() && match.wrong.empty() && any;
  // Hot-connect groups may be absent; others only where the user said so.
  const bool complete = match.missing.empty() && match.extra.empty();
  differences.allowed = usable && (complete || config.recovery.start_incomplete);
  if (!differences.allowed) {
    // Who is in its place is there, whatever keeps the bus from being started.
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      auto& slave = run_.snapshot.slaves[i];
      slave.present = match.position[i].has_value();
      if (slave.present) continue;
      slave.al_status = slave.al_status_code = 0;
      slave.al_status_time = 0;
    }
    run_.states.note_slave_change();
    return differences;
  }
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    missing_[i] = !match.position[i].has_value();
    if (match.position[i]) commands_.set_position(i, *match.position[i]);
  }
  for (const auto slave : match.absent)
    run_.teller.hot_connect(slave, events::HotConnect::What::kNotThereYet, bus_.clock().now());
  return differences;
}

}  // namespace syncline
