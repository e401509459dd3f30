// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "trace/trigger.h"

namespace syncline {

/// A trigger and what it found in a run, as the run keeps it beyond its end.
struct KeptTrigger {
  Trigger trigger;
  std::vector<TriggerEpisode> episodes;
  std::map<Nanoseconds, std::string> names{};  // which the user gave, by the episodes' moments
  bool operator==(const KeptTrigger&) const = default;
};

}  // namespace syncline
