// SPDX-License-Identifier: Apache-2.0
#include "settings/sync_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/slave_settings.h"
#include "families/device_family.h"
#include "families/families.h"
#include "reasons/because.h"
#include "settings/limits.h"

namespace syncline {
namespace {

Status bad(const char* key, Reason detail) { return fail(ErrorCode::kBadValue, key, std::move(detail)); }

std::string devices(const families::Family& family) { return fmt::format("{} {}", family.name, family.devices); }

Status check_error_limit(const SlaveSettings& slave, const families::Family* family) {
  if (!slave.sync.error_limit || family == nullptr || !family->error_limit) return {};
  const auto largest = family->error_limit->largest;
  if (*slave.sync.error_limit <= largest) return {};
  return bad("sync.error_limit", because("{value} is more than {devices} take: 0 to {most}", *slave.sync.error_limit,
                                         devices(*family), largest));
}

Status check_type(const SlaveSettings& slave, const families::Family* family) {
  if (!slave.sync.type || family == nullptr || family->sync_types.outputs.empty()) return {};
  const auto& types = family->sync_types;
  if (!types.writable)
    return bad("sync.type", because("{devices} set it themselves by the SYNC signals", devices(*family)));
  for (const PdoDirection direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    const auto taken = direction == PdoDirection::kRx ? types.outputs : types.inputs;
    const auto value = sync_type_value(*slave.sync.type, direction, true);
    if (std::ranges::find(taken, value) == taken.end()) {
      return bad("sync.type",
                 because("{devices} do not have {type}", devices(*family), sync_type_name(*slave.sync.type)));
    }
  }
  return {};
}

Status check_can(const SlaveSettings& slave, const families::Family* family) {
  if (slave.can == CanSettings{}) return {};
  const char* key = slave.can.cycle ? "can.cycle_us" : "can.tx_delay_percent";
  if (family == nullptr || !family->gateway) return bad(key, because("the device is no CAN gateway that is known"));
  if (slave.can.cycle && (*slave.can.cycle < 0 || *slave.can.cycle > limits::kLargestTime32)) {
    return bad(key, because("{time} ns do not fit into 32 bits", *slave.can.cycle));
  }
  if (slave.can.tx_delay_percent.value_or(0) > limits::kWholePercent) {
    return bad("can.tx_delay_percent", because("{percent} is more than 100 %", *slave.can.tx_delay_percent));
  }
  return {};
}

Status check_pins(const SlaveSettings& slave, const families::Family* family) {
  for (const OutputPin& pin : slave.output_pins) {
    const auto key = fmt::format("output_pin.{}", pin.pin);
    if (family == nullptr || !family->pins)
      return bad(key.c_str(), because("the device has no output pins that are known"));
    const auto& pins = *family->pins;
    if (pin.pin < 1 || pin.pin > pins.pins)
      return bad(key.c_str(), because("{devices} have pins 1 to {last}", devices(*family), pins.pins));
    if (std::ranges::find(pins.functions, pin.function, &families::PinFunction::value) == pins.functions.end()) {
      return bad(key.c_str(), because("{devices} have no function {number}", devices(*family), pin.function));
    }
  }
  return {};
}

}  // namespace

std::uint16_t sync_type_value(SyncTypeChoice type, PdoDirection direction, bool has_outputs) {
  constexpr std::uint16_t kOwnEvent = 1, kSync0 = 2, kSync1 = 3, kSm2Event = 0x22;
  switch (type) {
    case SyncTypeChoice::kFreeRun:
      return 0;
    case SyncTypeChoice::kSmEvent:
      return direction == PdoDirection::kTx && has_outputs ? kSm2Event : kOwnEvent;
    case SyncTypeChoice::kSync0:
      return kSync0;
    case SyncTypeChoice::kSync1:
      return kSync1;
  }
  return 0;
}

Status check_sync_settings(const SlaveSettings& slave) {
  const bool any = !(slave.sync == SyncSettings{}) || !(slave.can == CanSettings{}) || !slave.output_pins.empty();
  if (!any) return {};
  if (!slave.device.mailbox || !slave.device.mailbox->coe) {
    const char* key = slave.sync.error_limit ? "sync.error_limit"
                      : slave.sync.type      ? "sync.type"
                                             : "sync.input_shift_us";
    return bad(key, because("the device has no CoE mailbox through which objects could be written"));
  }
  const auto* family = families::find(slave.device);
  for (const auto check : {check_error_limit, check_type, check_can, check_pins}) {
    if (auto status = check(slave, family); !status) return status;
  }
  if (slave.sync.input_shift && (*slave.sync.input_shift < 0 || *slave.sync.input_shift > limits::kLargestTime32)) {
    return bad("sync.input_shift_us", because("{time} ns do not fit into 32 bits", *slave.sync.input_shift));
  }
  return {};
}

}  // namespace syncline
