// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>

#include "channels/snapshot.h"

namespace syncline {

/// Latest value, lossy: the writer never waits for the reader (it skips publishing when the reader
/// holds the slot). Vectors keep their capacity, so publishing does not allocate.
class SnapshotBox {
 public:
  void publish(const Snapshot& snapshot);  // cyclic thread
  /// Waits for a reader: for what must not be missed (online, offline), outside the cycle.
  void publish_surely(const Snapshot& snapshot);
  /// Copies the latest snapshot; false when nothing new came since the last call.
  bool read(Snapshot& out);
  /// The last one has been read: somebody is waiting for the next. Cyclic thread.
  [[nodiscard]] bool taken() const { return !fresh_.load(std::memory_order_relaxed); }

 private:
  std::mutex mutex_;  // the writer only try_locks
  Snapshot latest_;
  std::atomic<bool> fresh_{false};  // written with the mutex held
};

}  // namespace syncline
