// SPDX-License-Identifier: Apache-2.0
#include "check/rule_tables.h"

namespace syncline::checker {
namespace {

using enum CheckSeverity;

constexpr CheckRule kRules[] = {
    {"ENI-COE-01", kError, "The PDO assignment written is another than the SyncManager lists",
     "The slave exchanges other data than the master expects, or refuses SAFEOP (AL status code 0x001D or 0x001E)",
     "Write the PDOs of the SyncManager's list to 0x1C1n, in its order"},
    {"ENI-COE-02", kWarning, "A command specifier that is not 1",
     "Readers disagree on other values: 1 is the download that all tools write", "Write Ccs 1"},
    {"ENI-COE-03", kError, "The mapping written is another than the PDO lists",
     "Variables lie in other bytes than the process image says",
     "Write the entries of the PDO, in its order, or correct the PDO"},
    {"ENI-COE-04", kError, "A list is written in an order that slaves refuse",
     "A list can be changed only while its count is 0; slaves abort the write otherwise (0x06010000, 0x08000022)",
     "Write 0 to sub-index 0, then the entries, then their count"},
    {"ENI-COE-05", kWarning, "A start-up command has no data",
     "Nothing is written, or the slave aborts for a wrong length (0x06070010)", "Give it data, or disable it"},
    {"ENI-COE-06", kError, "Complete access to a sub-index other than 0 or 1",
     "Complete access starts at sub-index 0 or 1; slaves abort it", "Set SubIndex to 0, or CompleteAccess off"},
    {"ENI-COE-07", kError, "A start-up command on a transition without mailbox",
     "In INIT and BOOT there is no CoE: the command fails and the transition with it", "Move it to IP, PS or SO"},
    {"ENI-COE-08", kWarning, "The interpolation time is not the cycle",
     "A drive interpolates over the wrong time: it moves in jerks, or refuses to",
     "Set 0x60C2 to the cycle in which set values come"},
    {"ENI-COE-09", kError, "A download has another size than its object",
     "The slave aborts it (0x06070010, 0x06070012 or 0x06070013) and the transition fails",
     "Write as many bytes as the object has"},
    {"ENI-STATE-01", kError, "No command requests a state on the way to OP",
     "The slave stays where it is and the bus never reaches OP",
     "Add the AL control write (0x0120) on that transition"},
    {"ENI-STATE-02", kError, "A command requests another state than its transition leads to",
     "The slave goes elsewhere, or refuses the request (AL status code 0x0011)",
     "Correct the data of the AL control write"},
    {"ENI-STATE-03", kWarning, "Nothing waits for the state requested",
     "The next commands reach the slave before it is ready", "Add a read of 0x0130 with Validate behind the request"},
    {"ENI-STATE-04", kError, "A check waits for another state than the one requested",
     "The transition ends in a time-out though the slave is right", "Correct the data of Validate"},
    {"ENI-STATE-05", kWarning, "A slave has no init commands",
     "A master that goes by the file leaves it in INIT; only masters that make the commands themselves run it",
     "Export the file again with init commands"},
    {"ENI-ORD-01", kError, "A SyncManager is set behind the request for the state that needs it",
     "The slave checks it while it changes its state and refuses", "Move the command before the AL control write"},
    {"ENI-ORD-02", kError, "An FMMU is set behind the request for the state that needs it",
     "The first frames of the new state find no data, and working counters are too low",
     "Move the command before the AL control write"},
    {"ENI-ORD-03", kError, "SYNC0 is started behind the request for SAFEOP",
     "A slave in DC mode checks its SYNC signals on that way and refuses (AL status code 0x0030 or 0x002D)",
     "Move the write of 0x0980 before the AL control write"},
    {"ENI-ORD-04", kError, "A slave is addressed by its station address before it has one",
     "The command reaches nobody, and the transition fails", "Set 0x0010 first, or address the slave by its position"},
    {"ENI-ORD-05", kError, "The EEPROM is read before it belongs to the master",
     "The ESC refuses the read while the slave's controller has the EEPROM", "Write 0 to 0x0500 first"},
    {"ENI-ORD-06", kWarning, "PREOP is requested while the master has the EEPROM",
     "The slave cannot read its own settings and may refuse PREOP (AL status code 0x0051)",
     "Write 1 to 0x0500 before the request"},
    {"ENI-ORD-07", kError, "A slave is given another station address than its PhysAddr",
     "Every later command to PhysAddr reaches nobody", "Correct the data of the write to 0x0010"},
    {"ENI-ORD-08", kWarning, "The master does not clear what an earlier run left",
     "Old station addresses, FMMUs or SyncManagers answer beside the new ones until a slave is switched off",
     "Add the broadcast writes of 0x0010, 0x0600 and 0x0800 on IP to the master's init commands"},
    {"ENI-ORD-09", kWarning, "The EEPROM is asked and not read, or read and not asked",
     "What is compared is another word, or nothing",
     "Let a read of 0x0508 follow each request to 0x0502 (0x0100 and the address of the word)"},
};

}  // namespace

std::span<const CheckRule> commands_rules() { return kRules; }

}  // namespace syncline::checker
