// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/loop_tuning.h"

#include <algorithm>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// One message in 2^15 counts for nothing, whatever the stamp it was told by was wrong by.
constexpr std::uint8_t kHoldingDepth = 15;
/// A slave that is there and does not answer so often never will.
constexpr int kMostTries = 1'000;

}  // namespace

LoopTuning::LoopTuning(const NetworkConfig& config, const Snapshot& snapshot) : config_(config), snapshot_(snapshot) {
  jobs_.reserve(config.slaves.size());
}

LoopTuning::Job& LoopTuning::job_of(std::uint16_t position) {
  const auto known = std::ranges::find(jobs_, position, &Job::position);
  return known == jobs_.end() ? jobs_.emplace_back(Job{.position = position}) : *known;
}

void LoopTuning::set_depth(std::uint16_t position, std::uint8_t depth) {
  job_of(position) = {.position = position, .step = Step::kSetDepth, .depth = depth};
}

void LoopTuning::settle(std::uint16_t position, std::optional<std::uint8_t> depth) {
  auto& job = job_of(position);
  job.step = depth ? Step::kHold : std::min(job.step, Step::kHold);
  job.depth = depth.value_or(job.depth);
  job.tries = 0;
}

bool LoopTuning::is_there(const Job& job) const { return snapshot_.slaves[job.position].present; }

bool LoopTuning::pending() const {
  return std::ranges::any_of(jobs_, [&](const Job& job) { return is_there(job); });
}

void LoopTuning::prepare(const Job& job) {
  const auto station = config_.slaves[job.position].station_address;
  const auto depth = device_address(station, reg::kFilterDepthDifference);
  const auto time = device_address(station, reg::kSystemTime);
  frame_.clear();
  depth_ = {job.step == Step::kHold ? kHoldingDepth : job.depth};
  ahead_ = job.ahead;
  tells_ = job.step == Step::kTell;
  depth_access_ = {job.step == Step::kAskDepth ? Command::kFprd : Command::kFpwr, depth, depth_};
  time_access_ = {tells_ ? Command::kFpwr : Command::kFprd, time, time_};
  time_access_.stamped = tells_;
  if (!tells_) (void)frame_.add(depth_access_);
  if (tells_ || job.step == Step::kHold) (void)frame_.add(time_access_);
}

Status LoopTuning::step(FrameExchange& exchange, Nanoseconds deadline) {
  const auto job = std::ranges::find_if(jobs_, [&](const Job& each) { return is_there(each); });
  if (job == jobs_.end()) return {};
  prepare(*job);
  if (auto sent = exchange.send(frame_, this); !sent) return sent;
  std::array<PendingFrame*, 1> frames{&frame_};
  auto status = exchange.collect(frames, deadline);
  if (take(*job) || ++job->tries >= kMostTries) jobs_.erase(job);
  return status;
}

/// True when that was the last step.
bool LoopTuning::take(Job& job) {
  if (!frame_.answered() || !std::ranges::all_of(frame_.datagrams(), &Datagram::done)) return false;
  job.tries = 0;
  switch (job.step) {
    case Step::kAskDepth:
      job.depth = depth_[0];
      job.step = Step::kHold;
      return false;
    case Step::kHold:
      job.ahead = static_cast<Nanoseconds>(load_le<std::uint32_t>(time_)) - stamped_at_;
      job.step = Step::kTell;
      return false;
    case Step::kTell:
      job.step = Step::kSetDepth;
      return false;
    case Step::kSetDepth:
      return true;
  }
  return true;
}

void LoopTuning::stamp(Nanoseconds send_time) {
  stamped_at_ = send_time;
  if (tells_) store_le(std::span(time_), static_cast<std::uint32_t>(send_time + ahead_));
}

}  // namespace syncline
