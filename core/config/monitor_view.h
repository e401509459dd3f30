// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace syncline {

/// How values are laid on their axis. Signed logarithmic: as linear about zero, logarithmic to both sides.
enum class ValueScale : std::uint8_t { kLinear, kSignedLog, kLog };
/// "linear", "signed-log", "log": as files have it.
[[nodiscard]] std::string_view value_scale_name(ValueScale scale);
[[nodiscard]] std::optional<ValueScale> value_scale_from_name(std::string_view name);

/// A signal by what it is called, whatever machine runs: one that the machine at hand lacks stays in its place.
struct ViewSignal {
  enum class Of : std::uint8_t { kBus, kSlave, kVariable };
  Of of = Of::kBus;
  std::string key;                    // of the table of signals (core/trace/signals.h); of a variable its name
  std::uint16_t station_address = 0;  // of the slave; 0: of none
  bool output = false;                // of a variable; else it is an input
  bool rate = false;                  // of a count: how many a second instead of how many
  bool right = false;                 // on the axis at the right
  bool operator==(const ViewSignal&) const = default;
};
/// "bus", "slave", "variable".
[[nodiscard]] std::string_view view_signal_of_name(ViewSignal::Of of);
[[nodiscard]] std::optional<ViewSignal::Of> view_signal_of_from_name(std::string_view name);

/// In the unit of the signals; low < high.
struct AxisLimits {
  double low = 0, high = 1;
  bool operator==(const AxisLimits&) const = default;
};
/// "-500 500", whatever the locale; nothing where these are no two finite numbers in that order.
[[nodiscard]] std::optional<AxisLimits> axis_limits_from_text(std::string_view text);

struct ViewPlot {
  static constexpr std::uint16_t kUsualHeight = 100;

  std::string title;  // "": by what it shows
  std::vector<ViewSignal> signals;
  ValueScale scale = ValueScale::kLinear;
  std::optional<AxisLimits> left, right;  // empty: by what is shown
  bool own_time = false;                  // is not linked to the time axis of the others
  std::uint16_t height = kUsualHeight;    // in proportion to the other plots, 1..10000
  bool operator==(const ViewPlot&) const = default;
};

/// Plots that the user has put together, over each other. Kept with the project; no master and no ENI knows of them.
struct MonitorView {
  std::string name;
  std::vector<ViewPlot> plots;
  bool operator==(const MonitorView&) const = default;
};

}  // namespace syncline
