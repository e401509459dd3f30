// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "channels/event.h"

namespace syncline::test {

template <class... All>
[[nodiscard]] std::vector<Event> one_of_each(std::in_place_type_t<std::variant<All...>>) {
  return {Event{0, -1, All{}}...};
}
/// An event of each kind, with nothing in it.
[[nodiscard]] inline std::vector<Event> one_of_each() { return one_of_each(std::in_place_type<EventDetails>); }

}  // namespace syncline::test
