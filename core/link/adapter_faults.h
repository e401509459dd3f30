// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "support/types.h"

namespace syncline {

struct SimConfig;

/// What a scenario does to the frames at the host's own end of the cable: a network card, its driver or a switch that
/// holds them up, an adapter that is switched off. Times of the link's clock.
struct AdapterFaults {
  struct Span {
    Nanoseconds from = 0, to = 0;  // without `to`
    Nanoseconds longer = 0;        // held up by so much
  };
  std::vector<Span> holds_frames, holds_answers, off;

  /// `begin`: when the bus is switched on.
  [[nodiscard]] static AdapterFaults of(const SimConfig& config, Nanoseconds begin);
  /// So much later than it is handed over at `time` does a frame leave; and is one handed to the host.
  [[nodiscard]] Nanoseconds frame_held(Nanoseconds time) const;
  [[nodiscard]] Nanoseconds answer_held(Nanoseconds time) const;
  [[nodiscard]] bool is_off(Nanoseconds time) const;
  /// When the adapter is switched off next behind `time`, before `latest`; otherwise that.
  [[nodiscard]] Nanoseconds next_off(Nanoseconds time, Nanoseconds latest) const;
};

}  // namespace syncline
