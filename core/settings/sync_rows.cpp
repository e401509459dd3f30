// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "families/device_family.h"
#include "families/families.h"
#include "reasons/because.h"
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/predicates.h"
#include "settings/sync_settings.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

Choice sync_types() {
  Choice choice;
  constexpr std::pair<SyncTypeChoice, const char*> kTypes[] = {{SyncTypeChoice::kFreeRun, "Free run"},
                                                               {SyncTypeChoice::kSmEvent, "SM event"},
                                                               {SyncTypeChoice::kSync0, "SYNC0"},
                                                               {SyncTypeChoice::kSync1, "SYNC1"}};
  for (const auto& [type, text] : kTypes) {
    choice.options.push_back({static_cast<std::int64_t>(type), std::string(sync_type_name(type)), text});
  }
  return choice;
}

/// What the type lets through must suit the device, too.
Setting checked(Setting row) {
  row.write = [write = std::move(row.write)](Project& project, const Place& place, const Value& value) -> Status {
    auto& slave = at_slave(project, place);
    const auto sync = slave.sync;
    const auto can = slave.can;
    auto status = write(project, place, value);
    if (status) status = check_sync_settings(slave);
    if (!status) {
      slave.sync = sync;
      slave.can = can;
    }
    return status;
  };
  return row;
}

/// Those that the device takes.
std::vector<Option> sync_types_of(const Project& project, const Place& place) {
  std::vector<Option> options{{Unset{}, "auto", "As operation mode"}};
  auto asked = at_slave(project, place);
  asked.sync = {};
  for (auto& option : sync_types().options) {
    asked.sync.type = static_cast<SyncTypeChoice>(std::get<std::int64_t>(option.value));
    if (check_sync_settings(asked)) options.push_back(std::move(option));
  }
  return options;
}

Range error_limits(const Project& project, const Place& place) {
  const auto* family = families::find(at_slave(project, place).device);
  const bool known = family != nullptr && family->error_limit;
  return {0, known ? family->error_limit->largest : limits::kLargestWord};
}

Value usual_error_limit(const Project& project, const Place& place) {
  const auto* family = families::find(at_slave(project, place).device);
  return family != nullptr && family->error_limit ? to_value(family->error_limit->usual) : Value{};
}

const families::PinObject* pins_of(const SlaveSettings& slave) {
  const auto* family = families::find(slave.device);
  return family != nullptr && family->pins ? &*family->pins : nullptr;
}

std::string pin_words(const families::PinObject& pins) {
  std::string words = "auto";
  for (const auto& function : pins.functions) words += fmt::format(", {}", function.word);
  return words;
}

Status set_pin(SlaveSettings& slave, std::uint32_t number, std::string_view text) {
  const auto* pins = pins_of(slave);
  if (pins == nullptr) return bad_value(because("the device has no output pins that are known"));
  const auto function = std::ranges::find(pins->functions, text, &families::PinFunction::word);
  if (function == pins->functions.end() && text != "auto") {
    return bad_value(because("\"{text}\" is none of {words}", text, pin_words(*pins)));
  }
  std::erase_if(slave.output_pins, [number](const OutputPin& pin) { return pin.pin == number; });
  if (function == pins->functions.end()) return {};
  const auto place =
      std::ranges::find_if(slave.output_pins, [number](const OutputPin& pin) { return pin.pin > number; });
  slave.output_pins.insert(place, {static_cast<std::uint8_t>(number), function->value});
  return {};
}

