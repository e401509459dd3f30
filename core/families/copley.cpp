// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "families/device_family.h"
#include "families/family_tables.h"

namespace syncline::families {
namespace {

// Note: Copley Controls, "Synchronization", revision 1.4 of June 2012. ESI: Copley_XE2_4.60.xml.
constexpr std::array kStatusBits{
    StatusBit{0, true, "The master has set SYNC0 to a period that the drive takes",
              "SYNC0 is off or has a period that the drive does not take"},
    StatusBit{1, true, "The servo period is synchronised to SYNC0", "The servo period is not synchronised to SYNC0"},
    StatusBit{2, true, "The SYNC0 period is a multiple of 250 us",
              "The SYNC0 period is no multiple of 250 us: only the current loop can follow it"},
    StatusBit{3, false, "The start time of SYNC0 was in the past when it was set", ""},
};

constexpr std::array kPinFunctions{
    PinFunction{0, "nothing", "nothing"},
    PinFunction{11, "sync0", "SYNC0"},
    PinFunction{12, "frames", "frames that are received"},
    PinFunction{0x200, "servo-period", "the start of the servo period"},
};

constexpr std::array<std::uint16_t, 2> kCopleySyncTypes{0, 2};

constexpr std::array kCopleyModes{
    ModeNeedsDc{8, false,
                "Cyclic synchronous position mode without SYNC0 gets its targets at no fixed distance from the "
                "servo period, and moves badly"},
    ModeNeedsDc{9, false,
                "Cyclic synchronous velocity mode without SYNC0 gets its targets at no fixed distance from the "
                "servo period, and moves badly"},
    ModeNeedsDc{10, false,
                "Cyclic synchronous torque mode without SYNC0 gets its targets at no fixed distance from the "
                "servo period, and moves badly"},
};

constexpr Family copley() {
  Family family;
  family.id = "copley";
  family.name = "Copley Controls";
  family.devices = "drives";
  family.match = {0x00AB, 0, 0xFFFF'FFFF, {}};
  family.behaviour = "drive-c";
  family.counters = SyncCounters{0x0B, 0x0C, 0x0D, false, "ESI of Copley XE2, 0x1C32"};
  family.cycle =
      CycleLimits{62'500, 250 * kMicrosecond, "only the current loop is synchronised then, the position loop is not",
                  62'500, 10 * kMillisecond,  "Copley Synchronization 1.4, SYNC0 pulse"};
  // The ESI has the object without its default; 4 is what the generic slave stack has.
  family.error_limit =
      ErrorLimit{4, 0xFFFF, 0x0034, 0, "ESI of Copley XE2, 0x10F1; default of the generic slave stack"};
  family.status = StatusObject{
      {0x21B4, 0}, "Network status register", kStatusBits, "Copley Synchronization 1.4, Debugging synchronization"};
  family.pins = PinObject{0x2193, 7, 10, kPinFunctions,
                          "Copley Synchronization 1.4, Debugging synchronization; ESI of Copley XE2, 0x2193"};
  // The note has 0 as default, the ESI 2.
  family.sync_types.outputs = family.sync_types.inputs = kCopleySyncTypes;
  family.sync_types.usual_outputs = family.sync_types.usual_inputs = 2;
  family.sync_types.writable = true;
  family.sync_types.source =
      "ESI of Copley XE2, 0x1C32 and 0x1C33; Copley Synchronization 1.4, Sync manager configuration";
  family.modes_need_dc = {kCopleyModes, "Copley Synchronization 1.4, Running without synchronization"};
  return family;
}

constexpr std::array kCopleyFamilies{copley()};

}  // namespace

std::span<const Family> copley_families() { return kCopleyFamilies; }

}  // namespace syncline::families
