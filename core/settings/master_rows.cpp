// SPDX-License-Identifier: Apache-2.0
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/not_in_eni.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

/// References to the same field of a const and of a mutable project.
constexpr auto master = [](auto& project) -> auto& { return project.master; };
constexpr auto recovery = [](auto& project) -> auto& { return project.master.recovery; };
constexpr auto real_time = [](auto& project) -> auto& { return project.master.real_time; };

std::vector<Setting> general_rows() {
  return {
      field_setting(
          "master.name", Text{},
          {.label = "Name", .help = "Name of the master in the ENI file.", .eni = "Master/Info/Name"},
          [](auto& p, const Place&) -> auto& { return master(p).name; }),
      field_setting(
          "master.cycle_time_us", microseconds(limits::kShortestCycle, limits::kLongestCycle),
          {.label = "Cycle time", .help = "Time between two cyclic frames.", .eni = "Cyclic/CycleTime"},
          [](auto& p, const Place&) -> auto& { return master(p).cycle_time; }),
      field_setting(
          "master.destination_mac", MacAddress{},
          {.label = "Destination address",
           .help = "Destination address of the frames; broadcast unless a switch demands another.",
           .eni = "Master/Info/Destination",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return master(p).destination_mac; }),
      field_setting(
          "master.overlap_process_data", Switch{},
          {.label = "Overlap inputs and outputs",
           .help = "Inputs and outputs of a slave share logical addresses, which halves the cyclic frame.",
           .object = "FMMU 0x0600",
           .eni = "Cyclic/Frame/Cmd (LRW)"},
          [](auto& p, const Place&) -> auto& { return master(p).overlap_process_data; }),
      field_setting(
          "master.source_mac", MacAddress{},
          {.label = "Source address",
           .help = "Source address in the ENI file; zeros leave it to the network card.",
           .eni = "Master/Info/Source",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return master(p).source_mac; }),
  };
}

std::vector<Setting> recovery_rows() {
  return {
      field_setting(
          "master.recovery.automatic", Switch{},
          {.label = "Bring back lost slaves",
           .help = "Slaves that come back (cable healed, power back) are set up again and led to the state of the "
                   "bus.",
           .no_eni = not_in_eni::kMaster},
          [](auto& p, const Place&) -> auto& { return recovery(p).automatic; }),
      field_setting(
          "master.recovery.error_tries", integer(0, 1000),
          {.label = "Tries to leave an error state",
           .help = "How often an error state is acknowledged and the state requested again; 0 leaves it to the "
                   "user.",
           .object = "0x0120",
           .no_eni = not_in_eni::kMaster},
          [](auto& p, const Place&) -> auto& { return recovery(p).error_tries; }),
      field_setting(
          "master.recovery.start_incomplete", Switch{},
          {.label = "Start without missing slaves",
           .help = "Goes online with the slaves that are there; the others join when they appear.",
           .no_eni = not_in_eni::kMaster},
          [](auto& p, const Place&) -> auto& { return recovery(p).start_incomplete; }),
  };
}

std::vector<Setting> real_time_rows() {
  return {
      field_setting(
          "master.real_time.spin_us", microseconds(0, kMillisecond),
          {.label = "Asking the clock",
           .help = "Most of each wait that is spent asking the clock: earlier wake-ups for processor time. Used is "
                   "what this host needs for 99 of 100 frames to leave at most 5 % of the cycle late, and at most a "
                   "quarter of the cycle.",
           .no_eni = not_in_eni::kHost,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return real_time(p).spin; }),
      field_setting(
          "master.real_time.cpu", integer(0, 1023),
          {.label = "Processor",
           .help = "Processor that the cyclic thread is bound to; auto leaves it to the system.",
           .no_eni = not_in_eni::kHost,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return real_time(p).cpu; }),
  };
}

}  // namespace

std::vector<Setting> master_rows() {
  auto rows = general_rows();
  append(rows, recovery_rows());
  append(rows, real_time_rows());
  return rows;
}

}  // namespace syncline::settings
