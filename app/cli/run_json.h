// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/json.h"
#include "protocol/al_state.h"

namespace syncline {
struct RunReport;
}  // namespace syncline

namespace syncline::cli {

/// The report as docs/json.md describes it.
[[nodiscard]] Json to_json(const RunReport& report);
/// The report as text for people.
[[nodiscard]] std::string to_text(const RunReport& report);
/// True when the run shows what was asked for: state, slaves in sync where monitored, DCM in sync.
[[nodiscard]] bool is_good(const RunReport& report, AlState target);

[[nodiscard]] std::string state_text(std::uint16_t al_status);

}  // namespace syncline::cli
