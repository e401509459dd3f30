// SPDX-License-Identifier: Apache-2.0
#include "check/rule_tables.h"

namespace syncline::checker {
namespace {

using enum CheckSeverity;

constexpr CheckRule kDeviceRules[] = {
    {"ENI-DEV-01", kError, "A SYNC0 cycle that the device does not take",
     "The slave refuses SAFEOP (AL status code 0x0035, 0x0036 or 0x002E)",
     "Choose a cycle that all devices take (synclinectl project cycle-times)"},
    {"ENI-DEV-02", kWarning, "A SYNC0 cycle that the device takes with losses",
     "The slave comes to OP, and a part of it is not synchronised", "Choose a multiple of its full step"},
    {"ENI-DEV-03", kError, "More objects are mapped than the device takes",
     "The slave refuses the assignment or the mapping", "Map fewer objects and exchange the slow ones by SDO"},
    {"ENI-DEV-04", kError, "An error limit beyond the device's range",
     "The slave refuses the download to 0x10F1:02, which ends the start-up", "Write a value within the range"},
    {"ENI-DEV-05", kNote, "The device's reaction to missed SM events is switched off",
     "The slave goes on with old outputs, however many are missed",
     "Watch the counter in 0x1C32, or set a limit in 0x10F1:02"},
    {"ENI-DEV-06", kWarning, "A cyclic synchronous mode without SYNC0",
     "The drive does not execute the mode, or moves badly", "Switch SYNC0 on, or start in a profile mode (0x6060)"},
    {"ENI-DEV-07", kError, "A synchronisation type that the device does not take",
     "The slave refuses the download to 0x1C32:01 or 0x1C33:01, or SAFEOP",
     "Remove the command, or write a type that it supports"},
    {"ENI-DEV-08", kWarning, "A synchronisation type that does not use the SYNC signals",
     "SYNC0 comes, and the slave works without it", "Write 2 to 0x1C32:01 and 0x1C33:01, or switch SYNC0 off"},
    {"ENI-DEV-09", kError, "A CAN cycle that does not fit the bus cycle",
     "The gateway refuses SAFEOP (AL status code 0x0026 or 0x0035)", "Make the CAN cycle a multiple of the bus cycle"},
    {"ENI-DEV-10", kWarning, "A gateway that does not know the bus cycle",
     "It starts its CAN cycles with other frames than meant", "Write the bus cycle to 0x1C32:02 on PS"},
};

}  // namespace

std::span<const CheckRule> device_rules() { return kDeviceRules; }

}  // namespace syncline::checker
