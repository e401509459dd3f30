// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "config/sync0_cycle.h"
#include "config/sync_unit_cycle.h"
#include "protocol/assign_activate.h"
#include "reasons/because.h"
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/predicates.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr std::string_view kOff = "off";

std::vector<Option> op_modes(const Project& project, const Place& place) {
  std::vector<Option> options{{std::string(), std::string(kOff), "Off (no DC commands)"}};
  const auto& dc = at_slave(project, place).device.dc;
  if (!dc) return options;
  for (const DcOpMode& mode : dc->op_modes) options.push_back({mode.name, mode.name, mode.name});
  return options;
}

std::string mode_names(const SlaveSettings& slave) {
  std::string names(kOff);
  if (!slave.device.dc) return names + " (the device has no distributed clocks)";
  for (const DcOpMode& mode : slave.device.dc->op_modes) names += ", " + mode.name;
  return names;
}

/// The name of a mode wins over the word for none.
Result<Value> parse_mode(const SlaveSettings& slave, std::string_view text) {
  const bool known = text == slave.dc.op_mode ||
                     (slave.device.dc && std::ranges::any_of(slave.device.dc->op_modes,
                                                             [text](const DcOpMode& m) { return m.name == text; }));
  if (known) return Value{std::string(text)};
  if (text == kOff) return Value{std::string()};
  return bad_value(because("\"{text}\" is none of {words}", text, mode_names(slave)));
}

Setting op_mode_row() {
  Setting row{
      .key = "slave.N.dc.op_mode",
      .type = Choice{},
      .words = {.label = "Mode",
                .help = "Operation mode of distributed clocks; where the ESI gives a mode its own PDOs, they are "
                        "assigned too.",
                .object = "0x0980",
                .eni = "Slave/DC",
                .preset = "the first of the ESI"},
      .read = {},
      .write = {}};
  row.type_words = "operation mode";
  row.range_words = "off, a name of the ESI's OpMode";
  row.options = op_modes;
  row.parse = [](const Project& project, const Place& place, std::string_view text) {
    return parse_mode(at_slave(project, place), text);
  };
  row.format = [](const Project&, const Place&, const Value& value) {
    const auto& mode = std::get<std::string>(value);
    return mode.empty() ? std::string(kOff) : mode;
  };
  row.read = [](const Project& project, const Place& place) -> Value { return at_slave(project, place).dc.op_mode; };
  row.write = [](Project& project, const Place& place, const Value& value) -> Status {
    auto& slave = at_slave(project, place);
    const auto* mode = std::get_if<std::string>(&value);
    if (mode == nullptr) return bad_value(because("it is the name of an operation mode"));
    if (*mode != slave.dc.op_mode) select_op_mode(slave, *mode);
    return {};
  };
  return row;
}

/// A unit that the operation mode does not generate has neither cycle nor shift.
bool generates(const DcOpMode& mode, int unit) {
  const AssignActivate activate{mode.assign_activate};
  return unit == 0 ? activate.sync0() : activate.sync1();
}

/// What the operation mode says of a SYNC unit for which nothing is set.
Value shift_of_mode(const Project& project, const Place& place, int unit) {
  const auto& slave = at_slave(project, place);
  const auto* mode = compiler::selected_op_mode(slave);
  if (mode == nullptr || !generates(*mode, unit)) return {};
  return Value{compiler::shift_of_mode(unit == 0 ? mode->shift_time_sync0 : mode->shift_time_sync1,
                                       compiler::sync_unit_cycle(project.master, slave))};
}

/// With the factor that the user chose, or as the mode says.
Value cycle_of_mode(const Project& project, const Place& place, int unit) {
  const auto& slave = at_slave(project, place);
  const auto* mode = compiler::selected_op_mode(slave);
  if (mode == nullptr || !generates(*mode, unit)) return {};
  return Value{compiler::sync_cycle(*mode, slave.dc, unit, compiler::sync_unit_cycle(project.master, slave))};
}

std::vector<Setting> unit_rows(int unit, const char* register_text, const char* shift_register,
                               SyncUnitSettings DcSlaveSettings::*part) {
  const auto name = fmt::format("dc.sync{}", unit), upper = fmt::format("SYNC{}", unit);
  const std::string eni = unit == 0 ? "Slave/DC/CycleTime0" : "Slave/DC/CycleTime1";
  constexpr Number kFactor{.range = {-limits::kLargestMultiple, limits::kLargestMultiple}, .without_zero = true};
  return {
      slave_setting(
          name + ".factor", kFactor,
          {.label = "Sync Unit Cycle of " + upper,
           .help = "Sync Unit Cycle of " + upper +
                   ": above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI.",
           .object = register_text,
           .eni = eni},
          [part](auto& slave) -> auto& { return (slave.dc.*part).cycle_factor; }),
      with_automatic(slave_setting(
                         name + ".cycle_us", microseconds(1, limits::kLargestSyncTime),
                         {.label = "Cycle of " + upper,
                          .help = "Cycle of " + upper + " (" + register_text + "), before the factor.",
                          .object = register_text,
                          .eni = eni},
                         [part](auto& slave) -> auto& { return (slave.dc.*part).user_cycle; }),
                     [unit](const Project& p, const Place& place) { return cycle_of_mode(p, place, unit); }),
      with_automatic(slave_setting(
                         name + ".shift_us", microseconds(-limits::kLargestSyncTime, limits::kLargestSyncTime),
                         {.label = "Shift of " + upper,
                          .help = "Shift of " + upper + "; auto as in the ESI.",
                          .object = shift_register,
                          .eni = unit == 0 ? "Slave/DC/ShiftTime" : "Slave/DC/CycleTime1"},
                         [part](auto& slave) -> auto& { return (slave.dc.*part).shift; }),
                     [unit](const Project& p, const Place& place) { return shift_of_mode(p, place, unit); }),
  };
}

}  // namespace

std::vector<Setting> slave_dc_rows() {
  std::vector<Setting> rows{op_mode_row()};
  append(rows, unit_rows(0, "0x09A0", "0x0990", &DcSlaveSettings::sync0));
  append(rows, unit_rows(1, "0x09A4", "0x09A4", &DcSlaveSettings::sync1));
  rows.push_back(with_automatic(
      slave_setting(
          "dc.sync0.input_reference", Switch{},
          {.label = "Input reference",
           .help =
               "The input shift of the master is added to the shift of SYNC0, so that inputs are latched for the next "
               "frame; auto as in the ESI.",
           .object = "0x0990",
           .eni = "Slave/DC/ShiftTime",
           .expert = true},
          [](auto& slave) -> auto& { return slave.dc.input_reference; }),
      [](const Project& project, const Place& place) -> Value {
        const auto& slave = at_slave(project, place);
        const auto* mode = compiler::selected_op_mode(slave);
        return mode != nullptr && generates(*mode, 0) ? Value{mode->shift_time_sync0.input} : Value{};
      }));
  rows.push_back(slave_setting(
      "dc.potential_reference_clock", Switch{},
      {.label = "Potential reference clock",
       .help = "Marks the slave as a possible reference clock in the ENI.",
       .eni = "Slave/DC/PotentialReferenceClock"},
      [](auto& slave) -> auto& { return slave.dc.potential_reference_clock; }));
  return for_devices(std::move(rows), has_clock);
}

}  // namespace syncline::settings
