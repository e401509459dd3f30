// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "channels/bus_scan.h"
#include "support/result.h"
#include "support/types.h"

namespace syncline {

enum class EventKind : std::uint8_t {
  kScanProgress,        // a = slaves done, b = slaves found
  kScanFinished,        // scan
  kOnline, kOffline,
  kStateChanged,        // slave (-1 master), a = old AlState, b = new AlState
  kAlStatusError,       // slave, a = AL status, b = AL status code
  kDcInitialised,       // a = number of DC slaves, b = position of the reference clock
  kReferenceClock,      // slave, a = 1 present, 0 lost, 2 took over from the one that was lost, 3 has no system time: the
                        // next one leads in its place
  kDcSlaveSync,         // a = 1 in sync (of a slave: it was away and is again), 0 out of sync, 2 nothing is monitored;
                        // 3 unknown; b = deviation ns (3: age of the oldest reading, ns, 0 when nobody follows); slave = culprit when out, whose
                        // own reading is over the limit, c = number of those; without a culprit they are all
                        // that follow, and over it to the same side: the reference clock has moved
  kDcmSync,             // a = 1 in sync, 0 out of sync, b = error ns (size of the step, when a clock has
                        // stepped), c = dc::SyncObstacle when out
  kDcmError,            // a = DCM error code, b = drift in ppm
  kWkcError,            // a = expected, b = received; repeated ones are counted, c = count
  kFramesLost,          // a = count; each lost frame is in one of these, see MissingFrames
  kFramesLate,          // a = count that came back after its deadline, b = by how much at most, ns; c = those of them that
                        // a kFramesLost had counted before
  kOverrun,             // a = cycles left out, b = longest time without a frame, ns
  kSlaveLost, kSlaveFound,                // its state is unknown from then on, until the kStateChanged that follows
  kEmergency,           // slave, a = error code, b = error register, c = the 5 bytes of data, the first one lowest;
                        // text = the vendor's name of the alarm, where it is known
  kRealTime,            // text: what of SCHED_FIFO, mlock was refused (once)
  kRestarted,           // c: reserved
  kError,               // error
  kEventsLost,          // a = count: the queue was full
  kScanTouchesRunning,  // a = slaves beyond INIT, b = EEPROMs that are taken from their PDIs to be read
  kCable,               // slave and its port a lead to slave b; c = 0 nothing comes back from there, 1 healed
  kWkcExpected,         // a = by the configuration, b = now, without slaves that are lost or below SAFEOP
  kRecovery,            // slave, a = 0 begun, 1 done, 2 failed, 3 given up; b = number of this try
  kUnknownSlave,        // slave = position on the bus, text = identity: it is none of the configuration's
  kHotConnect,          // slave of a group, a = 1 connected, 0 disconnected, 2 not there at the start; text = the group
  kDiagnosis,           // slave: new in its history 0x10F3; a = diag code, b = type (0 info, 1 warning, 2 error) and
                        // text ID in bits 31..16, c = time stamp in ns (DC system time, or since power-on; 0 none)
  kDelayFinding,        // slave, a = dc::DelayWarning, b = its value: what the delay measurement stumbled over
  kPortErrors,          // slave, a = port, b = frames damaged on their way into it, c = links lost, since it was read last
  kWatchdog,            // slave, a = 0 process data, 1 PDI (its firmware is silent); b = how often since it was read last
  kDelaysMeasured,      // while the bus runs: a = slaves whose delay is being corrected, b = largest change in ns
  kLink,                // the master's own adapter, text = link: a = 0 down or gone, 1 up again, b = for how long it was away, ns;
                        // 2 what it ended of a bring-up begins again
  kFirmwareSlow,        // slave, a = 1 begun, 0 over; b of c cycles in which it had renewed no inputs, as it did in every
                        // cycle before; c = 0: b cycles that took longer than the cycle time, by its own counter
};

struct Event {
  EventKind kind = EventKind::kError;
  Nanoseconds time = 0;                   // host clock
  int slave = -1;
  std::int64_t a = 0, b = 0, c = 0;
  std::string text;
  std::optional<Error> error;
  std::shared_ptr<const BusScan> scan;    // kScanFinished
};

}  // namespace syncline
