// SPDX-License-Identifier: Apache-2.0
#include "eni/project/line_wiring.h"

#include <array>

#include "config/port_kind.h"
#include "config/previous_port.h"
#include "config/slave_settings.h"

namespace syncline::eni {
namespace {

constexpr std::array<std::uint8_t, 3> kFrameOrder{3, 1, 2};  // a frame leaves by port D, then B, then C

}  // namespace

void wire_in_order(std::vector<SlaveSettings>& slaves) {
  std::vector<std::size_t> next_port(slaves.size(), 0);  // place in kFrameOrder behind the last used port
  for (std::size_t i = 1; i < slaves.size(); ++i) {
    const auto own = port_kind(slaves[i].device, 0) == PortKind::kEbus ? PortKind::kEbus : PortKind::kCable;
    slaves[i].previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
    bool found = false;
    for (std::size_t parent = i; !found && parent-- > 0;) {
      for (std::size_t n = next_port[parent]; !found && n < kFrameOrder.size(); ++n) {
        found = port_kind(slaves[parent].device, kFrameOrder[n]) == own;
        if (!found) continue;
        slaves[i].previous = PreviousPort{static_cast<std::uint16_t>(parent), kFrameOrder[n]};
        next_port[parent] = n + 1;
        // The frame has come back from everything behind the parent.
        for (std::size_t closed = parent + 1; closed < i; ++closed) next_port[closed] = kFrameOrder.size();
      }
    }
  }
}

}  // namespace syncline::eni
