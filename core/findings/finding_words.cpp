// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "findings/finding.h"

namespace syncline {
namespace {

struct Row {
  FindingCode code;
  std::string_view name;
  FindingWords words;
};

using Code = FindingCode;

constexpr std::array<Row, kFindingCodes> kRows{{
    {Code::kSlaveAbsent,
     "slave-absent",
     {"No answer from {slaves} since {since}; {near} is the last that answers.",
      "Check the power of the first one and the cable that leads to it."}},
    {Code::kSlaveAbsentBehindCable,
     "slave-absent-behind-cable",
     {"No answer from {slaves} since {since}: nothing comes back over the cable at {near} port {port}.",
      "Check the power of the first one, and the cable and plugs between the two."}},
    {Code::kSlaveWasAbsent,
     "slave-was-absent",
     {"No answer from {slaves} from {since} on, for {length} ({count} in all).",
      "A loose plug or a weak supply; the lost links of the ports say which cable."}},
    {Code::kAdapterAway,
     "adapter-away",
     {"The network adapter {adapter} is down, gone or without carrier since {since}.",
      "Check the plug at the host, and that the adapter is switched on (ip link set ... up); the bus comes back with "
      "it."}},
    {Code::kAdapterWasAway,
     "adapter-was-away",
     {"The network adapter {adapter} was down, gone or without carrier from {since} on, for {length} ({count} in all); "
      "the "
      "bus came back with it.",
      "A loose plug at the host, or somebody who switches the adapter off: a network manager, power saving, the reset "
      "of a "
      "USB adapter."}},
    {Code::kSlaveFell,
     "slave-fell",
     {"{slave} is in {state} with AL status code {alcode}{alarm}, since {since}.", "Check {check}."}},
    {Code::kSlaveFellByMisses,
     "slave-fell-by-missed-events",
     {"{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed {missed} SM2 events, its "
      "error "
      "counter reached {integrator} of {limit}.",
      "The cause is that of the missed events: {cause}."}},
    {Code::kSlaveFellByLateFrames,
     "slave-fell-by-late-frames",
     {"{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed {missed} SM2 events, {part} "
      "of "
      "them because frames came behind the SYNC0 they were meant for. Nominally they are there {margin} before it, but "
      "one in a thousand is {lateness} late.",
      "Increase the set value by {more} or more, or make the host less late."}},
    {Code::kSlaveFellByItself,
     "slave-fell-by-itself",
     {"{slave} fell to {state} with AL status code {alcode}{alarm} at {since}, and the master saw nothing but good "
      "cycles before: no "
      "frame lost or late, none left out, outputs nominally there {margin} before each SYNC0.",
      "So the cause is in the slave: its application needed longer than the cycle, or than the time between its "
      "outputs and SYNC0. "
      "Give it a longer cycle or more time before SYNC0, or look for what slows its firmware."}},
    {Code::kSlaveBehind,
     "slave-behind",
     {"{slave} stays in {state} while others went further.", "Request the state again and watch its AL status."}},
    {Code::kNotMonitored,
     "not-monitored",
     {"The slaves' deviation is not monitored.", "Switch sync-window monitoring on to prove that they are in sync."}},
    {Code::kNothingToMonitor,
     "nothing-to-monitor",
     {"No slave follows the reference clock ({clocks} with a system time behind it), so there is no deviation to "
      "watch.",
      ""}},
    {Code::kSlavesOutOfSync,
     "slaves-out-of-sync",
     {"The slaves are not in sync within {limit} since {since}.", "Look at the deviations of the single slaves."}},
    {Code::kSlaveLeftWindow,
     "slave-out-of-sync",
     {"The slaves are not in sync: {slave} is {deviation} off its reference clock, the limit is {limit}.",
      "A clock that stepped, was not initialised or cannot follow; its loop values and its propagation delay stand in "
      "its "
      "distributed clocks."}},
    {Code::kWindowLeft,
     "sync-window-left",
     {"{slave} left the sync window at {since} ({deviation}, limit {limit}) and came back; {count} in all.",
      "A clock that steps, or a reference clock that was exchanged; see the events of that moment."}},
    {Code::kSlaveClockOff,
     "slave-clock-off",
     {"{slave} was {deviation} off its reference clock at {since}, and nobody monitors it.",
      "Its clock stepped or lost its reference; switch sync-window monitoring on to be told at once."}},
    {Code::kMasterNotLocked,
     "master-not-locked",
     {"The master is not in sync with the reference clock (schedule error {error}){obstacle}.",
      "Look for a busy host or a clock that stepped; if neither is there, choose the other shift mode."}},
    {Code::kMasterLostLock,
     "master-lost-lock",
     {"The master was out of sync with the reference clock {count}, first at {since}{obstacle}; it found back.",
      "See what else happened then: a clock that stepped, cycles left out, a reference clock that was lost."}},
    {Code::kDcmError, "dcm-error", {"The master synchronisation reports {code}: {meaning}", ""}},
    {Code::kDriftTooHigh,
     "drift-too-high",
     {"The host's clock and the reference clock drift by {drift}; no controller balances more than 600 ppm.",
      "Check the cycle time and the host's timer frequency."}},
    {Code::kMissedByLostFrames,
     "missed-by-lost-frames",
     {"{slave} missed {missed} SM2 events, {part} of them because frames were lost; its error counter reached "
      "{integrator} "
      "of {limit}.",
      "Find out where the frames are lost; its SYNC0 is not the reason."}},
    {Code::kMissedByHost,
     "missed-by-host",
     {"{slave} missed {missed} SM2 events, {part} of them because the host left cycles out; its error counter reached "
      "{integrator} of {limit}.",
      "Find out what held the host; its SYNC0 is not the reason."}},
    {Code::kMissedByLateFrames,
     "missed-by-late-frames",
     {"{slave} missed {missed} SM2 events, {part} of them because frames came behind the SYNC0 they were meant for: "
      "nominally "
      "they are there {margin} before it, but one in a thousand is {lateness} late.",
      "Increase the set value by {more} or more, or make the host less late."}},
    {Code::kMissedUnlocked,
     "missed-unlocked",
     {"{slave} missed {missed} SM2 events, and the master was not locked to the reference clock all the time: frames "
      "slid through its "
      "SYNC0.",
      "Mend the lock first."}},
    {Code::kMissedUnexplained,
     "missed-unexplained",
     {"{slave} counts {missed} missed SM2 events (0x1C32:{sub}), and for {part} of them the master saw good cycles.",
      "Its outputs come nominally {margin} before SYNC0, and it needs {need} for them; look at its firmware's load, or "
      "at "
      "frames that are damaged in front of it."}},
    {Code::kSync0TooTight,
     "sync0-too-tight",
     {"The frames reach {slave} nominally {margin} before its SYNC0, and one in a thousand is {lateness} late.",
      "Increase the set value by {more} or more."}},
    {Code::kShiftTooShort,
     "shift-too-short",
     {"{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), and used those of the "
      "cycle before: "
      "they come {margin} before SYNC0, and it needs {need}.",
      "Let its SYNC0 come {more} later: a shift of {shift}."}},
    {Code::kInputShiftTooShort,
     "input-shift-too-short",
     {"{slave} had its inputs too late {count} (0x1C33:0D shift too short).",
      "Latch them earlier: a smaller input shift time."}},
    {Code::kFirmwareHung,
     "firmware-hung",
     {"The firmware of {slave} was silent at {since}: its PDI watchdog expired {count} (0x0443).",
      "Its outputs and inputs stood still meanwhile. Look for what stops it: an interrupt storm, a debugger, a "
      "crash."}},
    {Code::kFirmwareSlow,
     "firmware-slow",
     {"{slave} needed longer than its cycle {count} ({object} cycle exceeded), last at {last}.",
      "Give it a longer cycle, or fewer objects and functions in each."}},
    {Code::kInputsLate,
     "inputs-late",
     {"{slave} does not renew its inputs in every cycle, as it did before: from {since} on, {count} (0x0805 + 8 n of "
      "its input "
      "SyncManager names the same buffer again).",
      "Its firmware takes longer than the cycle: look for what else it has to do, give it a longer cycle, or fewer "
      "objects."}},
    {Code::kGatewayCycleExceeded,
     "gateway-cycle-exceeded",
     {"{slave} skipped {count} cycles because the one before was not over ({object} cycle exceeded): its fieldbus "
      "needs longer "
      "than a cycle.",
      "Use a longer bus cycle or a larger sync multiplier, or let its fieldbus carry less."}},
    {Code::kMailboxSilent,
     "mailbox-silent",
     {"{slave} left {count} mailbox requests in a row without an answer.",
      "Its firmware is busy or stopped; the counters that it keeps in objects are as old as that."}},
    {Code::kOutputsWatchdog,
     "outputs-watchdog",
     {"The process data watchdog of {slave} expired {count} (0x0442), last at {last}.",
      "It had no outputs for longer than its watchdog time."}},
    {Code::kPortErrors,
     "port-errors",
     {"{count} frames reached {slave} damaged at port {port} (0x{register}), from {since} on; the cable comes from "
      "{behind}.",
      "Noise on that cable, a bad plug or a bad shield: change the cable, keep it away from motor cables."}},
    {Code::kLinkLost,
     "link-lost",
     {"{slave} lost its link at port {port} {count} (0x{register}), last at {last}.",
      "A loose plug, a bad cable, or a neighbour without power."}},
    {Code::kFramesLost,
     "frames-lost",
     {"{count} frames did not come back (up to {most} close together, first at {since}), and no slave counted an error "
      "at its ports.",
      "They are lost between the host and the first slave, or in the network card and its driver."}},
    {Code::kFramesLostByNoise,
     "frames-lost-by-noise",
     {"{count} frames did not come back (up to {most} close together, first at {since}); they were damaged on their "
      "way, first at {slave} "
      "port {port}.",
      "Mend what is found about that port."}},
    {Code::kFramesLostByHost,
     "frames-lost-by-host",
     {"{count} frames did not come back in time while the host stood still.", "Find out what held the host."}},
    {Code::kFramesLostByCable,
     "frames-lost-by-interruption",
     {"{count} frames were lost when {slave} went away or came back.", ""}},
    {Code::kFramesLate,
     "frames-late",
     {"{count} frames came back after their cycle, by up to {largest}.",
      "The way through the network card takes too long now and then: interrupt moderation, a switch, or a busy host."}},
    {Code::kHostStalled,
     "host-stalled",
     {"The host stood still {times}, for up to {longest}, first at {since}: {count} cycles were left out.",
      "Look for what held it: another process of higher priority, power management, the virtual machine's host."}},
    {Code::kHostLate,
     "host-late",
     {"The host sends late: half of the frames by {p50}, one in a hundred by {p99}, one in a thousand by {p999}, at "
      "most {largest}; "
      "the frames may be {margin} late.",
      "Give the master a processor of its own and real-time priority, or increase the set value."}},
    {Code::kWorkingCounter,
     "working-counter",
     {"{count} cycles had a wrong working counter ({received} instead of {expected} last), from {since} on.",
      "A slave left OP, lost its link or did not serve its data."}},
    {Code::kWorkingCounterExplained,
     "working-counter-explained",
     {"{count} cycles had a wrong working counter, from {since} on: that is what the others see of {slave}.", ""}},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (static_cast<std::size_t>(kRows[i].code) != i) return false;
  }
  return true;
}
static_assert(in_order());

}  // namespace

std::string_view finding_code_name(FindingCode code) { return kRows[static_cast<std::size_t>(code)].name; }
FindingWords finding_words(FindingCode code) { return kRows[static_cast<std::size_t>(code)].words; }

}  // namespace syncline
