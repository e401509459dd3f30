// SPDX-License-Identifier: Apache-2.0
#include "check/rule_tables.h"

namespace syncline::checker {
namespace {

using enum CheckSeverity;

constexpr CheckRule kCyclicRules[] = {
    {"ENI-DC-01", kError, "Slaves use distributed clocks, and nothing distributes the time",
     "Each clock runs at its own speed: SYNC signals drift apart by some 10 us a second",
     "Add NOP 0x0900 and ARMW 0x0910 to the cyclic commands"},
    {"ENI-DC-02", kWarning, "The NOP to 0x0900 is missing before the drift compensation",
     "EC-Master used to refuse such files, and cannot measure delays again while it runs",
     "Add a NOP with Ado 2304 and 4 bytes before the ARMW"},
    {"ENI-DC-03", kError, "The time distributed is not that of the reference clock",
     "Master and slaves follow different clocks", "Let Adp of the ARMW and ReferenceClock name the same slave"},
    {"ENI-DC-04", kError, "More than one reference clock",
     "Only one clock can lead; masters take the first or the last",
     "Leave ReferenceClock on at the slave that the ARMW addresses"},
    {"ENI-DC-05", kError, "The write that steers the reference clock does not reach it",
     "The bus shift has no effect, or disturbs a clock that follows another",
     "Give it the Adp of the ARMW, or remove it"},
    {"ENI-DC-06", kNote, "The sync window is monitored with fewer than two clocks",
     "There is nothing to compare: EC-Master leaves the monitoring out", "Remove the BRD of 0x092C"},
    {"ENI-DC-07", kWarning, "A slave with distributed clocks stands before the reference clock",
     "The frame passes it before it carries the time of this cycle, so that it is given the last one, or 0, and stays "
     "off",
     "Make the first slave with distributed clocks the reference clock"},
    {"ENI-DC-08", kError, "A command to a clock register has the wrong length",
     "The ESC takes the time over only when all its bytes are accessed", "Use 4 or 8 bytes for 0x0910, 4 for 0x092C"},
    {"ENI-DC-09", kWarning, "The time is not distributed in all states from PREOP on",
     "Clocks drift apart before SYNC signals start, and slaves miss their first pulses",
     "Let the command have PREOP, SAFEOP and OP"},
    {"ENI-DC-10", kError, "SYNC0 is switched on without a cycle time",
     "The slave gets one pulse and no more, and refuses SAFEOP or OP (AL status code 0x002D or 0x0035)",
     "Write the cycle time to 0x09A0 on PS"},
    {"ENI-DC-11", kError, "The cycle time written is another than the DC element says",
     "The slave runs with the one, the master plans with the other", "Let 0x09A0 have CycleTime0 and CycleTime1"},
    {"ENI-DC-12", kError, "SYNC1 is switched on without SYNC0", "SYNC1 is derived from SYNC0 and never comes",
     "Use 0x0700 to activate both"},
    {"ENI-DC-13", kError, "SYNC0 is switched on before its times are set", "The signals start at once with old values",
     "Write 0x09A0 and 0x0990 before 0x0980"},
    {"ENI-DC-14", kWarning, "No start time is written",
     "The master has no command to put the start time into, and SYNC0 may start in the past, which is never",
     "Add the write of 8 bytes at 0x0990 before 0x0980"},
    {"ENI-DC-15", kWarning, "The start-time command carries another shift than the DC element",
     "Masters take the shift from the one or from the other", "Let the data of 0x0990 be ShiftTime"},
    {"ENI-DC-16", kWarning, "SYNC0 is never switched off",
     "SYNC signals go on when the slave has left OP, and the next start finds a running unit",
     "Add the write of 0 to 0x0980 on SP, OP, SI and OI"},
    {"ENI-DC-17", kWarning, "The DC element and the commands contradict each other",
     "Masters that go by the element set the slave up in another way than those that go by the commands",
     "Give the slave a DC element and the write of 0x0980, or neither"},
    {"ENI-DC-18", kWarning, "The SYNC0 cycle does not fit the cycle of the frames",
     "Frames and SYNC0 wander through each other: now and then a set value is missed or used twice",
     "Use a multiple or a whole fraction of the cycle"},
    {"ENI-DC-19", kWarning, "The shift is longer than the cycle",
     "Pulses come one cycle later than meant, since the shift counts modulo the cycle", "Use a shift within the cycle"},
    {"ENI-DC-20", kWarning, "A SYNC1 time without SYNC1", "It has no effect",
     "Activate SYNC1 (0x0400), or set CycleTime1 to 0"},
    {"ENI-DC-21", kWarning, "The reference clock is steered before its time is read",
     "Masters find the write of bus shift behind the ARMW: before it they steer by the time of the cycle before, or "
     "take it for something else",
     "Put the APWR of 0x0910 behind the ARMW"},
    {"ENI-WKC-01", kError, "The working counter of a process-data command does not fit the FMMUs",
     "The master takes the data of every cycle for invalid",
     "Set Cnt to reading slaves, plus writing slaves (twice with LRW)"},
    {"ENI-WKC-02", kError, "The working counter of a broadcast does not fit the number of slaves",
     "The master takes the answer of every cycle for a missing slave", "Set Cnt to the number of slaves"},
    {"ENI-WKC-03", kWarning, "A process-data command has no working counter",
     "The master does not notice when slaves fall out and uses old inputs", "Add Cnt"},
    {"ENI-WKC-04", kError, "The working counter of a command to one slave is impossible",
     "The command fails though the slave has answered", "Set Cnt to 1, or 3 where it reads and writes"},
    {"ENI-FRM-01", kError, "A frame or datagram is too long for Ethernet", "It cannot be sent",
     "Move commands to another frame; 1498 bytes of datagrams fit into one, 12 of each are its own"},
    {"ENI-FRM-02", kError, "A command has no bytes", "Slaves do not answer it, and its working counter stays 0",
     "Give it Data or DataLength"},
    {"ENI-FRM-03", kNote, "The state of the slaves is not read cyclically",
     "The master has to ask for it apart, and learns of errors later", "Add a BRD of 0x0130 with 2 bytes"},
    {"ENI-FRM-04", kError, "Two commands carry the same process data",
     "The second overwrites the data of the first; buffers change twice a cycle",
     "Give them logical addresses that do not meet, or states that exclude each other"},
};

}  // namespace

std::span<const CheckRule> cyclic_rules() { return kCyclicRules; }

}  // namespace syncline::checker
