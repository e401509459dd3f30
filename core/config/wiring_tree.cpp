// SPDX-License-Identifier: Apache-2.0
#include "config/wiring_tree.h"

#include <algorithm>
#include <utility>

#include "config/entry_ports.h"
#include "config/slave_settings.h"
#include "protocol/dl_status.h"

namespace syncline {
namespace {

/// How many ports a frame leaves before this one when it came in at `entry`.
std::size_t steps_from(std::uint8_t entry, std::uint8_t port) {
  const auto place = [](std::uint8_t wanted) {
    return static_cast<std::size_t>(std::ranges::find(kPortOrder, unsigned{wanted}) - kPortOrder.begin());
  };
  return (place(port) + kPortOrder.size() - place(entry)) % kPortOrder.size();
}

bool is_there(const PreviousPort& previous, std::size_t slaves) {
  return previous.position < slaves && previous.port < kPortCount;
}

/// Cuts what does not lead to a slave that hangs at nobody.
void cut_circles(std::vector<WiredSlave>& slaves) {
  enum class Seen : std::uint8_t { kNo, kNow, kDone };
  std::vector<Seen> seen(slaves.size(), Seen::kNo);
  std::vector<std::size_t> way;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    way.clear();
    auto at = i;
    while (seen[at] == Seen::kNo) {
      seen[at] = Seen::kNow;
      way.push_back(at);
      auto& previous = slaves[at].previous;
      if (previous && (!is_there(*previous, slaves.size()) || seen[previous->position] == Seen::kNow)) previous.reset();
      if (previous) at = previous->position;
    }
    for (const auto one : way) seen[one] = Seen::kDone;
  }
}

}  // namespace

WiringTree::WiringTree(std::vector<WiredSlave> slaves) : slaves_(std::move(slaves)), behind_(slaves_.size()) {
  cut_circles(slaves_);
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    if (const auto& previous = slaves_[i].previous) behind_[previous->position].push_back(i);
  }
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    std::ranges::stable_sort(
        behind_[i], {}, [&](std::size_t one) { return steps_from(slaves_[i].entry, slaves_[one].previous->port); });
  }
}

WiringTree WiringTree::of(const std::vector<SlaveSettings>& slaves) {
  std::vector<std::optional<PreviousPort>> previous;
  for (const auto& slave : slaves) previous.push_back(slave.previous);
  const auto entries = entry_ports(previous);
  std::vector<WiredSlave> wired;
  for (std::size_t i = 0; i < slaves.size(); ++i)
    wired.push_back({&slaves[i].device, previous[i], entries[i].value_or(std::uint8_t{0})});
  return WiringTree(std::move(wired));
}

std::optional<std::size_t> WiringTree::previous(std::size_t slave) const {
  const auto& previous = slaves_[slave].previous;
  return previous ? std::optional<std::size_t>(previous->position) : std::nullopt;
}

std::optional<std::size_t> WiringTree::at_port(std::size_t slave, std::uint8_t port) const {
  const auto found =
      std::ranges::find_if(behind_[slave], [&](std::size_t one) { return slaves_[one].previous->port == port; });
  return found == behind_[slave].end() ? std::nullopt : std::optional(*found);
}

PortKind WiringTree::entry_kind(std::size_t slave) const {
  return port_kind(*slaves_[slave].device, slaves_[slave].entry);
}

std::optional<std::size_t> WiringTree::next(std::size_t slave) const {
  const auto kind = entry_kind(slave);
  std::optional<std::size_t> only;
  for (const auto one : behind_[slave]) {
    const auto port = slaves_[one].previous->port;
    if (kind == PortKind::kUnknown) {
      if (port == 1) return one;  // nothing is known but that slaves stand behind each other by port B
    } else if (port_kind(*slaves_[slave].device, port) == kind) {
      if (only) return std::nullopt;  // a junction
      only = one;
    }
  }
  return only;
}

std::optional<std::size_t> WiringTree::branches_from(std::size_t slave) const {
  for (auto at = slave; slaves_[at].previous; at = slaves_[at].previous->position) {
    const std::size_t before = slaves_[at].previous->position;
    if (next(before) != at) return before;
  }
  return std::nullopt;
}

void WiringTree::collect(std::size_t slave, std::vector<std::size_t>& into) const {
  std::vector<std::size_t> open{slave};
  while (!open.empty()) {
    const auto at = open.back();
    open.pop_back();
    into.push_back(at);
    open.insert(open.end(), behind_[at].begin(), behind_[at].end());
  }
}

std::vector<std::size_t> WiringTree::group(std::size_t slave) const {
  std::vector<std::size_t> all{slave};
  const auto on = next(slave);
  for (const auto one : behind_[slave]) {
    if (one != on) collect(one, all);
  }
  std::ranges::sort(all);
  return all;
}

bool WiringTree::is_free(std::size_t slave, std::uint8_t port) const {
  if (port_kind(*slaves_[slave].device, port) == PortKind::kNone || at_port(slave, port)) return false;
  return port != slaves_[slave].entry;
}

std::optional<std::uint8_t> WiringTree::way_on(std::size_t slave) const {
  if (const auto on = next(slave)) return slaves_[*on].previous->port;
  for (const std::uint8_t port : {1, 2, 3, 0}) {
    if (is_free(slave, port) && port_kind(*slaves_[slave].device, port) == entry_kind(slave)) return port;
  }
  return std::nullopt;
}

std::vector<std::size_t> WiringTree::frame_order(std::optional<std::size_t> at_master) const {
  struct Step {
    std::size_t slave;
    bool itself;
  };
  std::vector<std::size_t> order;
  std::vector<Step> open;
  for (std::size_t i = slaves_.size(); i-- > 0;) {
    if (!slaves_[i].previous && i != at_master) open.push_back({i, false});
  }
  if (at_master) open.push_back({*at_master, false});
  while (!open.empty()) {
    const auto [slave, itself] = open.back();
    open.pop_back();
    if (itself) {
      order.push_back(slave);
      continue;
    }
    // A slave that is entered by another port than A works when the frame has come back to A.
    const auto entry = slaves_[slave].entry;
    const auto own = entry == 0 ? std::size_t{0} : steps_from(entry, 0);
    bool placed = false;
    for (auto one = behind_[slave].rbegin(); one != behind_[slave].rend(); ++one) {
      if (!placed && steps_from(entry, slaves_[*one].previous->port) <= own) {
        open.push_back({slave, true});
        placed = true;
      }
      open.push_back({*one, false});
    }
    if (!placed) open.push_back({slave, true});
  }
  return order;
}

}  // namespace syncline
