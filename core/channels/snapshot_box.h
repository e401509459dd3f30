// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "channels/latest_box.h"
#include "channels/snapshot.h"

namespace syncline {

[[nodiscard]] inline std::size_t room_of(const Snapshot& snapshot) { return snapshot.slaves.size(); }
inline void make_room(Snapshot& snapshot, std::size_t slaves) { snapshot.slaves.reserve(slaves); }

using SnapshotBox = LatestBox<Snapshot>;

}  // namespace syncline
