// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/predicted_step.h"

#include <cmath>

#include "config/dcm_settings.h"
#include "dc/dcm/dcm_controller.h"

namespace syncline::dc {
namespace {

constexpr std::size_t kSettled =
    2'000;  // cycles before the step: the tracker's gains are those of the settings by then

}  // namespace

std::vector<double> predicted_step(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds step,
                                   std::size_t cycles) {
  std::vector<double> errors;
  const auto effective = effective_dcm_settings(settings);
  if (cycle_time <= 0 || effective.control_off || effective.mode != DcmMode::kMasterShift) return errors;
  const auto set_value = cycle_time / 2;
  const auto controller = make_dcm_controller(settings, cycle_time, set_value);
  // The reference clock shows the host's time, and the schedule begins where it belongs.
  Nanoseconds schedule = 1'000 * cycle_time - set_value;
  controller->start(0, schedule, schedule);
  errors.reserve(cycles);
  Nanoseconds offset = 0;
  for (std::size_t i = 0; i < kSettled + cycles; ++i) {
    if (i == kSettled) offset = step;
    const auto action = controller->observe({schedule, schedule, schedule + offset});
    if (i >= kSettled) errors.push_back(static_cast<double>(controller->state().error));
    schedule += cycle_time + action.period_adjust;
  }
  return errors;
}

}  // namespace syncline::dc
