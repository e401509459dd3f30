// SPDX-License-Identifier: Apache-2.0
#include "trace/spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <kissfft/kissfft.hh>
#include <numbers>

#include "config/network_config.h"
#include "dc/dcm/dcm_controller.h"

namespace syncline {
namespace {

constexpr std::size_t kLongestWindow = 1U << 17, kShortestWindow = 16;
constexpr double kAboveMedian = 8;
constexpr double kLinePart = 0.01, kLoopPart = 0.3;  // how far from a known frequency a line of it may be
constexpr std::size_t kAbout = 32;                   // amplitudes on either side of a peak that it is held against

/// Windowed powers, summed up.
class PowerSum {
 public:
  explicit PowerSum(std::size_t length)
      : fft_(length / 2, false), hann_(length), input_(length), output_(length / 2), powers_(length / 2 + 1) {
    for (std::size_t i = 0; i < length; ++i) {
      hann_[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length));
    }
  }

  void add(std::span<const float> x) {
    const auto n = static_cast<double>(x.size());
    const double middle = (n - 1) / 2;
    double sum = 0;
    double moment = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += static_cast<double>(x[i]);
      moment += static_cast<double>(x[i]) * (static_cast<double>(i) - middle);
    }
    const double mean = sum / n;
    const double slope = moment * 12 / (n * (n * n - 1));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double line = mean + slope * (static_cast<double>(i) - middle);
      input_[i] = (static_cast<double>(x[i]) - line) * hann_[i];
    }
    fft_.transform_real(input_.data(), output_.data());
    // The first value holds both ends of the spectrum, which are real.
    powers_.front() += output_.front().real() * output_.front().real();
    powers_.back() += output_.front().imag() * output_.front().imag();
    for (std::size_t i = 1; i < output_.size(); ++i) powers_[i] += std::norm(output_[i]);
    ++windows_;
  }

  [[nodiscard]] std::size_t windows() const { return windows_; }
  /// Of sines: half of the window's samples times its mean of a half is what one of amplitude 1 gives.
  [[nodiscard]] std::vector<double> amplitudes() const {
    std::vector<double> result(powers_.size());
    const double scale = 4 / static_cast<double>(hann_.size());
    for (std::size_t i = 0; i < powers_.size(); ++i)
      result[i] = scale * std::sqrt(powers_[i] / static_cast<double>(std::max<std::size_t>(windows_, 1)));
    return result;
  }

 private:
  kissfft<double> fft_;
  std::vector<double> hann_, input_;
  std::vector<std::complex<double>> output_;
  std::vector<double> powers_;
  std::size_t windows_ = 0;
};

/// A line between two steps: how a Hann window shares it among its neighbours says where it is and how high.
SpectrumLine refined(const std::vector<double>& amplitudes, std::size_t i, double step) {
  const bool up = amplitudes[i + 1] >= amplitudes[i - 1];
  const double ratio = (up ? amplitudes[i + 1] : amplitudes[i - 1]) / amplitudes[i];
  const double part = std::clamp((2 * ratio - 1) / (ratio + 1), 0.0, 0.5);
  const double angle = std::numbers::pi * part;
  const double height = part < 1e-9 ? 1 : angle * (1 - part * part) / std::sin(angle);
  return {(static_cast<double>(i) + (up ? part : -part)) * step, amplitudes[i] * height};
}

double median_about(const std::vector<double>& amplitudes, std::size_t place) {
  const auto begin = place > kAbout ? place - kAbout : 1;
  const auto end = std::min(place + kAbout + 1, amplitudes.size());
  std::vector<double> near;
  for (auto i = begin; i < end; ++i) {
    if (i + 2 < place || i > place + 2) near.push_back(amplitudes[i]);
  }
  if (near.empty()) return 0;
  const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
  std::ranges::nth_element(near, middle);
  return *middle;
}

