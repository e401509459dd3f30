// SPDX-License-Identifier: Apache-2.0
#include "config/dcm_settings.h"

#include <fmt/format.h>

namespace syncline {
namespace {

struct DcmModeName {
  DcmMode mode;
  std::string_view name;
};
constexpr DcmModeName kDcmModes[] = {{DcmMode::kOff, "off"},
                                     {DcmMode::kBusShift, "bus-shift"},
                                     {DcmMode::kMasterShift, "master-shift"},
                                     {DcmMode::kMasterRefClock, "master-ref-clock"},
                                     {DcmMode::kLinkLayerRefClock, "link-layer-ref-clock"},
                                     {DcmMode::kDcx, "dcx"},
                                     {DcmMode::kMasterShiftByApp, "master-shift-by-app"}};

template <class T>
void keep_if_zero(T& value, T current) {
  if (value == 0) value = current;
}

Status in_range(std::string_view key, std::int64_t value, std::int64_t min, std::int64_t max, std::string_view unit) {
  if (value >= min && value <= max) return {};
  return fail(ErrorCode::kBadValue, std::string(key), fmt::format("{} {} is outside {}..{} {}", value, unit, min, max, unit));
}

}  // namespace

std::string_view dcm_mode_name(DcmMode mode) {
  for (const auto& known : kDcmModes) {
    if (known.mode == mode) return known.name;
  }
  return {};
}

std::optional<DcmMode> dcm_mode_from_name(std::string_view name) {
  for (const auto& known : kDcmModes) {
    if (known.name == name) return known.mode;
  }
  return std::nullopt;
}

DcmSettings merge_dcm_settings(const DcmSettings& current, DcmSettings change) {
  keep_if_zero(change.gain_ppt, current.gain_ppt);
  keep_if_zero(change.drift_error_gain, current.drift_error_gain);
  keep_if_zero(change.max_valid_value, current.max_valid_value);
  keep_if_zero(change.in_sync_limit, current.in_sync_limit);
  keep_if_zero(change.in_sync_settle_time_ms, current.in_sync_settle_time_ms);
  return change;
}

DcmSettings effective_dcm_settings(const DcmSettings& settings) { return merge_dcm_settings(DcmSettings{}, settings); }

Nanoseconds effective_set_value(const DcmSettings& settings, Nanoseconds cycle_time) {
  return settings.set_value.value_or(cycle_time * 2 / 3);
}

Status check_dcm_settings(const DcmSettings& settings, Nanoseconds cycle_time) {
  const auto check = [](std::initializer_list<Status> results) -> Status {
    for (const auto& result : results) {
      if (!result) return result;
    }
    return {};
  };
  return check({
      in_range("master.dc.set_value_us", effective_set_value(settings, cycle_time), 1, cycle_time - 1, "ns"),
      in_range("master.dc.gain_ppt", settings.gain_ppt, 0, DcmSettings::kMaxGain, "ppt"),
      in_range("master.dc.drift_error_gain", settings.drift_error_gain, 0, DcmSettings::kMaxDriftErrorGain, "times"),
      in_range("master.dc.max_valid_ns", settings.max_valid_value, 0, kSecond, "ns"),
      in_range("master.dc.in_sync_limit_ns", settings.in_sync_limit, 0, kSecond, "ns"),
      in_range("master.dc.in_sync_settle_ms", settings.in_sync_settle_time_ms, 0, 60'000, "ms"),
      in_range("master.dc.start_delay_ms", settings.start_delay_ms, 0, 600'000, "ms"),
  });
}

}  // namespace syncline
