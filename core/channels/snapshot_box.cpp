// SPDX-License-Identifier: Apache-2.0
#include "channels/snapshot_box.h"

namespace syncline {

void SnapshotBox::publish(const Snapshot& snapshot) {
  slots_[back_] = snapshot;
  const auto mine = static_cast<std::uint8_t>(back_ | kFresh);
  back_ = middle_.exchange(mine, std::memory_order_acq_rel) & kSlot;
}

void SnapshotBox::publish_first(const Snapshot& snapshot) {
  slaves_.store(snapshot.slaves.size(), std::memory_order_relaxed);
  publish(snapshot);
  publish(snapshot);  // into the slot that lay between
}

bool SnapshotBox::read(Snapshot& out) {
  if (taken()) return false;
  slots_[front_].slaves.reserve(slaves_.load(std::memory_order_relaxed));
  front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kSlot;
  out = slots_[front_];
  return true;
}

}  // namespace syncline
