// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <atomic>

#include "master/exchange/bus.h"
#include "master/exchange/frame_exchange.h"
#include "tests/support/simulated_segment.h"

namespace syncline::test {

/// Three simulated terminals and what asks them, without cycles.
class TerminalsBed : public ::testing::Test {
 protected:
  VirtualClock clock;
  SimulatedSegment link{clock, terminals(3)};
  FrameExchange exchange{link, clock};
  std::atomic<bool> cancel{false};
  Bus bus{exchange, clock, &cancel};
};

}  // namespace syncline::test
