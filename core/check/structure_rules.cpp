// SPDX-License-Identifier: Apache-2.0
#include "check/rule_tables.h"

namespace syncline::checker {
namespace {

using enum CheckSeverity;

constexpr CheckRule kStructureRules[] = {
    {"ENI-XML-01", kError, "The file cannot be taken in",
     "A value stands in a form that no reader understands, so that nothing behind it was checked by meaning",
     "Mend the value at the line named, then check again"},
    {"ENI-XML-02", kError, "A required element or attribute is missing",
     "ETG.2100 demands it; strict readers refuse the file, others take a default that need not fit",
     "Add the element, or export the file again with the tool that made it"},
    {"ENI-XML-03", kWarning, "Elements stand in another order than ETG.2100's",
     "Every type is a sequence: readers that follow the schema refuse the file or skip what comes too late",
     "Move the element to its place"},
    {"ENI-XML-04", kNote, "An element or attribute that ETG.2100 does not know",
     "Masters of other makers ignore it, so whatever it sets is lost there",
     "Nothing, unless the file has to carry the setting to another maker's master"},
    {"ENI-XML-05", kError, "A value has the wrong type or is out of range",
     "Readers refuse the file, or take the value for 0", "Write a value of the type named"},
    {"ENI-XML-06", kWarning, "A value is written in a form that the schema does not allow",
     "Integers are signed decimals (xs:int), booleans 0, 1, true or false: strict readers refuse 0x..., #x..., numbers "
     "above 2147483647 and blanks between bytes",
     "Write it as the schema does; numbers from 0x80000000 on as negative ones"},
    {"ENI-XML-07", kError, "An element stands more often than allowed",
     "Readers take the first or the last, and not all the same one", "Remove all but one"},
    {"ENI-XML-08", kError, "Elements that exclude each other",
     "A command has either a register or a logical address, and either data or a length: readers choose differently",
     "Keep one of the two"},
    {"ENI-XML-09", kWarning, "The root element is not EtherCATConfig",
     "Only masters of the maker who signed the file take it", "Export the file without signature"},
    {"ENI-REF-01", kError, "A previous port names a slave that is not in the file",
     "The master cannot check the wiring, and takes every line for a wrong one or none",
     "Give PreviousPort the PhysAddr of the slave in front"},
    {"ENI-REF-02", kError, "A slave hangs on itself or on one behind it",
     "Frames pass the slaves in the order of the file: the wiring told cannot exist",
     "Correct the PhysAddr of PreviousPort, or the order of the slaves"},
    {"ENI-REF-03", kError, "Two slaves have the same station address",
     "Both answer the commands to that address: working counters are 2 and data are mixed",
     "Give each slave a PhysAddr of its own"},
    {"ENI-REF-04", kError, "A slave has the station address 0",
     "0 is what all slaves have before they are set up, so commands reach any of them",
     "Give it an address from 1 on; tools start at 1001"},
    {"ENI-REF-05", kError, "The auto-increment address is not that of the slave's place",
     "Commands to a position reach another slave than the one described",
     "Write 0, 65535, 65534 and so on in the order of the slaves"},
    {"ENI-REF-06", kWarning, "Two slaves have the same name",
     "Programs that look a slave or its variables up by name find the first one", "Give each slave a name of its own"},
    {"ENI-REF-07", kError, "An init command goes to another slave",
     "Another slave is set up with the settings of this one",
     "Give Adp the slave's PhysAddr (FPxx) or AutoIncAddr (APxx)"},
    {"ENI-REF-08", kError, "A cyclic command addresses no slave of the file",
     "Its working counter stays 0 in each cycle", "Correct Adp, or remove the command"},
    {"ENI-REF-09", kError, "Two slaves hang on one port",
     "A port has one cable: the master finds another wiring than the one told",
     "Correct Port or PhysAddr of one PreviousPort"},
    {"ENI-REF-10", kError, "The identity that a command expects is not the one of Info",
     "The slave that Info describes fails the check: the bus does not leave INIT",
     "Correct Validate, or VendorId, ProductCode, RevisionNo and SerialNo of Info"},
    {"ENI-REF-11", kWarning, "A slave hangs on one that only swapped cables put behind it",
     "Frames pass the slaves in the order of the file: so it can be only where frames enter that one by another port "
     "than A",
     "Swap its cables IN and OUT, or correct PhysAddr of PreviousPort"},
    {"ENI-HC-01", kError, "A hot-connect group does not have the members it says",
     "The master takes slaves of the fixed line for members, or misses some",
     "Set GroupMemberCnt to the number of slaves from the head of the group on"},
    {"ENI-HC-02", kError, "A hot-connect group cannot be identified",
     "Without a value to compare, the master cannot know which group has been plugged in",
     "Give the head an IdentifyCmd with Validate (alias 0x0012 or the device's ID)"},
    {"ENI-HC-03", kError, "Two hot-connect groups have the same identification",
     "The master takes one group for the other", "Give each head an alias of its own, in the file and in the device"},
};

}  // namespace

std::span<const CheckRule> structure_rules() { return kStructureRules; }

}  // namespace syncline::checker
