// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "config/port_kind.h"
#include "protocol/delay_difference.h"
#include "reasons/because.h"
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/not_in_eni.h"
#include "settings/predicates.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr auto bus_dc = [](auto& project) -> auto& { return project.master.dc; };
constexpr auto loop = [](auto& project) -> auto& { return project.master.dc.loop; };
constexpr auto notifications = [](auto& project) -> auto& { return project.master.dc.notifications; };
constexpr auto window = [](auto& project) -> auto& { return project.master.dc.sync_window; };

/// tDiff where the slaves all have the same.
Value usual_difference(const Project& project, const Place&) {
  const auto at_ebus = [](const SlaveSettings& slave) { return port_kind(slave.device, 0) == PortKind::kEbus; };
  if (std::ranges::none_of(project.slaves, at_ebus)) return std::int64_t{kUsualDelayDifference};
  // The way to the first one is measured by nobody.
  if (std::all_of(project.slaves.begin() + 1, project.slaves.end(), at_ebus)) return std::int64_t{kEbusDelayDifference};
  return Unset{};
}

std::vector<Option> clocks(const Project& project, const Place&) {
  std::vector<Option> options{{Unset{}, "auto", "First with DC"}};
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    const auto& slave = project.slaves[i];
    if (!slave.device.dc) continue;
    options.push_back({static_cast<std::int64_t>(i), std::to_string(i), fmt::format("{}  {}", i, slave.name)});
  }
  return options;
}

Setting reference_clock_row() {
  auto row = field_setting(
      "master.dc.reference_clock", integer(0, limits::kLargestWord),
      {.label = "Reference clock",
       .help = "Position of the slave whose clock all others follow; auto is the first slave with DC.",
       .object = "0x0910",
       .eni = "DC/ReferenceClock"},
      [](auto& p, const Place&) -> auto& { return bus_dc(p).reference_clock; });
  row.type_words = "slave position";
  row.range_words = "auto, 0..last slave";
  row.options = clocks;
  row.write = [apply = row.write](Project& project, const Place& place, const Value& value) -> Status {
    const auto* position = std::get_if<std::int64_t>(&value);
    if (position != nullptr && !is_position(project.slaves.size(), *position)) {
      return bad_value(because("there is no slave at position {position}; the project has {count}", *position,
                               project.slaves.size()));
    }
    return apply(project, place, value);
  };
  return row;
}

std::vector<Setting> window_rows() {
  return {
      field_setting(
          "master.dc.sync_window", Switch{},
          {.label = "Monitor the sync window",
           .help = "Watches the wire-ored system time difference of all slaves (0x092C).",
           .object = "0x092C",
           .eni = "Cyclic/Frame/Cmd (BRD 0x092C)"},
          [](auto& p, const Place&) -> auto& { return window(p).enabled; }),
      field_setting(
          "master.dc.sync_window_exponent", integer(1, 30),
          {.label = "Limit 2ⁿ − 1",
           .help = "Limit of the sync window: 2^exponent - 1 ns.",
           .object = "0x092C",
           .no_eni = not_in_eni::kJudged},
          [](auto& p, const Place&) -> auto& { return window(p).exponent; }),
      field_setting(
          "master.dc.sync_window_settle_ms", integer(0, limits::kLongestSettleMs, "ms"),
          {.label = "Settle time of the window",
           .help = "Time inside the window before the bus counts as in sync.",
           .no_eni = not_in_eni::kJudged},
          [](auto& p, const Place&) -> auto& { return window(p).settle_time_ms; }),
  };
}

std::vector<Setting> start_rows() {
  return {
      field_setting(
          "master.dc.burst_total", integer(0, 1'000'000, "frames"),
          {.label = "Burst, frames",
           .help = "Frames of the first drift compensation (FRMW or ARMW of 0x0910).",
           .object = "0x0910",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).burst_total; }),
      field_setting(
          "master.dc.burst_bulk", integer(1, 1000, "frames"),
          {.label = "Burst, frames a cycle",
           .help =
               "Frames of that burst in one cycle; where cycles are longer than 1 ms, in a tenth of one or in 1 ms.",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).burst_bulk; }),
      field_setting(
          "master.dc.burst_ends_early", Switch{},
          {.label = "Burst ends early",
           .help = "The burst ends when all slaves have settled.",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).burst_ends_early; }),
      field_setting(
          "master.dc.start_time_safety_us", microseconds(0, 10 * kSecond),
          {.label = "Lead of the start time",
           .help = "Lead of the SYNC start time (0x0990) on the time of writing it.",
           .object = "0x0990",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).start_time_safety; }),
      field_setting(
          "master.dc.start_time_grid_us", microseconds(0, kSecond),
          {.label = "Grid of the start time",
           .help = "Start times are multiples of this; 0 is the bus cycle.",
           .object = "0x0990",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).start_time_grid; }),
      field_setting(
          "master.dc.input_shift_us", microseconds(-limits::kLongestCycle, limits::kLongestCycle),
          {.label = "Input shift",
           .help = "Added to the SYNC0 shift of slaves that are based on the input reference.",
           .object = "0x0990",
           .eni = "Slave/DC/ShiftTime",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).input_shift; }),
  };
}

