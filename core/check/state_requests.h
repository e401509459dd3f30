// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "protocol/al_state.h"

namespace syncline {
struct InitCmd;
struct SlaveConfig;
}  // namespace syncline

namespace syncline::checker {

/// State in which a transition ends.
[[nodiscard]] AlState target(Transition transition);
/// State that an init command requests of the slave, if it writes AL control.
[[nodiscard]] std::optional<AlState> requested_state(const InitCmd& cmd);
/// Index of the command that requests the state in which the transition ends; the last AL control write on it.
[[nodiscard]] std::optional<std::size_t> state_request(const SlaveConfig& slave, Transition transition);

}  // namespace syncline::checker
