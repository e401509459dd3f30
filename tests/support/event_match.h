// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "channels/event.h"

namespace syncline::test {

using EventMatch = std::function<bool(const Event&)>;

/// Events of a kind with that value in one of its fields: with(&events::RecoveryStep::stage, Stage::kDone).
template <class What, class Field, class Value>
[[nodiscard]] EventMatch with(Field What::*field, Value value) {
  return [field, value](const Event& event) {
    const auto* what = event.as<What>();
    return what != nullptr && what->*field == value;
  };
}

}  // namespace syncline::test
