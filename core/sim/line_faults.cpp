// SPDX-License-Identifier: Apache-2.0
#include "sim/line_faults.h"

#include <algorithm>

namespace syncline::sim {

void LineFaults::remove(std::uint16_t slave, std::uint8_t port, bool damaged) {
  std::erase_if(faults_, [&](const Fault& fault) {
    return fault.slave == slave && fault.port == port && fault.damaged == damaged && fault.frames == kUntilRemoved;
  });
}

bool LineFaults::takes_frame() {
  if (to_lose_ == 0) return false;
  --to_lose_;
  return true;
}

LineFaults::Reach LineFaults::next_frame(std::span<const Passage> passages) {
  Reach reach{passages.size(), passages.size()};
  if (faults_.empty()) return reach;
  for (std::size_t p = 0; p < reach.end; ++p) {
    for (auto& fault : faults_) {
      if (fault.slave != passages[p].slave || fault.port != passages[p].port || fault.frames == 0) continue;
      if (fault.frames != kUntilRemoved) --fault.frames;
      auto& place = fault.damaged ? reach.damaged : reach.end;
      place = std::min(place, p);
    }
  }
  std::erase_if(faults_, [](const Fault& fault) { return fault.frames == 0; });
  return reach;
}

}  // namespace syncline::sim
