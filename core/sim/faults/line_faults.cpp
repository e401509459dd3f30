// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/line_faults.h"

#include <algorithm>

#include "sim/segment/segment.h"

namespace syncline::sim {

void LineFaults::remove(const Fault& fault) {
  const auto place = std::ranges::find(faults_, fault);
  if (place != faults_.end()) faults_.erase(place);
}

bool LineFaults::takes_frame() {
  if (to_lose_ == 0) return false;
  --to_lose_;
  return true;
}

std::size_t LineFaults::somewhere(std::size_t receptions) {
  return std::min(receptions - 1, static_cast<std::size_t>(random_.uniform() * static_cast<double>(receptions)));
}

LineFaults::Reach LineFaults::next_frame(std::span<const Passage> passages) {
  Reach reach{passages.size(), passages.size()};
  if (passages.empty() || (faults_.empty() && loss_ <= 0)) return reach;
  if (loss_ > 0 && happens(loss_)) reach.end = somewhere(passages.size());
  for (auto& fault : faults_) {
    if (fault.slave == kAnywhere && happens(fault.probability))
      reach.end = std::min(reach.end, somewhere(passages.size()));
  }
  for (std::size_t p = 0; p < reach.end; ++p) {
    if (passages[p].looped) continue;
    for (auto& fault : faults_) {
      if (fault.slave != passages[p].slave || fault.port != passages[p].port || fault.frames == 0) continue;
      if (!happens(fault.probability)) continue;
      if (fault.frames != kUntilRemoved) --fault.frames;
      auto& place = fault.damaged ? reach.damaged : reach.end;
      place = std::min(place, p);
    }
  }
  std::erase_if(faults_, [](const Fault& fault) { return fault.frames == 0; });
  return reach;
}

}  // namespace syncline::sim
