// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "ui/text/finding_text.h"

namespace syncline::ui {
namespace {

// The words of core/diagnosis once more, where lupdate can see them: core knows no Qt. A test compares the two.
constexpr const char* kFindingSources[] = {
    QT_TRANSLATE_NOOP("Finding", "No answer from {slaves} since {since}; {near} is the last that answers."),
    QT_TRANSLATE_NOOP("Finding", "Check the power of the first one and the cable that leads to it."),
    QT_TRANSLATE_NOOP("Finding",
                      "No answer from {slaves} since {since}: nothing comes back over the cable at {near} port "
                      "{port}."),
    QT_TRANSLATE_NOOP("Finding", "Check the power of the first one, and the cable and plugs between the two."),
    QT_TRANSLATE_NOOP("Finding", "No answer from {slaves} from {since} on, for {length} ({count} in all)."),
    QT_TRANSLATE_NOOP("Finding", "A loose plug or a weak supply; the lost links of the ports say which cable."),
    QT_TRANSLATE_NOOP("Finding", "The network adapter {adapter} is down, gone or without carrier since {since}."),
    QT_TRANSLATE_NOOP("Finding",
                      "Check the plug at the host, and that the adapter is switched on (ip link set ... up); the bus "
                      "comes back with it."),
    QT_TRANSLATE_NOOP("Finding",
                      "The network adapter {adapter} was down, gone or without carrier from {since} on, for {length} "
                      "({count} in all); the bus came back with it."),
    QT_TRANSLATE_NOOP("Finding",
                      "A loose plug at the host, or somebody who switches the adapter off: a network manager, power "
                      "saving, the reset of a USB adapter."),
    QT_TRANSLATE_NOOP("Finding", "{slave} is in {state} with AL status code {alcode}{alarm}, since {since}."),
    QT_TRANSLATE_NOOP("Finding", "Check {check}."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed "
                      "{missed} SM2 events, its error counter reached {integrator} of {limit}."),
    QT_TRANSLATE_NOOP("Finding", "The cause is that of the missed events: {cause}."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed "
                      "{missed} SM2 events, {part} of them because frames came behind the SYNC0 they were meant "
                      "for. Nominally they are there {margin} before it, but one in a thousand is {lateness} late."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} fell to {state} with AL status code {alcode}{alarm} at {since}, and the master "
                      "saw nothing but good cycles before: no frame lost or late, none left out, outputs "
                      "nominally there {margin} before each SYNC0."),
    QT_TRANSLATE_NOOP("Finding",
                      "So the cause is in the slave: its application needed longer than the cycle, or than the "
                      "time between its outputs and SYNC0. Give it a longer cycle or more time before SYNC0, "
                      "or look for what slows its firmware."),
    QT_TRANSLATE_NOOP("Finding", "{slave} stays in {state} while others went further."),
    QT_TRANSLATE_NOOP("Finding", "Request the state again and watch its AL status."),
    QT_TRANSLATE_NOOP("Finding", "The slaves' deviation is not monitored."),
    QT_TRANSLATE_NOOP("Finding", "Switch sync-window monitoring on to prove that they are in sync."),
    QT_TRANSLATE_NOOP("Finding",
                      "No slave follows the reference clock ({clocks} with a system time behind it), so there "
                      "is no deviation to watch."),
    QT_TRANSLATE_NOOP("Finding", "The slaves are not in sync within {limit} since {since}."),
    QT_TRANSLATE_NOOP("Finding", "Look at the deviations of the single slaves."),
    QT_TRANSLATE_NOOP("Finding",
                      "The slaves are not in sync: {slave} is {deviation} off its reference clock, the limit "
                      "is {limit}."),
    QT_TRANSLATE_NOOP("Finding",
                      "A clock that stepped, was not initialised or cannot follow; its loop values and its "
                      "propagation delay stand in its distributed clocks."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} left the sync window at {since} ({deviation}, limit {limit}) and came back; "
                      "{count} in all."),
    QT_TRANSLATE_NOOP("Finding",
                      "A clock that steps, or a reference clock that was exchanged; see the events of that "
                      "moment."),
    QT_TRANSLATE_NOOP("Finding", "{slave} was {deviation} off its reference clock at {since}, and nobody monitors it."),
    QT_TRANSLATE_NOOP("Finding",
                      "Its clock stepped or lost its reference; switch sync-window monitoring on to be told at "
                      "once."),
    QT_TRANSLATE_NOOP("Finding",
                      "The master is not in sync with the reference clock (schedule error {error}){obstacle}."),
    QT_TRANSLATE_NOOP("Finding",
                      "Look for a busy host or a clock that stepped; if neither is there, choose the other "
                      "shift mode."),
    QT_TRANSLATE_NOOP("Finding",
                      "The master was out of sync with the reference clock {count}, first at "
                      "{since}{obstacle}; it found back."),
    QT_TRANSLATE_NOOP("Finding",
                      "See what else happened then: a clock that stepped, cycles left out, a reference clock "
                      "that was lost."),
    QT_TRANSLATE_NOOP("Finding", "The master synchronisation reports {code}: {meaning}"),
    QT_TRANSLATE_NOOP("Finding",
                      "The host's clock and the reference clock drift by {drift}; no controller balances more "
                      "than 600 ppm."),
    QT_TRANSLATE_NOOP("Finding", "Check the cycle time and the host's timer frequency."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} missed {missed} SM2 events, {part} of them because frames were lost; its error "
                      "counter reached {integrator} of {limit}."),
    QT_TRANSLATE_NOOP("Finding", "Find out where the frames are lost; its SYNC0 is not the reason."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} missed {missed} SM2 events, {part} of them because the host left cycles out; "
                      "its error counter reached {integrator} of {limit}."),
    QT_TRANSLATE_NOOP("Finding", "Find out what held the host; its SYNC0 is not the reason."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} missed {missed} SM2 events, {part} of them because frames came behind the SYNC0 "
                      "they were meant for: nominally they are there {margin} before it, but one in a thousand "
                      "is {lateness} late."),
    QT_TRANSLATE_NOOP("Finding", "Increase the set value by {more} or more, or make the host less late."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} missed {missed} SM2 events, and the master was not locked to the reference "
                      "clock all the time: frames slid through its SYNC0."),
    QT_TRANSLATE_NOOP("Finding", "Mend the lock first."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} counts {missed} missed SM2 events (0x1C32:{sub}), and for {part} of them the "
                      "master saw good cycles."),
    QT_TRANSLATE_NOOP("Finding",
                      "Its outputs come nominally {margin} before SYNC0, and it needs {need} for them; look at "
                      "its firmware's load, or at frames that are damaged in front of it."),
    QT_TRANSLATE_NOOP("Finding",
                      "The frames reach {slave} nominally {margin} before its SYNC0, and one in a thousand is "
                      "{lateness} late."),
    QT_TRANSLATE_NOOP("Finding", "Increase the set value by {more} or more."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), and "
                      "used those of the cycle before: they come {margin} before SYNC0, and it needs {need}."),
    QT_TRANSLATE_NOOP("Finding", "Let its SYNC0 come {more} later: a shift of {shift}."),
    QT_TRANSLATE_NOOP("Finding", "{slave} had its inputs too late {count} (0x1C33:0D shift too short)."),
    QT_TRANSLATE_NOOP("Finding", "Latch them earlier: a smaller input shift time."),
    QT_TRANSLATE_NOOP("Finding",
                      "The firmware of {slave} was silent at {since}: its PDI watchdog expired {count} "
                      "(0x0443)."),
    QT_TRANSLATE_NOOP("Finding",
                      "Its outputs and inputs stood still meanwhile. Look for what stops it: an interrupt "
                      "storm, a debugger, a crash."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} does not renew its inputs in every cycle, as it did before: from {since} on, {count} "
                      "(0x0805 + 8 n of its input "
                      "SyncManager names the same buffer again)."),
    QT_TRANSLATE_NOOP(
        "Finding",
        "Its firmware takes longer than the cycle: look for what else it has to do, give it a longer cycle, or fewer "
        "objects."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} needed longer than its cycle {count} ({object} cycle exceeded), last at {last}."),
    QT_TRANSLATE_NOOP("Finding", "Give it a longer cycle, or fewer objects and functions in each."),
    QT_TRANSLATE_NOOP("Finding",
                      "{slave} skipped {count} cycles because the one before was not over ({object} cycle "
                      "exceeded): its fieldbus needs longer than a cycle."),
    QT_TRANSLATE_NOOP("Finding", "Use a longer bus cycle or a larger sync multiplier, or let its fieldbus carry less."),
    QT_TRANSLATE_NOOP("Finding", "{slave} left {count} mailbox requests in a row without an answer."),
    QT_TRANSLATE_NOOP("Finding",
                      "Its firmware is busy or stopped; the counters that it keeps in objects are as old as "
                      "that."),
    QT_TRANSLATE_NOOP("Finding", "The process data watchdog of {slave} expired {count} (0x0442), last at {last}."),
    QT_TRANSLATE_NOOP("Finding", "It had no outputs for longer than its watchdog time."),
    QT_TRANSLATE_NOOP("Finding",
                      "{count} frames reached {slave} damaged at port {port} (0x{register}), from {since} on; "
                      "the cable comes from {behind}."),
    QT_TRANSLATE_NOOP("Finding",
                      "Noise on that cable, a bad plug or a bad shield: change the cable, keep it away from "
                      "motor cables."),
    QT_TRANSLATE_NOOP("Finding", "{slave} lost its link at port {port} {count} (0x{register}), last at {last}."),
    QT_TRANSLATE_NOOP("Finding", "A loose plug, a bad cable, or a neighbour without power."),
    QT_TRANSLATE_NOOP("Finding",
                      "{count} frames did not come back (up to {most} close together, first at {since}), and "
                      "no slave counted an error at its ports."),
    QT_TRANSLATE_NOOP("Finding",
                      "They are lost between the host and the first slave, or in the network card and its "
                      "driver."),
    QT_TRANSLATE_NOOP("Finding",
                      "{count} frames did not come back (up to {most} close together, first at {since}); they "
                      "were damaged on their way, first at {slave} port {port}."),
    QT_TRANSLATE_NOOP("Finding", "Mend what is found about that port."),
    QT_TRANSLATE_NOOP("Finding", "{count} frames did not come back in time while the host stood still."),
    QT_TRANSLATE_NOOP("Finding", "Find out what held the host."),
    QT_TRANSLATE_NOOP("Finding", "{count} frames were lost when {slave} went away or came back."),
    QT_TRANSLATE_NOOP("Finding", "{count} frames came back after their cycle, by up to {largest}."),
    QT_TRANSLATE_NOOP("Finding",
                      "The way through the network card takes too long now and then: interrupt moderation, a "
                      "switch, or a busy host."),
    QT_TRANSLATE_NOOP("Finding",
                      "The host stood still {times}, for up to {longest}, first at {since}: {count} cycles "
                      "were left out."),
    QT_TRANSLATE_NOOP("Finding",
                      "Look for what held it: another process of higher priority, power management, the "
                      "virtual machine's host."),
    QT_TRANSLATE_NOOP("Finding",
                      "The host sends late: half of the frames by {p50}, one in a hundred by {p99}, one in a "
                      "thousand by {p999}, at most {largest}; the frames may be {margin} late."),
    QT_TRANSLATE_NOOP("Finding",
                      "Give the master a processor of its own and real-time priority, or increase the set "
                      "value."),
    QT_TRANSLATE_NOOP("Finding",
                      "{count} cycles had a wrong working counter ({received} instead of {expected} last), "
                      "from {since} on."),
    QT_TRANSLATE_NOOP("Finding", "A slave left OP, lost its link or did not serve its data."),
    QT_TRANSLATE_NOOP("Finding",
                      "{count} cycles had a wrong working counter, from {since} on: that is what the others "
                      "see of {slave}."),
    QT_TRANSLATE_NOOP("Finding", "frames were lost"),
    QT_TRANSLATE_NOOP("Finding", "the host left cycles out"),
    QT_TRANSLATE_NOOP("Finding", "frames came behind the SYNC0 they were meant for"),
    QT_TRANSLATE_NOOP("Finding",
                      "not seen by the master; look at its firmware and at frames that are damaged in front of "
                      "it"),
    QT_TRANSLATE_NOOP("Finding", "no limit"),
    QT_TRANSLATE_NOOP("Finding", "one of the slaves"),
};

}  // namespace

std::span<const char* const> translatableFindings() { return kFindingSources; }

}  // namespace syncline::ui
