// SPDX-License-Identifier: Apache-2.0
#include "sim/segment/address_table.h"

#include <algorithm>

namespace syncline::sim {

void AddressTable::begin(std::uint64_t changes) {
  for (const auto& slave : slaves_) {
    for (const auto station : {slave.address.station, slave.address.alias}) {
      if (station < places_.size()) places_[station] = kNobody;
    }
  }
  slaves_.clear();
  watchful_.clear();
  shared_ = false;
  changes_ = changes;
  event_changes_ = 0;
}

void AddressTable::add(Esc& esc) {
  const auto slave = static_cast<std::uint16_t>(slaves_.size());
  const auto address = esc.address();
  slaves_.push_back({&esc, address});
  if (!esc.is_indifferent()) watchful_.push_back(slave);
  place(address.station, slave);
  if (address.alias != address.station) place(address.alias, slave);
}

void AddressTable::place(std::uint32_t station, std::uint16_t slave) {
  if (station >= places_.size()) return;
  shared_ = shared_ || places_[station] != kNobody;
  places_[station] = slave;
}

void AddressTable::find_watching(std::uint64_t event_changes) {
  event_changes_ = event_changes;
  watching_.clear();
  for (const auto slave : watchful_) {
    if (slaves_[slave].esc->looks_at_all_frames()) watching_.push_back(slave);
  }
}

const std::vector<std::uint16_t>& AddressTable::called_by(const PassingFrame& frame, std::uint64_t event_changes) {
  called_.clear();
  if (frame.is_for_single_slaves()) {
    if (event_changes_ != event_changes) find_watching(event_changes);
    called_ = watching_;
  }
  if (shared_) {
    for (std::size_t i = 0; i < slaves_.size(); ++i) {
      const auto& address = slaves_[i].address;
      if (frame.is_for(address.station, address.alias)) called_.push_back(static_cast<std::uint16_t>(i));
    }
  } else {
    for (const auto station : frame.stations()) {
      if (places_[station] != kNobody) called_.push_back(places_[station]);
    }
  }
  std::ranges::sort(called_);
  called_.erase(std::unique(called_.begin(), called_.end()), called_.end());
  return called_;
}

}  // namespace syncline::sim
