// SPDX-License-Identifier: Apache-2.0
#include "config/slave_options.h"

#include <array>
#include <utility>

namespace syncline {
namespace {

constexpr std::array<std::pair<SyncTypeChoice, std::string_view>, 4> kSyncTypes{{
    {SyncTypeChoice::kFreeRun, "free-run"},
    {SyncTypeChoice::kSmEvent, "sm-event"},
    {SyncTypeChoice::kSync0, "sync0"},
    {SyncTypeChoice::kSync1, "sync1"},
}};

}  // namespace

std::string_view sync_type_name(SyncTypeChoice type) {
  for (const auto& [value, name] : kSyncTypes) {
    if (value == type) return name;
  }
  return {};
}

std::optional<SyncTypeChoice> sync_type_from_name(std::string_view name) {
  for (const auto& [value, known] : kSyncTypes) {
    if (known == name) return value;
  }
  return std::nullopt;
}

}  // namespace syncline