Setting pin_row() {
  Setting row{
      .key = "slave.N.output_pin.K",
      .type = Choice{},
      .words = {.label = "Output pin",
                .help = "What output pin K (from 1) of a drive shows on an oscilloscope (Copley 0x2193); auto leaves "
                        "it alone.",
                .object = "0x2193",
                .eni = "Mailbox/CoE/InitCmds",
                .expert = true},
      .read = {},
      .write = {}};
  row.range_words = "auto, words of the device family: nothing, sync0, frames, servo-period";
  row.unset = "auto";
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& slave = at_slave(project, place);
    const auto pin = std::ranges::find(slave.output_pins, place.item, &OutputPin::pin);
    const auto* pins = pins_of(slave);
    if (pin == slave.output_pins.end() || pins == nullptr) return {};
    const auto function = std::ranges::find(pins->functions, pin->function, &families::PinFunction::value);
    return function == pins->functions.end() ? Value{} : Value{std::string(function->word)};
  };
  row.parse = [](const Project&, const Place&, std::string_view text) -> Result<Value> { return std::string(text); };
  row.write = [](Project& project, const Place& place, const Value& value) {
    const auto* word = std::get_if<std::string>(&value);
    return set_pin(at_slave(project, place), place.item, word != nullptr ? *word : std::string_view("auto"));
  };
  row.options = [](const Project& project, const Place& place) {
    std::vector<Option> options{{Unset{}, "auto", {}}};
    const auto* pins = pins_of(at_slave(project, place));
    if (pins == nullptr) return options;
    for (const auto& function : pins->functions)
      options.push_back({std::string(function.word), std::string(function.word), {}});
    return options;
  };
  row.items = [](const Project& project, std::size_t slave) {
    std::vector<Place> places;
    const auto* pins = pins_of(project.slaves[slave]);
    for (std::uint32_t pin = 1; pins != nullptr && pin <= pins->pins; ++pin) places.push_back({slave, pin, 0});
    return places;
  };
  return row;
}

std::vector<Setting> device_rows() {
  auto limit = slave_setting(
      "sync.error_limit", integer(0, limits::kLargestWord),
      {.label = "Error limit",
       .help = "Error counter (3 more for a missed SM event, 1 less for a good one) at which the device "
               "gives up (0x10F1:02); 0 never, auto leaves the device's default.",
       .object = "0x10F1:02",
       .eni = "Mailbox/CoE/InitCmds"},
      [](auto& slave) -> auto& { return slave.sync.error_limit; });
  limit.works = error_limits;
  limit.automatic = usual_error_limit;
  auto type = slave_setting(
      "sync.type", sync_types(),
      {.label = "Type",
       .help = "What starts the device's cycle (0x1C32:01 and 0x1C33:01); auto as the operation mode "
               "says.",
       .object = "0x1C32:01, 0x1C33:01",
       .eni = "Mailbox/CoE/InitCmds"},
      [](auto& slave) -> auto& { return slave.sync.type; });
  type.options = sync_types_of;
  return {
      checked(std::move(limit)),
      checked(std::move(type)),
      checked(slave_setting(
          "sync.input_shift_us", microseconds(0, limits::kLargestTime32),
          {.label = "Input shift",
           .help = "From the trigger to latching the inputs (0x1C33:03); auto as the operation mode says.",
           .object = "0x1C33:03",
           .eni = "Mailbox/CoE/InitCmds",
           .expert = true},
          [](auto& slave) -> auto& { return slave.sync.input_shift; })),
  };
}

std::vector<Setting> gateway_rows() {
  return {
      checked(slave_setting(
          "can.cycle_us", microseconds(0, limits::kLargestTime32),
          {.label = "CAN cycle",
           .help = "CAN cycle of a gateway (EL6751 0xF800:04), a multiple of the bus cycle; without SYNC0 "
                   "the gateway is told the bus cycle, too. 0 is one CAN cycle a bus cycle, auto leaves "
                   "the device's default.",
           .object = "0xF800:04",
           .eni = "Mailbox/CoE/InitCmds"},
          [](auto& slave) -> auto& { return slave.can.cycle; })),
      checked(slave_setting(
          "can.tx_delay_percent", integer(0, limits::kWholePercent, "%"),
          {.label = "TxPDO delay",
           .help = "From the CAN SYNC message of a gateway to its first synchronous RxPDO (EL6751 "
                   "0xF800:0E), in % of the CAN cycle.",
           .object = "0xF800:0E",
           .eni = "Mailbox/CoE/InitCmds"},
          [](auto& slave) -> auto& { return slave.can.tx_delay_percent; })),
  };
}

}  // namespace

std::vector<Setting> sync_rows() {
  auto rows = for_devices(device_rows(), has_coe);
  append(rows, for_devices(gateway_rows(), is_gateway));
  rows.push_back(pin_row());
  return rows;
}

}  // namespace syncline::settings
