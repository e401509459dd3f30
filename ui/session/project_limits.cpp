// SPDX-License-Identifier: Apache-2.0
#include "ui/session/project_limits.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "record/run_record.h"
#include "settings/settings_table.h"
#include "ui/session/project_document.h"

namespace syncline::ui {
namespace {

constexpr int kMostExponent = 30;

}  // namespace

RunLimits limitsOf(const Project& project) { return limits_of(project.master.cycle_time, project.master.dc); }

Status setLimit(ProjectDocument& document, Signal signal, double magnitude) {
  const auto text = QCoreApplication::translate("LiveStrip", "Limit in the plots");
  const auto wanted = std::abs(magnitude);
  if (limit_of({kMillisecond, 1, 0}, signal) > 0) {
    const auto exponent = std::clamp<std::int64_t>(std::llround(std::log2(wanted + 1)), 1, kMostExponent);
    return document.set(text, {{&settings::row("master.dc.sync_window_exponent"), {}, exponent}});
  }
  if (limit_of({kMillisecond, 0, 1}, signal) > 0) {
    const auto limit = std::max<std::int64_t>(std::llround(std::min(wanted, 1e15)), 1);
    return document.set(text, {{&settings::row("master.dc.in_sync_limit_ns"), {}, limit}});
  }
  return fail(ErrorCode::kBadValue, std::string(info(signal).key));
}

}  // namespace syncline::ui