std::vector<SpectrumLine> peaks_of(const std::vector<double>& amplitudes, double step) {
  std::vector<std::size_t> tops;
  for (std::size_t i = 2; i + 1 < amplitudes.size(); ++i) {
    if (amplitudes[i] > amplitudes[i - 1] && amplitudes[i] >= amplitudes[i + 1]) tops.push_back(i);
  }
  std::ranges::sort(tops, [&](std::size_t a, std::size_t b) { return amplitudes[a] > amplitudes[b]; });
  std::vector<SpectrumLine> peaks;
  const double least = tops.empty() ? 0 : amplitudes[tops.front()] * 1e-4;  // side lobes and rounding
  for (const auto top : tops) {
    if (peaks.size() == kMostPeaks || amplitudes[top] < least) break;
    if (amplitudes[top] >= kAboveMedian * median_about(amplitudes, top))
      peaks.push_back(refined(amplitudes, top, step));
  }
  return peaks;
}

}  // namespace

Spectrum spectrum_of(Stretches<float> stretches, double interval, const std::atomic<bool>* stop) {
  Spectrum spectrum;
  std::size_t longest = 0;
  for (const auto& stretch : stretches) longest = std::max(longest, stretch.size());
  if (longest < kShortestWindow || interval <= 0) return spectrum;
  const auto length = std::min(std::bit_floor(longest), kLongestWindow);
  PowerSum powers(length);
  for (const auto& stretch : stretches) {
    if (stretch.size() < length) continue;
    // As many as overlap by half at least, from the first sample to the last one.
    const auto rest = stretch.size() - length;
    const auto moves = (rest + length / 2 - 1) / (length / 2);
    for (std::size_t i = 0; i <= moves; ++i) {
      if (stop != nullptr && stop->load(std::memory_order_relaxed)) return spectrum;
      powers.add(stretch.subspan(moves == 0 ? 0 : rest * i / moves, length));
    }
    spectrum.used += stretch.size();
  }
  spectrum.windows = powers.windows();
  spectrum.step = 1 / (interval * static_cast<double>(length));
  spectrum.amplitudes = powers.amplitudes();
  spectrum.peaks = peaks_of(spectrum.amplitudes, spectrum.step);
  return spectrum;
}

std::vector<KnownFrequency> known_frequencies(double cycle_s, double drift_ppm, std::span<const double> task_periods) {
  using Kind = KnownFrequency::Kind;
  constexpr int kHarmonics = 3;
  std::vector<KnownFrequency> known;
  if (drift_ppm != 0 && cycle_s > 0) known.push_back({Kind::kBeat, std::abs(drift_ppm) * 1e-6 / cycle_s});
  for (const double period : task_periods) {
    for (int i = 1; i <= kHarmonics && period > 0; ++i) known.push_back({Kind::kTask, i / period});
  }
  for (const double mains : {50.0, 60.0}) {
    for (int i = 1; i <= kHarmonics; ++i) known.push_back({Kind::kMains, i * mains});
  }
  return known;
}

std::vector<KnownFrequency> known_frequencies(const NetworkConfig& config, Nanoseconds cycle_time, double drift_ppm) {
  std::vector<double> periods;
  for (const auto& task : config.cyclic) periods.push_back(static_cast<double>(task.cycle_time) / 1e9);
  auto known = known_frequencies(static_cast<double>(cycle_time) / 1e9, drift_ppm, periods);
  if (!config.dc.enabled) return known;
  const auto swing = dc::loop_frequency(config.dc.dcm, cycle_time);
  if (swing) known.push_back({KnownFrequency::Kind::kLoop, *swing});
  return known;
}

const KnownFrequency* likely_cause(const SpectrumLine& line, std::span<const KnownFrequency> known,
                                   double sampling_rate, double resolution) {
  const KnownFrequency* best = nullptr;
  double nearest = 1;  // distance, in what is allowed
  for (const auto& candidate : known) {
    const double turns = std::round(candidate.frequency / sampling_rate);
    const double seen = std::abs(candidate.frequency - turns * sampling_rate);
    if (seen < 2 * resolution) continue;  // indistinguishable from a constant
    const double part = candidate.kind == KnownFrequency::Kind::kLoop ? kLoopPart : kLinePart;
    const double distance = std::abs(seen - line.frequency) / std::max(part * line.frequency, resolution);
    if (distance >= nearest) continue;
    nearest = distance;
    best = &candidate;
  }
  return best;
}

}  // namespace syncline
