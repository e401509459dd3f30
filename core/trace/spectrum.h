// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

#include "support/types.h"
#include "trace/stability.h"

namespace syncline {

struct NetworkConfig;

struct SpectrumLine {
  double frequency = 0;  // Hz
  double amplitude = 0;  // of a sine, in the unit of the samples (half of its peak-to-peak value)
};

/// Amplitudes over frequency: the mean power of Hann windows that overlap by half, none across a gap.
struct Spectrum {
  double step = 0;                    // Hz between two amplitudes; 0: no stretch was long enough
  std::vector<double> amplitudes;     // from 0 Hz to half of the sampling rate
  std::size_t windows = 0, used = 0;  // windows that were averaged, and samples in them
  std::vector<SpectrumLine> peaks;    // the highest first; frequency and amplitude between the steps
};

inline constexpr std::size_t kMostPeaks = 8;
/// `interval` in s. Windows are as long as the longest stretch, up to 131072 samples; stretches shorter than a window
/// are left out. Mean and slope of a window are taken off first: they are no lines. Peaks stand at least 8 times above
/// the median about them. Not for the thread of a window: a second for 10 million samples. Ends early, with the windows
/// that it has, once `stop` is true; null: it does not.
[[nodiscard]] Spectrum spectrum_of(Stretches<float> stretches, double interval,
                                   const std::atomic<bool>* stop = nullptr);

/// What a line may come from, by its frequency alone: a hint, no proof.
struct KnownFrequency {
  enum class Kind : unsigned char { kBeat, kTask, kMains, kLoop };
  Kind kind = Kind::kMains;
  double frequency = 0;  // Hz, before it was folded at half of the sampling rate
  bool operator==(const KnownFrequency&) const = default;
};
/// The beat of the two clocks (a cycle against a cycle, `drift_ppm` apart) where there is one, each task with its
/// first harmonics, mains of 50 and 60 Hz with theirs. `task_periods` in s.
[[nodiscard]] std::vector<KnownFrequency> known_frequencies(double cycle_s, double drift_ppm,
                                                            std::span<const double> task_periods);
/// These of a run, and the loop of the master synchronisation where it may swing. `drift_ppm` as above.
[[nodiscard]] std::vector<KnownFrequency> known_frequencies(const NetworkConfig& config, Nanoseconds cycle_time,
                                                            double drift_ppm);
/// The known one that is within 1 % or `resolution` of the line, the loop within 30 %; null without one. Lines above
/// half of `sampling_rate` are seen folded; constant values (0 Hz) are no lines.
[[nodiscard]] const KnownFrequency* likely_cause(const SpectrumLine& line, std::span<const KnownFrequency> known,
                                                 double sampling_rate, double resolution);

}  // namespace syncline
