// SPDX-License-Identifier: Apache-2.0
#include "config/wiring_draft.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "config/device_description.h"
#include "config/slave_settings.h"

namespace syncline {
namespace {

/// Place in the branch of `target` that begins at `port`: the port itself, or the end of what hangs there.
std::optional<PreviousPort> end_of_branch(const WiringTree& tree, std::size_t target, std::uint8_t port) {
  auto last = tree.at_port(target, port);
  if (!last) return PreviousPort{static_cast<std::uint16_t>(target), port};
  while (const auto on = tree.next(*last)) last = on;
  const auto way_on = tree.way_on(*last);
  return way_on ? std::optional(PreviousPort{static_cast<std::uint16_t>(*last), *way_on}) : std::nullopt;
}

/// A port of this very slave for a device that is entered by `kind`.
std::optional<PreviousPort> port_at(const WiringTree& tree, std::size_t target, PortKind kind) {
  const auto& device = *tree.slaves()[target].device;
  const auto on = tree.way_on(target);
  if (on && ports_fit(port_kind(device, *on), kind)) return PreviousPort{static_cast<std::uint16_t>(target), *on};
  for (const std::uint8_t port : {1, 2, 3, 0}) {
    const bool own = port == tree.slaves()[target].entry || port_kind(device, port) == tree.entry_kind(target);
    if (own || !ports_fit(port_kind(device, port), kind)) continue;
    if (const auto place = end_of_branch(tree, target, port)) return place;
  }
  return std::nullopt;
}

}  // namespace

WiringDraft::WiringDraft(const std::vector<SlaveSettings>& slaves)
    : slaves_(WiringTree::of(slaves).slaves()), gone_(slaves.size(), false), listed_(slaves.size()) {
  std::iota(listed_.begin(), listed_.end(), std::size_t{0});
  in_order_ = tree().frame_order() == listed_;
  const auto first = std::ranges::find_if(slaves_, [](const WiredSlave& one) { return !one.previous; });
  if (first != slaves_.end()) at_master_ = static_cast<std::size_t>(first - slaves_.begin());
}

void WiringDraft::insert(std::size_t slave, std::size_t before) {
  const auto place = std::ranges::find(listed_, before);
  listed_.insert(place, slave);
}

std::size_t WiringDraft::add(const DeviceDescription& device, std::uint8_t entry, std::size_t before) {
  slaves_.push_back({&device, std::nullopt, entry});
  gone_.push_back(false);
  insert(slaves_.size() - 1, before);
  return slaves_.size() - 1;
}

std::size_t WiringDraft::add_copies(std::span<const std::size_t> group, std::size_t before) {
  const auto first = slaves_.size();
  std::map<std::size_t, std::size_t> copy_of;
  for (const auto one : group) {
    const auto original = slaves_[one];
    copy_of[one] = add(*original.device, original.entry, before);
  }
  std::size_t head = first;
  for (const auto one : group) {
    const auto& previous = slaves_[one].previous;
    const auto at = previous ? copy_of.find(previous->position) : copy_of.end();
    if (at == copy_of.end()) {
      head = copy_of[one];
    } else {
      slaves_[copy_of[one]].previous = PreviousPort{static_cast<std::uint16_t>(at->second), previous->port};
    }
  }
  return head;
}

void WiringDraft::detach(std::size_t slave) {
  const auto next = tree().next(slave);
  if (next) slaves_[*next].previous = slaves_[slave].previous;
  slaves_[slave].previous.reset();
  if (at_master_ == slave) at_master_ = next;
}

void WiringDraft::hang(std::size_t slave, PreviousPort at) {
  slaves_[slave].previous = at;
  if (at_master_ == slave) at_master_.reset();
}

void WiringDraft::drop(std::span<const std::size_t> group) {
  for (const auto one : group) gone_[one] = true;
}

std::optional<WiringObstacle> WiringDraft::attach(std::size_t slave, PreviousPort at) {
  return plug(slave, at, tree().at_port(at.position, at.port));
}

std::optional<WiringObstacle> WiringDraft::attach_before(std::size_t slave, std::size_t displaced) {
  return plug(slave, slaves_[displaced].previous, displaced);
}

std::optional<WiringObstacle> WiringDraft::attach_first(std::size_t slave) { return plug(slave, {}, at_master_); }

std::optional<WiringObstacle> WiringDraft::plug(std::size_t slave, std::optional<PreviousPort> at,
                                                std::optional<std::size_t> displaced) {
  const auto now = tree();
  if (at) {
    const auto kind = port_kind(*slaves_[at->position].device, at->port);
    if (!ports_fit(kind, now.entry_kind(slave))) return WiringObstacle::kOtherKind;
  }
  if (displaced) {
    const auto way_on = now.way_on(slave);
    if (!way_on) return WiringObstacle::kNoWayOn;
    if (!ports_fit(port_kind(*slaves_[slave].device, *way_on), now.entry_kind(*displaced)))
      return WiringObstacle::kOtherKind;
    slaves_[*displaced].previous = PreviousPort{static_cast<std::uint16_t>(slave), *way_on};
  }
  slaves_[slave].previous = at;
  const bool first = !at && displaced == at_master_;
  if (first) at_master_ = slave;
  if (in_order_) return std::nullopt;
  // The order is not what the wiring says: the slave stands behind the one that it hangs at.
  std::erase(listed_, slave);
  const auto place = at      ? std::ranges::find(listed_, std::size_t{at->position}) + 1
                     : first ? listed_.begin()
                             : std::ranges::find(listed_, *displaced);
  listed_.insert(place, slave);
  return std::nullopt;
}

std::optional<PreviousPort> WiringDraft::place_behind(std::size_t target, std::size_t slave) const {
  const auto now = tree();
  const auto kind = now.entry_kind(slave);
  const bool can_go_on = now.way_on(slave).has_value();
  // Of a device that does not say what its ports are, a port may look right that what is there does not let in.
  const auto takes = [&](const PreviousPort& place) {
    auto tried = *this;
    return !tried.attach(slave, place);
  };
  for (std::optional<std::size_t> at = target; at; at = now.previous(*at)) {
    const auto place = port_at(now, *at, kind);
    if (!place) continue;
    auto last = now.at_port(place->position, place->port);
    // A device that ends a line goes to the end of the line.
    if ((can_go_on || !last) && takes(*place)) return place;
    if (!last) continue;
    while (const auto on = now.next(*last)) last = on;
    const auto way_on = now.way_on(*last);
    if (!way_on) continue;
    const PreviousPort end{static_cast<std::uint16_t>(*last), *way_on};
    if (takes(end)) return end;
  }
  return std::nullopt;
}

std::optional<PreviousPort> WiringDraft::place_of_copy(std::size_t slave) const {
  const auto now = tree();
  for (std::optional<std::size_t> at = slave; at; at = now.previous(*at)) {
    if (const auto place = port_at(now, *at, now.entry_kind(slave))) return place;
  }
  return std::nullopt;
}

std::vector<std::size_t> WiringDraft::order() const {
  auto order = in_order_ ? tree().frame_order(at_master_) : listed_;
  std::erase_if(order, [&](std::size_t one) { return gone_[one]; });
  return order;
}

}  // namespace syncline
