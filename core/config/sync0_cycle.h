// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline {
struct DcOpMode;
struct DcSlaveSettings;
struct DcTime;
struct SlaveSettings;
}  // namespace syncline

namespace syncline::compiler {

/// Numbers of the ENI element DC and of the registers behind it, ns.
struct DcTimes {
  Nanoseconds cycle_time0 = 0;  // 0x09A0
  Nanoseconds cycle_time1 = 0;  // 0x09A4: from SYNC0 to SYNC1; negative values cannot be set
  Nanoseconds shift_time = 0;   // of SYNC0, added to the start time 0x0990
  bool exact = true;            // false when a division of the bus cycle left a remainder
};

/// The op mode of a slave, nullptr when DC is off or the name is unknown.
[[nodiscard]] const DcOpMode* selected_op_mode(const SlaveSettings& slave);

/// ETG.2000 Dc/OpMode with the user's settings, at a bus cycle of `bus_cycle`:
/// - SYNC0 cycle: value; else factor > 0 multiplies, factor < 0 divides the bus cycle; else 0.
/// - SYNC0 shift: value + factor term of the bus cycle.
/// - SYNC1 cycle: value; else factor > 0 multiplies the SYNC0 cycle, factor < 0 multiplies (!) the bus cycle.
/// - CycleTime1 = SYNC1 cycle - SYNC0 cycle + SYNC1 shift, 0 when AssignActivate does not switch SYNC1 on. A mode that
///   switches SYNC1 on without a cycle means the cycle of SYNC0.
/// The user's factor (both units: > 0 multiplies, < 0 divides the bus cycle), cycle and shift replace the ESI's.
/// `input_shift`: of the master, added to the SYNC0 shift of a slave that is based on the input reference.
[[nodiscard]] DcTimes dc_times(const DcOpMode& mode, const DcSlaveSettings& user, Nanoseconds bus_cycle,
                               Nanoseconds input_shift = 0);

/// The user's choice, else ESI ShiftTimeSync0@Input.
[[nodiscard]] bool is_input_based(const DcOpMode& mode, const DcSlaveSettings& user);

/// Sync Unit Cycle factor: above 0 multiplies, below 0 divides the bus cycle, 0 gives 0.
[[nodiscard]] Nanoseconds scaled_cycle(Nanoseconds bus_cycle, std::int64_t factor);

/// Cycle of SYNC0 (unit 0) or SYNC1 with the user's choice for it and without its shift.
[[nodiscard]] Nanoseconds sync_cycle(const DcOpMode& mode, const DcSlaveSettings& user, int unit,
                                     Nanoseconds bus_cycle);

/// Shift that an operation mode gives a SYNC unit while the user gives none.
[[nodiscard]] Nanoseconds shift_of_mode(const DcTime& shift, Nanoseconds bus_cycle);

}  // namespace syncline::compiler
