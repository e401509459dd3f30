// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline::sim {

/// Time control loop of an ESC behind 0x092C, 0x0930, 0x0932, 0x0934 and 0x0935. The relation of
/// speed counter and rate is the data sheet's (ESC data sheet I, 9.1.4); how the speed counter is formed
/// is not published, so the filters are a reconstruction whose settling matches published practice. Filters of depth
/// 2^n are what hardware has: sums, differences and shifts of whole numbers.
class TimeControlLoop {
 public:
  static constexpr std::uint16_t kDefaultSpeedCounterStart = 0x1000;
  static constexpr std::uint16_t kMinSpeedCounterStart = 0x0080;
  static constexpr std::uint16_t kMaxSpeedCounterStart = 0x3FFF;
  /// Of what the filters hold.
  static constexpr unsigned kFractionBits = 30;

  /// One comparison; local minus received time, ns. True: correction() is another.
  bool observe(std::int32_t local_minus_received);
  /// Write of 0x0930: resets 0x092C, 0x0932 and both filters. Values outside the range are held at its ends.
  void set_speed_counter_start(std::uint16_t value);
  /// Write of 0x0934 / 0x0935: exponent 0..15, resets the respective filter.
  void set_filter_depth_difference(std::uint8_t exponent);
  void set_filter_depth_speed_counter(std::uint8_t exponent);

  [[nodiscard]] std::uint16_t speed_counter_start() const { return start_; }
  [[nodiscard]] std::uint8_t filter_depth_difference() const { return difference_depth_; }
  [[nodiscard]] std::uint8_t filter_depth_speed_counter() const { return speed_depth_; }
  /// 0x0932, signed.
  [[nodiscard]] std::int32_t speed_counter_diff() const { return diff_; }
  /// 0x092C as sign and magnitude word; bit 31: local copy is ahead (newer data sheet edition).
  [[nodiscard]] std::uint32_t system_time_difference() const;
  /// Relative slow-down of the local clock.
  [[nodiscard]] double correction() const;

 private:
  static constexpr std::int32_t kCounterMargin = 0x7F;
  [[nodiscard]] static constexpr std::int64_t fixed(std::int64_t value) {
    return value * (std::int64_t{1} << kFractionBits);
  }
  [[nodiscard]] static constexpr std::int64_t limit_of(std::uint16_t start) { return fixed(start - kCounterMargin); }

  std::uint16_t start_ = kDefaultSpeedCounterStart;
  std::uint8_t difference_depth_ = 4;
  std::uint8_t speed_depth_ = 12;
  std::int64_t limit_ = limit_of(kDefaultSpeedCounterStart);  // of the counts, as start_ says
  std::int64_t mean_ = 0;                                     // ns, in parts of 2^-30
  std::int64_t period_deviation_ = 0;                         // counts, in parts of 2^-30
  std::int32_t diff_ = 0;
};

}  // namespace syncline::sim
