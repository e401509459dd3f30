// SPDX-License-Identifier: Apache-2.0
#include "settings/dc_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "config/dcm_settings.h"
#include "config/network_config.h"
#include "config/project.h"
#include "reasons/because.h"
#include "settings/predicates.h"
#include "settings/settings_table.h"
#include "settings/tables.h"

namespace syncline {
namespace {

using settings::Number;
using settings::Setting;

/// The numbers among these rows.
std::vector<Setting> numbers(std::vector<Setting> rows) {
  std::erase_if(rows, [](const Setting& row) { return !std::holds_alternative<Number>(row.type) || row.options; });
  return rows;
}

Status check(const std::vector<Setting>& rows, const Project& project) {
  for (const Setting& row : rows) {
    if (auto status = settings::check_number(row, project, {}); !status) return status;
  }
  return {};
}

}  // namespace

Status check_dc(const NetworkConfig& config) {
  static const auto rows = numbers(settings::dc_rows());
  if (!config.dc.enabled) return {};
  Project project;
  project.master.dc = config.dc;
  if (auto status = check(rows, project); !status) return status;
  const auto& clock = config.dc.reference_clock;
  if (clock && !settings::is_position(config.slaves.size(), *clock)) {
    return fail(ErrorCode::kBadValue, "master.dc.reference_clock",
                because("there is no slave at position {position}, the last one is at {last}", *clock,
                        static_cast<std::int64_t>(config.slaves.size()) - 1));
  }
  return {};
}

Status check_dcm_settings(const DcmSettings& settings, Nanoseconds cycle_time) {
  static const auto rows = numbers(settings::dcm_rows());
  Project project;
  project.master.cycle_time = cycle_time;
  project.master.dc.dcm = settings;
  return check(rows, project);
}

}  // namespace syncline
