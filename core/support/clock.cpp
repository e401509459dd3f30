// SPDX-License-Identifier: Apache-2.0
#include "support/clock.h"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <vector>

#include "support/random.h"
#include "support/shared_epoch.h"

namespace syncline {
namespace {

Nanoseconds read_clock(clockid_t id) {
  timespec time{};
  clock_gettime(id, &time);
  return static_cast<Nanoseconds>(time.tv_sec) * kSecond + time.tv_nsec;
}

}  // namespace

RealClock::RealClock() : epoch_shift_(SharedEpoch::of_this_machine().shift()) {}

Nanoseconds RealClock::now() const { return read_clock(CLOCK_MONOTONIC) + epoch_shift_; }

void RealClock::sleep_until(Nanoseconds deadline) {
  const Nanoseconds monotonic = deadline - epoch_shift_;
  if (monotonic <= 0) return;
  timespec time{};
  time.tv_sec = monotonic / kSecond;
  time.tv_nsec = monotonic % kSecond;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

Nanoseconds RealClock::sleep_until(Nanoseconds deadline, Nanoseconds spin) {
  const auto wake = deadline - spin;
  if (now() >= wake) {
    while (now() < deadline) {
    }
    return 0;
  }
  sleep_until(wake);
  auto time = now();
  const auto late = time - wake;
  while (time < deadline) time = now();
  return late;
}

struct VirtualClock::State {
  std::atomic<Nanoseconds> now{0};
  JitterProfile jitter;
  Random random{0};
  struct Standstill {
    Nanoseconds begin = 0, end = 0;
  };
  std::vector<Standstill> standstills;  // by their begin
  std::size_t next_standstill = 0;

  /// When the host, due at `time`, goes on.
  Nanoseconds goes_on(Nanoseconds time) {
    while (next_standstill < standstills.size() && standstills[next_standstill].begin <= time) {
      time = std::max(time, standstills[next_standstill++].end);
    }
    return time;
  }

  /// How late this wake-up is; the generator is asked the same number of times in every call, so
  /// that one profile's numbers do not depend on what the earlier ones were.
  Nanoseconds lateness() {
    if (jitter == JitterProfile::none()) return 0;
    const double scheduling = std::abs(random.normal()) * jitter.sigma_ns;
    const double chance = random.uniform();
    const double tail = random.uniform() * jitter.tail_ns;
    return std::llround(scheduling + (chance < jitter.tail_probability ? tail : 0.0));
  }
};

VirtualClock::VirtualClock(Nanoseconds start) : state_(std::make_unique<State>()) { state_->now = start; }
VirtualClock::~VirtualClock() = default;

void VirtualClock::set_wakeup_jitter(const JitterProfile& profile, std::uint64_t seed) {
  state_->jitter = profile;
  state_->random = Random(seed);
}

void VirtualClock::add_standstill(Nanoseconds begin, Nanoseconds length) {
  auto& all = state_->standstills;
  const auto place = std::ranges::upper_bound(all, begin, {}, &State::Standstill::begin);
  all.insert(place, {begin, begin + length});
}

Nanoseconds VirtualClock::now() const { return state_->now.load(std::memory_order_relaxed); }

void VirtualClock::sleep_until(Nanoseconds deadline) {
  if (deadline <= now()) return;
  advance_to(deadline + state_->lateness());
}

void VirtualClock::advance_to(Nanoseconds time) {
  if (time > now()) state_->now.store(state_->goes_on(time), std::memory_order_relaxed);
}

}  // namespace syncline
