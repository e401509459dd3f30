// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "findings/finding.h"
#include "reasons/reason.h"

namespace syncline {
struct SlaveConfig;
}  // namespace syncline

namespace syncline::families {

struct Family;

/// What of a slave's configuration its family refuses or does not bear.
struct Problem {
  enum class Topic : std::uint8_t {
    kCycleRefused,   // the SYNC0 cycle is none that the device takes
    kCyclePartly,    // it is taken, and something is lost
    kObjects,        // more objects a direction than the device maps
    kErrorLimit,     // 0x10F1:02 beyond its range
    kErrorLimitOff,  // 0x10F1:02 = 0
    kModeNeedsDc,    // 0x6060 is set to a mode that needs SYNC0, and there is none
    kSyncType,       // 0x1C32:01 or 0x1C33:01 does not go with the device or with the SYNC signals
    kCanCycle,       // of a gateway: no multiple of the bus cycle, or the gateway is not told it
  };
  Topic topic{};
  bool refused = false;                      // the slave does not come to OP; otherwise it runs and does something else
  bool outputs = false;                      // kObjects, kSyncType: of which direction
  std::optional<std::size_t> coe_command{};  // index in SlaveConfig::mailbox->coe_commands, where one is the cause
  Finding finding{};                         // of the codes ENI-DEV; its place is the finder's matter
};

/// Pure. `bus_cycle`: of the frame with the slave's process data, ns. Without a family (null) only modes are judged
/// that no CiA 402 drive executes well without SYNC0.
[[nodiscard]] std::vector<Problem> problems(const Family* family, const SlaveConfig& slave, Nanoseconds bus_cycle);

/// Whether a SYNC0 cycle (ns) suits the device.
struct CycleJudgement {
  bool refused = false;
  Reason reason;  // empty: it does
};
[[nodiscard]] CycleJudgement judge_cycle(const Family& family, Nanoseconds sync0_cycle);

/// "250 us", "62.5 us"
[[nodiscard]] std::string microseconds(Nanoseconds time);

}  // namespace syncline::families
