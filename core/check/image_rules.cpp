// SPDX-License-Identifier: Apache-2.0
#include "check/rule_tables.h"

namespace syncline::checker {
namespace {

using enum CheckSeverity;

constexpr CheckRule kImageRules[] = {
    {"ENI-TIME-01", kWarning, "A check has a time-out of 0",
     "It fails unless the first answer fits; other masters take 0 for a default of their own",
     "Give Validate a Timeout in ms"},
    {"ENI-TIME-02", kWarning, "The time-out of a change of state is very short",
     "Slaves may need 100 ms and more, and the start fails now and then",
     "Use the time-outs of the ESI (3000 ms to PREOP, 10000 ms to SAFEOP and OP, 200 ms back to SAFEOP)"},
    {"ENI-TIME-03", kError, "The frames take longer on the wire than the cycle", "No master can send them in time",
     "Lengthen the cycle, or exchange less"},
    {"ENI-TIME-04", kWarning, "The frames take over 80 % of the cycle",
     "Mailbox, delays of the slaves and jitter of the master do not fit beside them",
     "Lengthen the cycle, or exchange less"},
    {"ENI-TIME-05", kError, "An impossible cycle time", "CycleTime is in microseconds; masters run some 31 us to 10 s",
     "Correct CycleTime"},
    {"ENI-TIME-06", kWarning, "The cycle of a task is no multiple of the first task's",
     "Masters run slower tasks in every n-th cycle of the first one", "Use a multiple"},
    {"ENI-TIME-07", kWarning, "A start-up command has hardly any time",
     "A slave answers in a few to some hundred milliseconds; the command fails before",
     "Write 0, the master's own time, or at least 20 ms"},
    {"ENI-IMG-01", kError, "A variable lies outside the process image",
     "The application reads or writes memory that is not there",
     "Correct BitOffs or BitSize, or ByteSize of the image"},
    {"ENI-IMG-02", kNote, "Variables lie behind the image",
     "TwinCAT writes the variables of its own diagnosis so; other masters have nothing there",
     "Nothing, unless the application uses them"},
    {"ENI-IMG-03", kWarning, "Two variables share bits", "Writing the one changes the other",
     "Correct BitOffs or BitSize, unless one is a part of the other"},
    {"ENI-IMG-04", kError, "The process data of a slave lie outside the image",
     "The master copies from or to memory that is not there",
     "Correct BitStart or BitLength, or ByteSize of the image"},
    {"ENI-IMG-05", kError, "Two slaves share bits of the image",
     "Inputs overwrite each other, or both slaves get the same outputs", "Give each slave bits of its own"},
    {"ENI-IMG-06", kWarning, "Two variables have the same name",
     "EC-Master and others find variables by name: they find the first", "Give each variable a name of its own"},
    {"ENI-IMG-07", kWarning, "A variable has another size than its type",
     "The application reads too many bits or too few", "Correct BitSize or DataType"},
    {"ENI-IMG-08", kError, "A command's data lie outside the image",
     "The master copies from or to memory that is not there",
     "Correct InputOffs or OutputOffs, or ByteSize of the image"},
    {"ENI-IMG-09", kError, "Two commands share bytes of the image", "The data of one overwrite those of the other",
     "Give each command bytes of its own"},
    {"ENI-IMG-10", kError, "Send or Recv is not where the frames put the data",
     "The application reads the data of another slave", "Correct BitStart, or the offsets of the command"},
    {"ENI-IMG-11", kError, "A copy between slaves reaches outside the image",
     "The master copies from or to memory that is not there", "Correct the offsets of CopyInfo"},
    {"ENI-IMG-12", kNote, "Variables of the diagnosis share bits",
     "TwinCAT gives several names to the state bits of its frames and slaves; other masters do not fill them",
     "Nothing, unless the application uses them with another master"},
    {"ENI-DIA-01", kNote, "A task without cycle time",
     "TwinCAT takes the cycle from its own task; EC-Master and others use a default",
     "Set the cycle in the master, or add CycleTime in microseconds"},
    {"ENI-DIA-02", kNote, "Image offsets in the way of TwinCAT",
     "InputOffs counts datagram headers, the data stand 10 bytes behind; EC-Engineer writes the offsets of the data",
     "Nothing: readers should go by BitStart and BitOffs"},
    {"ENI-DIA-03", kNote, "The time is distributed by FRMW",
     "Every tool known writes ARMW; readers that look for it alone see no distributed clocks",
     "Use ARMW with the auto-increment address of the reference clock"},
    {"ENI-DIA-04", kNote, "The identity of a slave is not checked",
     "A master that goes by the commands runs whatever device stands in that place",
     "Add the reads of vendor and product from the EEPROM with Validate on IP"},
};

}  // namespace

std::span<const CheckRule> image_rules() { return kImageRules; }

}  // namespace syncline::checker
