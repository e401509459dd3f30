// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// What the master does about slaves that go missing or fall into an error state while the bus runs.
struct RecoverySettings {
  /// Slaves that come back (cable healed, power back) are set up again and led to the state of the bus.
  bool automatic = true;
  /// How often an error state is acknowledged and the state requested again; 0 leaves it to the user.
  std::uint32_t error_tries = 0;  // 0..1000
  /// Goes online with the slaves that are there; the others join when they appear.
  bool start_incomplete = false;
  bool operator==(const RecoverySettings&) const = default;
};

}  // namespace syncline
