// SPDX-License-Identifier: Apache-2.0
#include "findings/place.h"

namespace syncline {

int ConfigPlace::slave() const {
  switch (kind) {
    case PlaceKind::kSlave:
    case PlaceKind::kSlaveInitCmd:
    case PlaceKind::kSyncManager:
    case PlaceKind::kPdo:
    case PlaceKind::kMailbox:
    case PlaceKind::kCoeCmd:
    case PlaceKind::kHotConnect:
    case PlaceKind::kDc:
      return static_cast<int>(first);
    default:
      return -1;
  }
}

}  // namespace syncline
