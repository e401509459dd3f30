// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/delay_compensation.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "channels/snapshot.h"
#include "config/dc_settings.h"
#include "config/network_config.h"
#include "master/clocks/clock_segment.h"
#include "master/clocks/clock_survey.h"
#include "master/clocks/dc_setup.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/slave_states.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// A round is a latch and the reading of all slaves; datagrams that found no room ride with the next cycles.
constexpr unsigned kRoundPatience = 200;
constexpr unsigned kMostFailedRounds = 5;

}  // namespace

void DelayCompensation::use(std::vector<std::size_t> slaves, const ClockSegment& segment, std::uint16_t leader) {
  const auto& config = config_;
  slaves_ = std::move(slaves);
  wiring_ = segment.wiring;
  whole_ = segment.whole;
  reference_clock_ = leader;
  std::vector<SlaveAddress> addresses;
  for (const auto slave : slaves_) addresses.push_back(SlaveAddress::at_station(config.slaves[slave].station_address));
  latch_ = std::make_unique<DelayLatch>(addresses, segment.nodes, config.dc.delay_rounds);
  corrections_.assign(slaves_.size(), {});
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    auto& correction = corrections_[i];
    correction.written = correction.target = snapshot_.slaves[slaves_[i]].propagation_delay_ns;
    correction.datagram = addresses[i].write(reg::kSystemTimeDelay, correction.bytes);
  }
  requests_.clear();
  requests_.reserve(3 * slaves_.size() + 1);
  step_ = Step::kWait;
}

void DelayCompensation::start(const DcNetwork& network, Nanoseconds now) {
  use(network.measured, network.segment, network.reference_clock);
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    corrections_[i].written = corrections_[i].target = network.slaves[slaves_[i]].delay_ns;
  }
  measured_at_ = now;
  set_enabled(config_.dc.continuous_propagation_compensation, now);
}

void DelayCompensation::renew(std::vector<std::size_t> slaves, const DelaySurvey& survey, std::uint16_t leader,
                              std::uint32_t step_ns, Nanoseconds now) {
  use(std::move(slaves), survey.segment, leader);
  next_step_ = measured_at_ = now;
  correct_to(survey.result, step_ns, UINT32_MAX, now);
}

void DelayCompensation::set_enabled(bool enabled, Nanoseconds now) {
  enabled_ = enabled;
  step_ = Step::kWait;
  next_measurement_ = now + kPeriod;
  next_step_ = now;
  // What was on its way to another value by nanoseconds stays where it is; who is far off comes home.
  for (auto& correction : corrections_) {
    if (correction.step == 1) correction.target = correction.written;
  }
}

std::span<Datagram* const> DelayCompensation::requests(Nanoseconds now) {
  requests_.clear();
  corrections_sent_ = 0;
  if (!latch_) return {};
  switch (step_) {
    case Step::kWait:
      if (!enabled_ || now < next_measurement_) {
        add_corrections(now);
        break;
      }
      latch_->forget();
      failed_rounds_ = 0;
      begin_round();
      [[fallthrough]];
    case Step::kTrigger:
      requests_.push_back(&latch_->trigger());
      break;
    case Step::kRead:
      for (auto& read : latch_->reads()) {
        if (!read.answered) requests_.push_back(&read);
      }
      break;
  }
  return requests_;
}

void DelayCompensation::begin_round() {
  step_ = Step::kTrigger;
  patience_ = kRoundPatience;
}

void DelayCompensation::take(Nanoseconds now, std::optional<std::uint16_t> leader) {
  if (!latch_) return;
  take_corrections();
  if (step_ == Step::kWait) return;
  // Delays count from the clock that leads, and say nothing while somebody is on the way.
  if (!all_there() || leader != reference_clock_ || patience_-- == 0) return give_up(now);
  take_round(now);
}

