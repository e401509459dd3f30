// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline::dc {

/// What the measurement of the propagation delays stumbled over.
enum class DelayWarning : std::uint8_t {
  kReversedCable,  // value: the port by which the slave is connected
  kNegativeHop,
  kImplausibleHop,
  kNotIncreasing,
  kUnexplainedPort,  // value: a port with a link behind which no slave is: a ring that is closed, another master
  kUntimedPort,      // value: a port whose receive time contradicts all others
  kUnmeasuredWay,    // value: its delay as it is taken, ns; the slave at which its branch parts has no receive times
};

}  // namespace syncline::dc
