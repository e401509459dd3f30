// SPDX-License-Identifier: Apache-2.0
#include "bench/plain_dcm.h"

#include <algorithm>
#include <cmath>

#include "dc/clock_registers.h"

namespace syncline::bench {
namespace {

class PlainMasterShift final : public dc::DcmController {
 public:
  PlainMasterShift(Nanoseconds cycle, Nanoseconds set_value) : cycle_(cycle), set_value_(set_value) {}
  void start(Nanoseconds base, Nanoseconds, Nanoseconds) override { base_ = base; }
  std::optional<Nanoseconds> reference_write(Nanoseconds, Nanoseconds) override { return std::nullopt; }
  dc::DcmAction observe(const dc::DcmObservation& observation) override {
    if (observation.reference_time) {
      const auto error =
          static_cast<double>(dc::wrap_to_half(*observation.reference_time - (base_ - set_value_), cycle_));
      const auto cycle = static_cast<double>(cycle_);
      output_ = std::clamp(-(0.01 * error + integral_), -0.02 * cycle, 0.02 * cycle);
      integral_ = std::clamp(integral_ + 2e-5 * error, -600e-6 * cycle, 600e-6 * cycle);
    }
    state_.adjust = std::llround(output_);
    return {state_.adjust, {}};
  }
  [[nodiscard]] const dc::DcmState& state() const override { return state_; }

 private:
  Nanoseconds cycle_, set_value_, base_ = 0;
  double integral_ = 0, output_ = 0;
  dc::DcmState state_;
};

class PlainBusShift final : public dc::DcmController {
 public:
  PlainBusShift(Nanoseconds cycle, Nanoseconds set_value) : cycle_(cycle), set_value_(set_value) {}
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds) override {
    base_ = base;
    predicted_ = first_reference_time;
  }
  std::optional<Nanoseconds> reference_write(Nanoseconds, Nanoseconds) override {
    return predicted_ - std::llround(correction_);
  }
  dc::DcmAction observe(const dc::DcmObservation& observation) override {
    if (!observation.reference_time) {
      predicted_ += cycle_;
      return {};
    }
    const auto error =
        static_cast<double>(dc::wrap_to_half(*observation.reference_time - (base_ - set_value_), cycle_));
    filtered_ += 0.05 * (error - filtered_);
    correction_ = std::clamp(0.02 * filtered_, -20e3, 20e3) + integral_;
    integral_ += 1e-4 * filtered_;
    predicted_ = *observation.reference_time + cycle_;
    return {};
  }
  [[nodiscard]] const dc::DcmState& state() const override { return state_; }

 private:
  Nanoseconds cycle_, set_value_, base_ = 0, predicted_ = 0;
  double filtered_ = 0, integral_ = 0, correction_ = 0;
  dc::DcmState state_;
};

}  // namespace

std::unique_ptr<dc::DcmController> make_plain_controller(DcmMode mode, Nanoseconds cycle, Nanoseconds set_value) {
  if (steers_reference_clock(mode)) return std::make_unique<PlainBusShift>(cycle, set_value);
  return std::make_unique<PlainMasterShift>(cycle, set_value);
}

}  // namespace syncline::bench