std::vector<Setting> clock_rows() {
  return {
      field_setting(
          "master.dc.enabled", Switch{},
          {.label = "Distributed clocks", .help = "Distributed clocks for the whole bus.", .eni = "Slave/DC, InitCmds"},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).enabled; }),
      reference_clock_row(),
      field_setting(
          "master.dc.continuous_propagation_compensation", Switch{},
          {.label = "Continuous propagation compensation",
           .help = "Measures the propagation delays again every 30 s and corrects them in small steps.",
           .object = "0x0928",
           .eni = "Cyclic/Frame/Cmd (0x0900)",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).continuous_propagation_compensation; }),
      field_setting(
          "master.dc.show_64bit_system_time", Switch{},
          {.label = "Show 64-bit system time",
           .help = "Reads and shows 64 bits of the system time (0x0910).",
           .object = "0x0910",
           .eni = "Cyclic/Frame/Cmd (0x0910)"},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).show_64bit_system_time; }),
  };
}

std::vector<Setting> choice_rows() {
  return {
      field_setting(
          "master.dc.first_slave_is_reference_clock", Switch{},
          {.label = "First slave leads",
           .help = "The first slave on the bus that has a system time leads, whatever is configured.",
           .eni = "Slave/DC/ReferenceClock",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).first_slave_is_reference_clock; }),
      field_setting(
          "master.dc.all_slaves", Switch{},
          {.label = "Synchronise all slaves",
           .help = "Every slave that has a system time is synchronised, with or without a DC operation mode.",
           .eni = "Slave/DC, Cyclic/Frame/Cmd",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).all_slaves; }),
      field_setting(
          "master.dc.delay_rounds", integer(1, 100),
          {.label = "Delay measurements",
           .help = "Latches of the receive times (0x0900) whose medians give the propagation delays.",
           .object = "0x0900",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return bus_dc(p).delay_rounds; }),
      with_automatic(field_setting(
                         "master.dc.delay_difference_ns", integer(0, 1000, "ns"),
                         {.label = "Delay difference",
                          .help = "Processing minus forwarding latency of the ESCs (tDiff of their data sheets); "
                                  "auto is 40 ns at ports with a cable and 20 ns at E-bus.",
                          .object = "0x0928",
                          .no_eni = not_in_eni::kClocks,
                          .expert = true},
                         [](auto& p, const Place&) -> auto& { return bus_dc(p).delay_difference; }),
                     usual_difference),
  };
}

std::vector<Setting> loop_rows() {
  const auto usual_depth = [](const Project&, const Place&) { return Value{std::int64_t{8}}; };
  return {
      field_setting(
          "master.dc.loop.speed_counter_start", integer(0x0080, 0x3FFF),
          {.label = "Speed counter start",
           .help = "Start value of the slaves' time control loops (0x0930): small ones follow faster, large ones "
                   "smoother; auto suits the cycle.",
           .object = "0x0930",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return loop(p).speed_counter_start; }),
      field_setting(
          "master.dc.loop.filter_depth_difference", integer(0, limits::kLargestFilterDepth),
          {.label = "Filter depth, difference",
           .help = "Exponent of the average over the time differences (0x0934); auto is 0, and 4 to 6 "
                   "in front of the reference clock.",
           .object = "0x0934",
           .no_eni = not_in_eni::kClocks,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return loop(p).filter_depth_difference; }),
      with_automatic(field_setting(
                         "master.dc.loop.filter_depth_speed_counter", integer(0, limits::kLargestFilterDepth),
                         {.label = "Filter depth, speed counter",
                          .help = "Exponent of the average over the clock period deviation (0x0935); auto is 8.",
                          .object = "0x0935",
                          .no_eni = not_in_eni::kClocks,
                          .expert = true},
                         [](auto& p, const Place&) -> auto& { return loop(p).filter_depth_speed_counter; }),
                     usual_depth),
  };
}

std::vector<Setting> notification_rows() {
  const auto row = [](const char* name, const char* label, const char* help, bool DcNotificationSettings::*field) {
    return field_setting(
        fmt::format("master.dc.notify.{}", name), Switch{},
        {.label = label, .help = help, .no_eni = not_in_eni::kTold, .expert = true},
        [field](auto& p, const Place&) -> auto& { return notifications(p).*field; });
  };
  return {
      row("reference_clock", "Tell of the reference clock", "Tells presence and loss of the reference clock.",
          &DcNotificationSettings::reference_clock),
      row("slaves_in_sync", "Tell of slaves in sync", "Tells when the slaves come in sync and fall out of it.",
          &DcNotificationSettings::slaves_in_sync),
      row("dc_status", "Tell of the clocks' state", "Tells that the distributed clocks are initialised, or why not.",
          &DcNotificationSettings::dc_status),
      row("dcm_in_sync", "Tell of the master in sync", "Tells when the master comes in sync and falls out of it.",
          &DcNotificationSettings::dcm_in_sync),
  };
}

}  // namespace

std::vector<Setting> dc_rows() {
  auto rows = clock_rows();
  for (auto part : {window_rows(), start_rows(), choice_rows(), loop_rows(), notification_rows()})
    append(rows, std::move(part));
  return rows;
}

}  // namespace syncline::settings
