// SPDX-License-Identifier: Apache-2.0
#include "dcm_plant.h"

#include <algorithm>
#include <cmath>

#include "protocol/speed_counter.h"

namespace syncline::dc {
namespace {

constexpr std::uint16_t kSpeedCounterStart = 0x1000;
/// Of a clock that the host steers, as the initialisation sets it.
constexpr double kSteeredDepth = 64;
constexpr double kSecondWriteAfter = 40'000;  // ns
constexpr int kMostSecondWrites = 4;
constexpr double kSpeedCounterLimit = kSpeedCounterStart - 0x7F;
/// Host clock and system time at the start; far apart, so that mixing them up shows.
constexpr Nanoseconds kHostStart = 820'000'000 * kSecond;
constexpr Nanoseconds kReferenceStart = 700'000'000 * kSecond;

double rate(double diff) {
  const double s = kSpeedCounterStart;
  return diff / (5 * (s + diff + 2) * (s - diff + 2));
}

double wrap(double value, double period) { return value - period * std::round(value / period); }

}  // namespace

double EscClock::time_after(double ns) const {
  return time_ + ns * (1 + ppm_ * 1e-6) * (1 - speed_counter_rate(kSpeedCounterStart, diff_));
}

void EscClock::receive(double local_minus_received) {
  mean_ += (local_minus_received - mean_) / depth_;
  const double wanted = std::clamp(period_deviation_ + mean_, -kSpeedCounterLimit, kSpeedCounterLimit);
  period_deviation_ += (wanted - period_deviation_) / 4096;
  diff_ = static_cast<std::int32_t>(std::lround(wanted));
}

void EscClock::learn(double ppm, double share) {
  const double wanted = (ppm_ - ppm) * 1e-6 * share;
  double low = -kSpeedCounterLimit, high = kSpeedCounterLimit;
  for (int i = 0; i < 60; ++i) {
    period_deviation_ = (low + high) / 2;
    (rate(period_deviation_) < wanted ? low : high) = period_deviation_;
  }
  diff_ = static_cast<std::int32_t>(std::lround(period_deviation_));
}

DcmPlant::DcmPlant(PlantOptions options)
    : options_(std::move(options)),
      random_(options_.seed),
      reference_(options_.reference_ppm, steers_reference_clock(options_.mode) ? kSteeredDepth : 16) {
  options_.settings.mode = options_.mode;
  controller_ = options_.controller ? options_.controller()
                                    : make_dcm_controller(options_.settings, options_.cycle, options_.set_value);
  for (const double ppm : options_.slave_ppm) slaves_.emplace_back(ppm);
  // In bus shift all follow the host, otherwise the reference clock.
  const bool steered = steers_reference_clock(options_.mode);
  if (steered) reference_.learn(0, options_.learned_share);
  for (auto& slave : slaves_) slave.learn(steered ? 0 : options_.reference_ppm, options_.learned_share);
  const auto first = kReferenceStart + std::llround(options_.start_error);
  reference_.step(options_.start_error);
  for (auto& slave : slaves_) slave.step(options_.start_error);
  controller_->start((kReferenceStart + options_.set_value) % options_.cycle, first, kHostStart);
}

void DcmPlant::run_until(double seconds) {
  while (static_cast<double>(schedule_) < seconds * 1e9) cycle();
}

double DcmPlant::draw_jitter() {
  return options_.jitter.wake_up.empty() ? 0 : options_.jitter.wake_up.at(random_.uniform());
}

double DcmPlant::draw_stamp_error() {
  double error = -std::abs(random_.normal()) * options_.send_delay + random_.normal() * options_.stamp_noise;
  if (!options_.stamp_error.empty()) error -= options_.stamp_error.at(random_.uniform());
  return error;
}

/// As the master does it: once more, and again when that one strays too.
void DcmPlant::write_again() {
  bool again = true;
  for (int i = 0; again && i < kMostSecondWrites; ++i) {
    advance_to(now_ + kSecondWriteAfter);
    const auto stamp = kHostStart + std::llround(now_ + draw_stamp_error());
    const double passing = reference_.time();
    if (const auto wanted = controller_->reference_write(stamp, stamp)) {
      reference_.receive(passing - static_cast<double>(*wanted - kReferenceStart));
    }
    again = controller_->observe_second_write(
        {stamp, stamp, kReferenceStart + static_cast<Nanoseconds>(std::floor(passing / 10)) * 10});
  }
}

void DcmPlant::advance_to(double host_time) {
  const double step = host_time - now_;
  reference_.advance(step);
  for (auto& slave : slaves_) slave.advance(step);
  now_ = host_time;
}

void DcmPlant::cycle() {
  PlantCycle result;
  result.jitter = draw_jitter() + options_.late(count_);
  const auto schedule = static_cast<double>(schedule_);
  const double stamp_error = draw_stamp_error();
  if (options_.clock_step.cycle == count_) {
    reference_.step(options_.clock_step.ns);
    for (auto& slave : slaves_) slave.step(options_.clock_step.ns);
  }
  const double step = schedule + result.jitter - now_;
  const double rate = step == 0 ? 1 : (reference_.time_after(step) - reference_.time()) / step;
  advance_to(schedule + result.jitter);
  const auto host_schedule = kHostStart + schedule_;
  const auto stamp = host_schedule + std::llround(result.jitter + stamp_error);

  const double passing = reference_.time();
  // Where the frame would have passed on time.
  result.grid_error = wrap(passing - result.jitter * rate, static_cast<double>(options_.cycle));
  DcmObservation observation{stamp, host_schedule, std::nullopt};
  if (!options_.lost(count_)) {
    observation.reference_time = kReferenceStart + static_cast<Nanoseconds>(std::floor(passing / 10)) * 10;
    if (const auto wanted = controller_->reference_write(stamp, host_schedule)) {
      reference_.receive(passing - static_cast<double>(*wanted - kReferenceStart));
    }
    for (auto& slave : slaves_) slave.receive(slave.time() - passing + random_.uniform(-10, 10));
  }
  const auto action = controller_->observe(observation);
  if (action.write_again) write_again();
  for (const auto& slave : slaves_) {
    result.slave_error = std::max(result.slave_error, std::abs(slave.time() - reference_.time()));
    result.deviation = std::max(result.deviation, std::abs(slave.deviation()));
  }
  result.time = schedule / 1e9;
  result.state = controller_->state();
  cycles_.push_back(result);
  // An application of MasterShiftByApp does as it is told.
  const bool by_app = options_.mode == DcmMode::kMasterShiftByApp;
  schedule_ += options_.cycle + (by_app ? result.state.adjust : action.period_adjust);
  ++count_;
}

double DcmPlant::in_sync_at() const {
  const auto found = std::find_if(cycles_.begin(), cycles_.end(), [](const auto& c) { return c.state.in_sync; });
  return found == cycles_.end() ? kEnd : found->time;
}

int DcmPlant::times_lost() const {
  int count = 0;
  for (std::size_t i = 1; i < cycles_.size(); ++i) {
    if (cycles_[i - 1].state.in_sync && !cycles_[i].state.in_sync) ++count;
  }
  return count;
}

bool DcmPlant::reported(std::uint32_t error_code) const {
  return std::any_of(cycles_.begin(), cycles_.end(), [&](const auto& c) { return c.state.error_code == error_code; });
}

double DcmPlant::worst(Field field, double from, double to) const {
  double result = 0;
  for (const auto& c : cycles_) {
    if (c.time >= from && c.time < to) result = std::max(result, std::abs(c.*field));
  }
  return result;
}

double DcmPlant::rms(Field field, double from, double to) const {
  double sum = 0;
  int count = 0;
  for (const auto& c : cycles_) {
    if (c.time < from || c.time >= to) continue;
    sum += c.*field * (c.*field);
    ++count;
  }
  return std::sqrt(sum / std::max(count, 1));
}

double DcmPlant::mean(Field field, double from, double to) const {
  double sum = 0;
  int count = 0;
  for (const auto& c : cycles_) {
    if (c.time < from || c.time >= to) continue;
    sum += c.*field;
    ++count;
  }
  return sum / std::max(count, 1);
}

}  // namespace syncline::dc
