// SPDX-License-Identifier: Apache-2.0
#include "trace/watch_lists.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "channels/cycle_sample.h"

namespace syncline {

bool WatchLists::add(std::span<const WatchedVariable> variables) {
  if (variables.size() > kMostWatched) return false;
  auto known = variables_;
  List list{static_cast<std::uint32_t>(lists_.size() + 1), {}};
  std::array<std::uint8_t, kMostVariables> places{};
  places.fill(kNowhere);
  for (const auto& variable : variables) {
    auto found = std::ranges::find(known, variable);
    if (found == known.end()) {
      if (known.size() == kMostVariables) return false;
      found = known.insert(known.end(), variable);
    }
    const auto number = static_cast<std::size_t>(found - known.begin());
    if (places[number] != kNowhere) return false;
    places[number] = static_cast<std::uint8_t>(list.places.size());
    list.places.push_back(number);
  }
  variables_ = std::move(known);
  lists_.push_back(std::move(list));
  places_.push_back(places);
  return true;
}

WatchCommand WatchLists::command() const {
  WatchCommand command;
  if (lists_.empty()) return command;
  const auto& list = lists_.back();
  command.list = list.number;
  command.count = static_cast<std::uint8_t>(list.places.size());
  for (std::size_t i = 0; i < list.places.size(); ++i) {
    const auto& variable = variables_[list.places[i]];
    command.places[i] = {variable.output, variable.bit_offset, variable.bit_size, variable.slave};
  }
  return command;
}

std::vector<WatchedVariable> WatchLists::latest() const {
  std::vector<WatchedVariable> result;
  if (lists_.empty()) return result;
  for (const auto number : lists_.back().places) result.push_back(variables_[number]);
  return result;
}

std::optional<std::size_t> WatchLists::place(std::uint32_t list, std::size_t variable) const {
  if (list == 0 || list > places_.size() || variable >= variables_.size()) return std::nullopt;
  const auto place = places_[list - 1][variable];
  return place == kNowhere ? std::nullopt : std::optional<std::size_t>(place);
}

std::optional<std::uint64_t> WatchLists::bits(const CycleSample& sample, std::size_t variable) const {
  const auto at = place(sample.watch_list, variable);
  if (!at || (sample.watched_known >> *at & 1U) == 0) return std::nullopt;
  return sample.watched[*at];
}

float WatchLists::drawn(const CycleSample& sample, std::size_t variable) const {
  constexpr double kLargest = std::numeric_limits<float>::max();
  const auto found = bits(sample, variable);
  const auto value = found ? watched_value(variables_[variable], *found) : std::numeric_limits<double>::infinity();
  if (!std::isfinite(value)) return std::numeric_limits<float>::quiet_NaN();
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

}  // namespace syncline
