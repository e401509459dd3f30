// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "findings/finding.h"

/// What is found about a recording itself, when it is read, and about a table or capture that is made one.
namespace syncline::words {

inline constexpr FindingWords kRecording[] = {
    {"recording-damaged",
     Severity::kError,
     "A part of a recording is damaged",
     "Its bytes are not those that were written: a disk, a copy or another program has changed them. What is left out "
     "was recorded, and nothing is known of it any more.",
     "Read it from another copy; what is shown beside it is as it was written.",
     "",
     {{"", "Row {row} of the table {table} is damaged and left out"},
      {"gap", "Row {row} of the table {table} is damaged: cycles {first} to {last} are a gap"},
      {"series", "Row {row} of the table {table} is damaged: {signal} is not known in cycles {first} to {last}"},
      {"missing", "{count:# row|# rows} of the table {table} {count:is|are} missing"},
      {"missing-gap",
       "{count:# row|# rows} of the table {table} {count:is|are} missing: cycles {first} to {last} are a gap"},
      {"block", "The rows of block {block} contradict each other: cycles {first} to {last} are a gap"}}},
    {"recording-cut-off",
     Severity::kError,
     "A recording is cut off",
     "The file is shorter than it was: a copy, a transfer or a full disk ended within it. What is shown is as it was "
     "written; of what is lost nothing is known any more.",
     "Copy the whole file once more, from where it was written.",
     "",
     {{"",
       "The file is cut off: {there} of {all} KiB are there, with {cycles:# cycle|# cycles}; {count:# block|# blocks} "
       "of values, about a second each, {count:is|are} lost"},
      {"pages",
       "SQLite refuses the file: what is shown was found page by page, with {cycles:# cycle|# cycles}; "
       "{count:# block|# blocks} of values, about a second each, {count:is|are} lost"},
      {"nothing", "no whole cycle of it is left"}}},
    {"recording-log-missing",
     Severity::kWarning,
     "The log of a recording is missing",
     "A recording that was cut short has its last part in a log beside it.",
     "Copy the file that ends in -wal together with the recording.",
     "",
     {{"",
       "The recording was cut short, and its log {file} is not beside it: what that held, the end of the run, is "
       "missing unless another program has taken it over."}}},
    {"recording-unchecked",
     Severity::kNote,
     "The rows of a recording carry no checks",
     "An older program has written it.",
     "",
     "",
     {{"",
       "The recording is of version {version}, whose rows carry no checks: damage in their values may not be seen."}}},
    {"import-line-cut",
     Severity::kWarning,
     "A table is cut off",
     "The file ends in the middle of a line: whoever has written or copied it did not come to its end.",
     "Import the whole file.",
     "",
     {{"", "Line {line}, the last one, is cut off and left out."},
      {"kept", "Line {line}, the last one, has no end: its last cell may be cut off."}}},
    {"import-capture-cut",
     Severity::kWarning,
     "A capture is cut off",
     "Whoever has written or copied it did not come to its end.",
     "Import the whole file.",
     "",
     {{"", "The capture breaks off behind {frames:# frame|# frames} ({reason}): what came before is imported."}}},
    {"import-frames-cut",
     Severity::kWarning,
     "Frames were captured in part only",
     "What they carry is not known: a cycle without its frame is missing, or counts as one whose frame was lost.",
     "Capture whole frames (a snap length of 0).",
     "",
     {{"", "{count:# frame was|# frames were} captured in part only and passed over."}}},
    {"import-times",
     Severity::kNote,
     "Who stamped the frames of an imported capture",
     "Times of a probe are good to nanoseconds. Those of a host hold its interrupts and its clock, too: what is in the "
     "lateness or the round trip of a few microseconds may be its own.",
     "",
     "",
     {{"", "Times are software stamps of the host that captured."},
      {"probe", "Times are the hardware stamps of a probe, which the frames carry; dated by the first frame."},
      {"mixed",
       "{count:# frame has|# frames have} hardware stamps of a probe, the others of {frames} are stamped by the host "
       "that captured them: times between the two do not compare."}}},

    {"import-replies-missing",
     Severity::kNote,
     "Replies are missing in an imported capture",
     "Lost on the bus and lost by who captured look alike. A mirror port of a switch passes over frames when both ways "
     "together are more than it carries, and gives no two frames their true distance.",
     "Capture with a probe in the line, or at the master; compare with the lost frames that the master counts.",
     "",
     {{"",
       "{count:# cyclic frame has|# cyclic frames have} no reply in the capture, of {frames}: lost on the bus, or by "
       "who "
       "captured."},
      {"back", "Only frames on their way back were captured: round trips and lost frames are not known."}}},
    {"import-switch",
     Severity::kWarning,
     "An imported capture was taken through a switch",
     "A switch holds frames back, one behind the other, and stamps none: distances, round trips and jitter are its own "
     "as well, and what a mirror port cannot carry is missing.",
     "Capture with a probe in the line, or on the master's own adapter.",
     "",
     {{"", "{count:# frame is|# frames are} of a switch itself (spanning tree, neighbour discovery)."},
      {"tagged", "{count:# EtherCAT frame has|# EtherCAT frames have} a VLAN tag (802.1Q), which a switch has put on."},
      {"twice",
       "{count:# EtherCAT frame came|# EtherCAT frames came} twice, byte for byte, as a mirror port sends what enters "
       "and leaves."}}},
    {"import-virtual-machine",
     Severity::kWarning,
     "An imported capture was taken in a virtual machine",
     "A hypervisor passes frames on when it gets to it, and its clock is not the host's: times are off by milliseconds "
     "at any moment.",
     "Capture on a machine of its own, whose adapter stands at the bus.",
     "",
     {{"",
       "{count:# EtherCAT frame was|# EtherCAT frames were} sent by {address}, the adapter of a virtual machine."}}},
};

}  // namespace syncline::words
