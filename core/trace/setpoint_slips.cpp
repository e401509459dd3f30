// SPDX-License-Identifier: Apache-2.0
#include "trace/setpoint_slips.h"

#include <algorithm>
#include <cstdlib>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "protocol/al_state.h"

namespace syncline {

SetpointSlips::SetpointSlips(std::span<const Sync0Slave> slaves, Nanoseconds cycle_time) : cycle_time_(cycle_time) {
  for (const auto& sync0 : slaves) {
    slaves_.emplace_back().sync0 = sync0;
    any_ = any_ || sync0.frames > 0;
  }
}

void SetpointSlips::begin_anew() {
  for (auto& slave : slaves_) slave.count.reset();
  last_send_ = last_reference_ = 0;
}

std::optional<SetpointSlips::Count> SetpointSlips::count(std::size_t slave) const {
  return slave < slaves_.size() ? slaves_[slave].count : std::nullopt;
}

bool SetpointSlips::clock_stepped(const CycleSample& sample) const {
  if (last_send_ == 0) return false;
  const auto passed = sample.reference_time - last_reference_;
  return passed < 0 || std::abs(passed - (sample.send_time - last_send_)) > cycle_time_;
}

bool SetpointSlips::observe(const CycleSample& sample) {
  if (!any_) return false;
  const auto has = [&](CycleSample::Flag flag) { return (sample.flags & flag) != 0; };
  const bool lost = has(CycleSample::kFrameLost);
  const auto base = has(CycleSample::kSyncBaseValid) ? std::optional(sample.sync_base) : std::nullopt;
  const bool unknown = !base || has(CycleSample::kFrameLate) || (!lost && !has(CycleSample::kReferenceValid));
  const bool anew = unknown || base != base_ || (!lost && clock_stepped(sample));
  if (anew) begin_anew();
  base_ = base;
  if (unknown || lost) return anew;
  last_send_ = sample.send_time;
  last_reference_ = sample.reference_time;
  bool news = anew;
  for (auto& slave : slaves_) {
    if (!slave.delay) continue;
    slave.grid = {*base + slave.sync0.shift, slave.sync0.period};
    const auto came = dc::outputs_arrival(sample.reference_time, *slave.delay, slave.sync0.wire);
    news = arrive(slave, came) || news;
  }
  return news;
}

bool SetpointSlips::arrive(Slave& slave, Nanoseconds time) {
  const auto period = slave.grid.period;
  if (!slave.count) {
    slave.count = Count{};
    slave.end = time - dc::sync0_arrival(slave.grid, time).phase + period;
    slave.frames = 1;
    return true;
  }
  const auto since = time - slave.end;
  if (since < 0) return ++slave.frames == slave.sync0.frames + 1 && ++slave.count->crowded > 0;
  // The closed form of sync0_arrival(): nearly always it is the period behind the one that was running.
  const auto empty = since < period ? 0 : since / period;
  slave.count->empty += static_cast<std::uint32_t>(empty);
  slave.end += (empty + 1) * period;
  slave.frames = 1;
  return empty > 0;
}

bool SetpointSlips::observe(const Snapshot& snapshot) {
  if (!any_) return false;
  bool news = false;
  for (std::size_t i = 0; i < std::min(slaves_.size(), snapshot.slaves.size()); ++i) {
    const auto& status = snapshot.slaves[i];
    auto& slave = slaves_[i];
    const bool in_op = status.present && status.al_status == static_cast<std::uint16_t>(AlState::kOp);
    const auto delay = in_op && status.dc_enabled && slave.sync0.frames > 0
                           ? std::optional(static_cast<Nanoseconds>(status.propagation_delay_ns))
                           : std::nullopt;
    if (delay == slave.delay) continue;
    slave.delay = delay;
    slave.count.reset();
    news = true;
  }
  return news;
}

}  // namespace syncline
