// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// What a scan tells.
namespace syncline::events {

struct ScanProgress {
  std::size_t done = 0;   // slaves read
  std::size_t found = 0;  // slaves on the bus
};

/// The bus that is scanned belongs to a machine that runs.
struct ScanTouchesRunning {
  std::size_t running = 0;  // slaves beyond INIT
  std::size_t eeproms = 0;  // taken from their PDIs to be read
};

}  // namespace syncline::events
