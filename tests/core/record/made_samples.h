// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "channels/cycle_sample.h"
#include "support/random.h"

namespace syncline::test {

/// Samples of a run that meets everything: lost frames, gaps in the stream, readings of slaves now and then. As from
/// the master, what is not valid in a cycle is 0.
class MadeSamples {
 public:
  explicit MadeSamples(std::uint64_t seed, Nanoseconds cycle_time = kMillisecond)
      : random_(seed), cycle_time_(cycle_time) {}

  std::vector<CycleSample> next(std::size_t count) {
    std::vector<CycleSample> samples(count);
    for (auto& sample : samples) sample = one();
    return samples;
  }

 private:
  std::int64_t about(std::int64_t size) {
    return static_cast<std::int64_t>(random_.next() % static_cast<std::uint64_t>(2 * size + 1)) - size;
  }
  bool once_in(std::uint64_t many) { return random_.next() % many == 0; }

  CycleSample one() {
    if (once_in(500)) cycle_ += 1 + random_.next() % 20;
    if (once_in(300)) lost_ = random_.next() % 30;
    CycleSample s;
    s.cycle = cycle_++;
    s.wake_lateness_ns = static_cast<std::int32_t>(about(20'000));
    s.send_time = kStart + static_cast<Nanoseconds>(s.cycle) * cycle_time_ + s.wake_lateness_ns % 1000;
    s.wkc_expected = 9;
    s.master_state = 8;
    s.slaves_sync = static_cast<SyncState>(random_.next() % kSyncStates);
    s.master_sync = static_cast<SyncState>(random_.next() % kSyncStates);
    s.flags = CycleSample::kDcmActive | CycleSample::kSyncBaseValid;
    s.sync_base = 250'000;
    s.dcm_adjust_ns = static_cast<std::int32_t>(about(50));
    s.dcm_output_sum_ns = static_cast<float>(about(1000)) / 8;
    s.dcm_output_total_ns = about(1'000'000'000'000);
    if (lost_ > 0) {
      --lost_;
      s.flags |= CycleSample::kFrameLost;
      s.frames_lost = 1;
      return s;
    }
    s.flags |= CycleSample::kReferenceValid | CycleSample::kDeviationValid | CycleSample::kFollowersRead;
    s.stamped_by = StampSource::kKernel;
    s.stamp_doubt_ns = static_cast<std::int32_t>(s.cycle * 7919 % 3'000);
    s.round_trip_ns = static_cast<std::int32_t>(30'000 + about(900));
    s.wkc_received = once_in(50) ? 6 : 9;
    s.reference_time = s.send_time + 333'333 + about(400);
    s.dcm_error_ns = static_cast<std::int32_t>(about(900));
    s.dcm_error_filtered_ns = s.dcm_error_ns / 4;
    if (s.cycle % 7 != 0) s.external_error_ns = -s.dcm_error_ns;
    s.drift_ppm = 12.5F + static_cast<float>(about(100)) / 1024;
    s.deviation_ored_ns = static_cast<std::uint32_t>(random_.next() % 64);
    s.deviation_ns = static_cast<std::uint32_t>(random_.next() % 40);
    s.slave_position = static_cast<std::int16_t>(s.cycle % 3);
    s.slave_deviation_ns = static_cast<std::int32_t>(about(40));
    if (s.slave_position > 0) s.flags |= CycleSample::kSlaveFollows;
    if (once_in(40)) {
      s.sm2_position = 2;
      s.slave_sm2_missed = misses_ += static_cast<std::uint32_t>(random_.next() % 2);
      s.slave_sm2_integrator = static_cast<std::uint32_t>(random_.next() % 9);
    }
    if (once_in(200)) {
      s.flags |= CycleSample::kFrameLate;
      s.late_by_ns = static_cast<std::int32_t>(random_.next() % 100'000);
    }
    return s;
  }

  static constexpr Nanoseconds kStart = 830'000'000 * kSecond;
  Random random_;
  Nanoseconds cycle_time_;
  std::uint64_t cycle_ = 1, lost_ = 0;
  std::uint32_t misses_ = 0;
};

}  // namespace syncline::test
