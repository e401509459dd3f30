// SPDX-License-Identifier: Apache-2.0
#include "config/dcm_settings.h"

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

Nanoseconds effective_set_value(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds outputs_there) {
  if (settings.set_value) return *settings.set_value;
  const auto usual = cycle_time * 2 / 3;
  const bool tight = outputs_there > usual - cycle_time / 10 && outputs_there < cycle_time;
  return tight ? (outputs_there + cycle_time) / 2 : usual;
}

}  // namespace syncline