void DelayCompensation::take_round(Nanoseconds now) {
  if (step_ == Step::kTrigger) {
    if (!requests_.front()->answered) return;
    latch_->begin_reading();
    step_ = Step::kRead;
    return;
  }
  if (!std::ranges::all_of(requests_, [](const Datagram* read) { return read->answered; })) return;
  if (!latch_->take() && ++failed_rounds_ > kMostFailedRounds) return give_up(now);
  if (latch_->rounds() == latch_->wanted_rounds()) return finish(now);
  begin_round();
}

void DelayCompensation::finish(Nanoseconds now) {
  step_ = Step::kWait;
  next_measurement_ = now + kPeriod;
  correct_to(segment_delays(latch_->nodes(), wiring_, whole_, delay_options(config_.dc)), 1, kLargestChange, now);
}

void DelayCompensation::correct_to(const dc::DelayResult& delays, std::uint32_t least_step,
                                   std::uint32_t largest_change, Nanoseconds now) {
  constexpr std::uint32_t kSteps = kLongest / kStepPeriod;
  std::int64_t largest = 0;
  std::size_t corrected = 0;
  std::uint32_t most_steps = 1;
  const auto leader =
      static_cast<std::size_t>(std::ranges::find(slaves_, std::size_t{reference_clock_}) - slaves_.begin());
  const auto origin = leader < slaves_.size() ? delays.delay_ns[leader] : std::nullopt;
  for (std::size_t i = 0; origin && i < slaves_.size(); ++i) {
    auto& correction = corrections_[i];
    if (!snapshot_.slaves[slaves_[i]].dc_enabled || !delays.delay_ns[i] || *delays.delay_ns[i] < *origin) continue;
    // Whoever leads in the place of another keeps the delay that it had behind that.
    const auto delay = *delays.delay_ns[i] - *origin + corrections_[leader].written;
    const auto change = std::int64_t{delay} - std::int64_t{correction.written};
    if (std::abs(change) <= kDeadBand || std::abs(change) > largest_change) continue;
    correction.target = delay;
    const auto size = static_cast<std::uint32_t>(std::abs(change));
    correction.step = least_step == 1 ? 1 : std::clamp(size / kSteps, least_step, 2 * least_step);
    if (least_step > 1) most_steps = std::max(most_steps, size / correction.step);
    ++corrected;
    if (std::abs(change) > std::abs(largest)) largest = change;
  }
  step_period_ =
      std::clamp(kLongest / most_steps, std::min(kCyclesToFollow * config_.cycle_time(), kStepPeriod), kStepPeriod);
  teller_.tell(now, -1, events::DelaysMeasured{corrected, largest});
}

void DelayCompensation::give_up(Nanoseconds now) {
  step_ = Step::kWait;
  next_measurement_ = now + kPeriod;
}

/// A step of each slave that is not where it should be.
void DelayCompensation::add_corrections(Nanoseconds now) {
  if (now < next_step_) return;
  next_step_ = now + step_period_;
  for (auto& correction : corrections_) {
    if (correction.written == correction.target) continue;
    const auto next = correction.written < correction.target
                          ? correction.written + std::min(correction.step, correction.target - correction.written)
                          : correction.written - std::min(correction.step, correction.written - correction.target);
    store_le(std::span(correction.bytes), next);
    correction.datagram.answered = false;
    correction.datagram.wkc = 0;
    requests_.push_back(&correction.datagram);
  }
  corrections_sent_ = requests_.size();
}

void DelayCompensation::take_corrections() {
  if (corrections_sent_ == 0) return;
  for (std::size_t i = 0; i < corrections_.size(); ++i) {
    auto& correction = corrections_[i];
    if (correction.written == correction.target || !correction.datagram.done()) continue;
    correction.written = load_le<std::uint32_t>(correction.bytes);
    correction.datagram.answered = false;
    snapshot_.slaves[slaves_[i]].propagation_delay_ns = correction.written;
    states_.note_slave_change();
  }
}

bool DelayCompensation::all_there() const {
  return std::ranges::all_of(slaves_, [this](std::size_t slave) { return snapshot_.slaves[slave].present; });
}

}  // namespace syncline
