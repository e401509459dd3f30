// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcm_controller.h"

#include <type_traits>

#include "config/dcm_settings.h"
#include "dc/dcm/bus_shift.h"
#include "dc/dcm/dcx.h"
#include "dc/dcm/master_shift.h"
#include "dc/dcm/written_clock.h"

namespace syncline::dc {
namespace {

/// Nothing is controlled; the error is still shown, as the natural drift.
class Off final : public DcmController {
 public:
  Off(Nanoseconds cycle_time, Nanoseconds set_value) : target_{0, set_value, cycle_time} {}
  void start(Nanoseconds base, Nanoseconds, Nanoseconds) override {
    target_.base = base;
    drift_.start();
    state_ = {};
  }
  std::optional<Nanoseconds> reference_write(Nanoseconds, Nanoseconds) override { return std::nullopt; }
  DcmAction observe(const DcmObservation& observation) override {
    if (!observation.reference_time) return {};
    state_.error = state_.error_filtered = target_.error(observation);
    (void)drift_.observe(observation.send_time, *observation.reference_time);
    state_.drift_ppm = drift_.ppm();
    state_.drift_half_width_ppm = drift_.half_width_ppm();
    return {};
  }
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  PhaseTarget target_;
  DriftEstimator drift_;
  DcmState state_;
};

}  // namespace

std::unique_ptr<DcmController> make_dcm_controller(const DcmSettings& settings, Nanoseconds cycle_time,
                                                   Nanoseconds set_value, Nanoseconds least_set_value) {
  const auto effective = effective_dcm_settings(settings);
  const auto make = [&]<class Controller>(std::type_identity<Controller>) {
    return std::make_unique<Controller>(effective, cycle_time, set_value, least_set_value);
  };
  const auto written = [&](WrittenClock::Time time) {
    return std::make_unique<WrittenClock>(time, effective, cycle_time, set_value, least_set_value);
  };
  // Where nothing is moved there is one thing to show in all modes: the natural drift, and what the timer would need.
  const bool observes = settings.control_off && settings.mode != DcmMode::kOff && settings.mode != DcmMode::kDcx;
  if (observes) return make(std::type_identity<MasterShift>{});
  switch (settings.mode) {
    case DcmMode::kBusShift:
      return make(std::type_identity<BusShift>{});
    case DcmMode::kMasterShift:
    case DcmMode::kMasterShiftByApp:
      return make(std::type_identity<MasterShift>{});
    case DcmMode::kMasterRefClock:
      return written(WrittenClock::Time::kNominal);
    case DcmMode::kLinkLayerRefClock:
      return written(WrittenClock::Time::kOfSending);
    case DcmMode::kDcx:
      return make(std::type_identity<Dcx>{});
    case DcmMode::kOff:
      break;
  }
  return std::make_unique<Off>(cycle_time, set_value);
}

}  // namespace syncline::dc
