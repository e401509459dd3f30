// SPDX-License-Identifier: Apache-2.0
#include "sim/dc/sync_generator.h"

namespace syncline::sim {
namespace {
bool before(std::uint64_t a, std::uint64_t b) { return static_cast<std::int64_t>(a - b) < 0; }
}  // namespace

void SyncGenerator::activate(const Settings& settings, std::optional<std::uint64_t> first) {
  settings_ = settings;
  active_ = true;
  first0_done_ = first1_done_ = false;
  next0_ = first;
  next1_.reset();
}

void SyncGenerator::deactivate() {
  active_ = false;
  next0_.reset();
  next1_.reset();
}

std::optional<SyncGenerator::Due> SyncGenerator::due() const {
  if (next0_ && (!next1_ || !before(*next1_, *next0_))) {
    return Due{*next0_, Signal::kSync0};
  }
  if (next1_) {
    return Due{*next1_, Signal::kSync1};
  }
  return std::nullopt;
}

void SyncGenerator::start_sync1(std::uint64_t sync0) {
  // A SYNC1 that is still to come keeps its SYNC0; the next one belongs to the first SYNC0 behind it.
  if (settings_.sync1 && !next1_) {
    next1_ = latest1_ = sync0 + settings_.cycle1;
  }
}

void SyncGenerator::fired() {
  const auto signal = due();
  if (!signal) {
    return;
  }
  if (signal->signal == Signal::kSync1) {
    first1_done_ = true;
    next1_.reset();
    return;
  }
  first0_done_ = true;
  start_sync1(signal->time);
  if (settings_.cycle0 == 0) {
    next0_.reset();
  } else {
    next0_ = signal->time + settings_.cycle0;
  }
}

void SyncGenerator::realign(std::uint64_t now, bool wide) {
  const auto nearest = [now](std::uint64_t due) {
    return now +
           static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(static_cast<std::uint32_t>(due - now))});
  };
  if (!wide && next1_) next1_ = latest1_ = nearest(*next1_);
  // A start time that has passed comes when the counter comes round again.
  if (!wide && next0_) next0_ = first0_done_ ? nearest(*next0_) : now + static_cast<std::uint32_t>(*next0_ - now);
  if (next0_ && before(*next0_, now) && !first0_done_) next0_.reset();
  (void)pass_to(now);
}

std::uint64_t SyncGenerator::skip_to(std::uint64_t now) {
  if (next1_ && before(*next1_, now)) first1_done_ = true;
  const auto passed = pass_to(now);
  if (passed > 0) first0_done_ = true;
  return passed;
}

/// On with the first of each that is not before `now`.
std::uint64_t SyncGenerator::pass_to(std::uint64_t now) {
  if (next1_ && before(*next1_, now)) next1_.reset();
  if (!next0_ || !before(*next0_, now)) return 0;
  if (settings_.cycle0 == 0) {
    next0_.reset();
    return 1;
  }
  const auto since = now - *next0_;
  const auto passed = since < settings_.cycle0 ? 1 : since / settings_.cycle0 + 1;  // one, mostly
  next0_ = *next0_ + passed * settings_.cycle0;
  return passed;
}

}  // namespace syncline::sim
