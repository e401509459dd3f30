// SPDX-License-Identifier: Apache-2.0
#include "support/clock.h"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <optional>
#include <vector>

#include "support/jitter_profile.h"
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
  struct Standstill {
    Nanoseconds begin = 0, end = 0;
  };
  std::atomic<Nanoseconds> now{0};
  JitterProfile jitter;
  Random wake_ups{0}, stalls{0};        // apart: how often a master wakes up does not move the stalls
  std::vector<Standstill> standstills;  // by their begin
  std::size_t next_standstill = 0;
  std::optional<Standstill> next_stall;  // by chance

  /// How late this wake-up is.
  Nanoseconds lateness() {
    if (jitter.wake_up.empty()) return 0;
    return std::llround(jitter.wake_up.at(wake_ups.uniform()));
  }

  /// The one that follows a time by chance, which has no memory.
  void draw_stall(Nanoseconds after) {
    next_stall.reset();
    if (jitter.stalls_per_second <= 0) return;
    const auto begin = after + std::llround(-std::log(1 - stalls.uniform()) / jitter.stalls_per_second * 1e9);
    next_stall = {begin, begin + std::llround(jitter.stall.at(stalls.uniform()))};
  }

  /// When the host, due at `time`, goes on.
  Nanoseconds goes_on(Nanoseconds time) {
    for (;;) {
      if (next_standstill < standstills.size() && standstills[next_standstill].begin <= time) {
        time = std::max(time, standstills[next_standstill++].end);
      } else if (next_stall && next_stall->begin <= time) {
        const auto end = next_stall->end;
        time = std::max(time, end);
        draw_stall(end);
      } else {
        return time;
      }
    }
  }
};

VirtualClock::VirtualClock(Nanoseconds start) : state_(std::make_unique<State>()) { state_->now = start; }
VirtualClock::~VirtualClock() = default;

void VirtualClock::set_wakeup_jitter(const JitterProfile& profile, std::uint64_t seed) {
  state_->jitter = profile;
  state_->wake_ups = Random(seed);
  state_->stalls = Random(seed ^ 0x7374'616C'6C73U);
  state_->draw_stall(now());
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
