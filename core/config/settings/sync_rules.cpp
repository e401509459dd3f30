// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/families/families.h"
#include "config/settings/codecs.h"
#include "config/sync_settings.h"

namespace syncline::settings {
namespace {

constexpr Nanoseconds kLongest = 0xFFFF'FFFF;  // 32 bits of nanoseconds

constexpr auto at = [](auto& project, const Place& place) -> auto& { return project.slaves[place.slave]; };

struct SyncTypeCodec {
  using Value = SyncTypeChoice;
  [[nodiscard]] static std::string type() { return "choice"; }
  [[nodiscard]] static std::string range() { return "free-run, sm-event, sync0, sync1"; }
  [[nodiscard]] static std::string format(Value value) { return std::string(sync_type_name(value)); }
  [[nodiscard]] static Result<Value> parse(std::string_view text) {
    if (const auto type = sync_type_from_name(text)) return *type;
    return bad_value(fmt::format("\"{}\" is none of {}", text, range()));
  }
};

/// What the codec lets through must suit the device, too.
Rule checked(Rule rule) {
  rule.set = [set = std::move(rule.set)](Project& project, const Place& place, std::string_view text) -> Status {
    auto& slave = at(project, place);
    const auto sync = slave.sync;
    const auto can = slave.can;
    auto status = set(project, place, text);
    if (status) status = check_sync_settings(slave);
    if (!status) {
      slave.sync = sync;
      slave.can = can;
    }
    return status;
  };
  return rule;
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
  if (pins == nullptr) return bad_value("the device has no output pins that are known");
  const auto function = std::ranges::find(pins->functions, text, &families::PinFunction::word);
  if (function == pins->functions.end() && text != "auto") {
    return bad_value(fmt::format("\"{}\" is none of {}", text, pin_words(*pins)));
  }
  std::erase_if(slave.output_pins, [number](const OutputPin& pin) { return pin.pin == number; });
  if (function == pins->functions.end()) return {};
  const auto place =
      std::ranges::find_if(slave.output_pins, [number](const OutputPin& pin) { return pin.pin > number; });
  slave.output_pins.insert(place, {static_cast<std::uint8_t>(number), function->value});
  return {};
}

Rule pin_rule() {
  Rule rule{.key = "slave.N.output_pin.K",
            .type = "choice",
            .range = "auto, words of the device family: nothing, sync0, frames, servo-period",
            .meaning =
                "What output pin K (from 1) of a drive shows on an oscilloscope (Copley 0x2193); auto leaves it alone.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) {
    const auto& slave = at(project, place);
    const auto pin = std::ranges::find(slave.output_pins, place.item, &OutputPin::pin);
    const auto* pins = pins_of(slave);
    if (pin == slave.output_pins.end() || pins == nullptr) return std::string("auto");
    const auto function = std::ranges::find(pins->functions, pin->function, &families::PinFunction::value);
    return function == pins->functions.end() ? std::string("auto") : std::string(function->word);
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) {
    return set_pin(at(project, place), place.item, text);
  };
  rule.items = [](const Project& project, std::size_t slave) {
    std::vector<Place> places;
    const auto* pins = pins_of(project.slaves[slave]);
    for (std::uint32_t pin = 1; pins != nullptr && pin <= pins->pins; ++pin) places.push_back({slave, pin, 0});
    return places;
  };
  return rule;
}

}  // namespace

std::vector<Rule> sync_rules() {
  return {
      checked(field_rule(
          "slave.N.sync.error_limit",
          "Error counter (3 more for a missed SM event, 1 less for a good one) at which the device gives up "
          "(0x10F1:02); 0 never, auto leaves the device's default.",
          AutoCodec<IntegerCodec<std::uint16_t>>{{0, 0xFFFF}},
          [](auto& p, const Place& place) -> auto& { return at(p, place).sync.error_limit; })),
      checked(field_rule(
          "slave.N.sync.type",
          "What starts the device's cycle (0x1C32:01 and 0x1C33:01); auto as the operation mode says.",
          AutoCodec<SyncTypeCodec>{}, [](auto& p, const Place& place) -> auto& { return at(p, place).sync.type; })),
      checked(field_rule(
          "slave.N.sync.input_shift_us",
          "From the trigger to latching the inputs (0x1C33:03); auto as the operation mode says.",
          AutoCodec<MicrosecondCodec>{{0, kLongest}},
          [](auto& p, const Place& place) -> auto& { return at(p, place).sync.input_shift; })),
      checked(field_rule(
          "slave.N.can.cycle_us",
          "CAN cycle of a gateway (EL6751 0xF800:04), a multiple of the bus cycle; without SYNC0 the gateway is "
          "told the bus cycle, too. 0 is one CAN cycle a bus cycle, auto leaves the device's default.",
          AutoCodec<MicrosecondCodec>{{0, kLongest}},
          [](auto& p, const Place& place) -> auto& { return at(p, place).can.cycle; })),
      checked(field_rule(
          "slave.N.can.tx_delay_percent",
          "From the CAN SYNC message of a gateway to its first synchronous RxPDO (EL6751 0xF800:0E), in % of the "
          "CAN cycle.",
          AutoCodec<IntegerCodec<std::uint8_t>>{{0, 100, "%"}},
          [](auto& p, const Place& place) -> auto& { return at(p, place).can.tx_delay_percent; })),
      pin_rule(),
  };
}

}  // namespace syncline::settings
