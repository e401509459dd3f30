// SPDX-License-Identifier: Apache-2.0
#include "channels/snapshot_box.h"

namespace syncline {

void SnapshotBox::publish(const Snapshot& snapshot) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;
  latest_ = snapshot;
  fresh_ = true;
}

void SnapshotBox::publish_surely(const Snapshot& snapshot) {
  const std::scoped_lock lock(mutex_);
  latest_ = snapshot;
  fresh_ = true;
}

bool SnapshotBox::read(Snapshot& out) {
  const std::scoped_lock lock(mutex_);
  if (!fresh_) return false;
  out = latest_;
  fresh_ = false;
  return true;
}

}  // namespace syncline
