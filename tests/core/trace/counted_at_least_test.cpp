// SPDX-License-Identifier: Apache-2.0
#include "trace/counted_at_least.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

constexpr Nanoseconds kCountedFrom = 830'000'000 * kSecond;

/// Counts that a counter of the slave stands behind.
std::vector<Signal> counted_signals() {
  std::vector<Signal> all;
  for (const auto& row : signals()) {
    if (row.scope == SignalInfo::Scope::kSlave && !row.since.empty() && row.id != Signal::kSetpointSlips)
      all.push_back(row.id);
  }
  return all;
}

using SetAtLeast = void (*)(SlaveStatus&);
struct CountedCase {
  SetAtLeast set;
  std::vector<Signal> counts;
};

std::vector<Signal> counts_of_port(std::size_t port) {
  return {port_signal(port, PortSignal::kInvalidFrames), port_signal(port, PortSignal::kReceiveErrors),
          port_signal(port, PortSignal::kForwardedErrors), port_signal(port, PortSignal::kLostLinks)};
}

std::vector<CountedCase> counted_cases() {
  return {
      {[](SlaveStatus& s) { s.evidence.ports[0].at_least = true; }, counts_of_port(0)},
      {[](SlaveStatus& s) { s.evidence.ports[1].at_least = true; }, counts_of_port(1)},
      {[](SlaveStatus& s) { s.evidence.ports[2].at_least = true; }, counts_of_port(2)},
      {[](SlaveStatus& s) { s.evidence.ports[3].at_least = true; }, counts_of_port(3)},
      {[](SlaveStatus& s) { s.evidence.outputs.exceeded.at_least = true; }, {Signal::kOutputsExceeded}},
      {[](SlaveStatus& s) { s.evidence.inputs.exceeded.at_least = true; }, {Signal::kInputsExceeded}},
      {[](SlaveStatus& s) { s.evidence.outputs.shift_too_short.at_least = true; }, {Signal::kOutputsShiftTooShort}},
      {[](SlaveStatus& s) { s.evidence.inputs.shift_too_short.at_least = true; }, {Signal::kInputsShiftTooShort}},
      {[](SlaveStatus& s) { s.evidence.process_data_watchdog.at_least = true; }, {Signal::kProcessDataWatchdog}},
      {[](SlaveStatus& s) { s.evidence.pdi_watchdog.at_least = true; }, {Signal::kPdiWatchdog}},
      {[](SlaveStatus& s) { s.evidence.processing_unit_errors.at_least = true; }, {Signal::kProcessingUnitErrors}},
      {[](SlaveStatus& s) { s.evidence.pdi_errors.at_least = true; }, {Signal::kPdiErrors}},
      {[](SlaveStatus& s) { s.sm2_missed.at_least = true; }, {Signal::kSm2Missed}},
  };
}

/// A store of two slaves in which the second one tells that from its second moment on.
SampleStore store_telling(SetAtLeast set) {
  SampleStore store({.slaves = 2});
  for (int i = 0; i < 3; ++i) {
    CycleSample sample;
    sample.cycle = static_cast<std::uint64_t>(i);
    sample.send_time = kCountedFrom + i * kMillisecond;
    store.append(std::span(&sample, 1));
    Snapshot snapshot;
    snapshot.time = sample.send_time;
    snapshot.online = true;
    snapshot.slaves.resize(2);
    for (auto& slave : snapshot.slaves) slave.present = true;
    if (i > 0) set(snapshot.slaves[1]);
    store.append(snapshot);
  }
  return store;
}

TEST(CountedAtLeast, IsToldOfEachCountFromItsMomentOn) {
  std::vector<Signal> told;
  for (const auto& one : counted_cases()) {
    const auto store = store_telling(one.set);
    for (const auto& row : signals()) {
      const bool of_it = std::ranges::find(one.counts, row.id) != one.counts.end();
      EXPECT_EQ(counted_at_least(store, row.id, 1, kCountedFrom + 2 * kMillisecond), of_it) << row.key;
      EXPECT_FALSE(counted_at_least(store, row.id, 1, kCountedFrom)) << row.key << " before";
      EXPECT_FALSE(counted_at_least(store, row.id, 0, kCountedFrom + 2 * kMillisecond))
          << row.key << " of another slave";
      EXPECT_FALSE(counted_at_least(store, row.id, 2, kCountedFrom + 2 * kMillisecond)) << "no such slave";
    }
    told.insert(told.end(), one.counts.begin(), one.counts.end());
  }
  for (const auto count : counted_signals())
    EXPECT_TRUE(std::ranges::find(told, count) != told.end()) << info(count).key << ": nobody tells it";
}

TEST(CountedAtLeast, ABitIsOfOneCounter) {
  std::uint32_t all = 0;
  for (const auto& one : counted_cases()) {
    SlaveStatus slave;
    EXPECT_EQ(counts_at_least(slave), 0U);
    one.set(slave);
    const auto bits = counts_at_least(slave);
    EXPECT_EQ(all & bits, 0U);
    all |= bits;
    EXPECT_EQ(counts_in(bits), std::vector{one.counts.front()});
  }
  EXPECT_EQ(counts_in(all).size(), counted_cases().size());
  EXPECT_TRUE(counts_in(~all).empty()) << "bits of a newer program";
}

}  // namespace
}  // namespace syncline
