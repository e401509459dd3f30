// SPDX-License-Identifier: Apache-2.0
#include "support/stop_signals.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace syncline {
namespace {

std::atomic<bool> flag{false};
std::atomic<int> first{0};
std::atomic<int> wake_up{-1};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may set nothing else");

void raise_flag(int number) {
  const int kept = errno;
  int none = 0;
  first.compare_exchange_strong(none, number);
  flag = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(wake_up, &one, sizeof one);
  errno = kept;
}

}  // namespace

StopSignals::StopSignals() {
  flag = false;
  first = 0;
  wake_up = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  struct sigaction action {};
  action.sa_handler = raise_flag;
  ::sigemptyset(&action.sa_mask);
  action.sa_flags = 0;  // not SA_RESTART: who waits is to notice
  for (std::size_t i = 0; i < kStopSignals.size(); ++i) {
    ::sigaction(kStopSignals[i], &action, &previous_[i]);
    if (kStopSignals[i] == SIGHUP && previous_[i].sa_handler == SIG_IGN) ::sigaction(SIGHUP, &previous_[i], nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < kStopSignals.size(); ++i) ::sigaction(kStopSignals[i], &previous_[i], nullptr);
  ::close(wake_up.exchange(-1));
}

const std::atomic<bool>& StopSignals::interrupted() const { return flag; }
int StopSignals::number() const { return first; }
int StopSignals::descriptor() const { return wake_up; }

StopSignalsBlocked::StopSignalsBlocked() {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int number : kStopSignals) ::sigaddset(&set, number);
  ::pthread_sigmask(SIG_BLOCK, &set, &previous_);
}

StopSignalsBlocked::~StopSignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &previous_, nullptr); }

}  // namespace syncline
