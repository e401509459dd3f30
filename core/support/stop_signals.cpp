// SPDX-License-Identifier: Apache-2.0
#include "support/stop_signals.h"

#include <errno.h>
#include <sys/eventfd.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <vector>

namespace syncline {
namespace {

/// Not of those whose default ends a program, see stop_signals().
constexpr std::array kSignalsThatEndNothing{SIGKILL, SIGSTOP, SIGCHLD, SIGCONT,  SIGTSTP,
                                            SIGTTIN, SIGTTOU, SIGURG,  SIGWINCH, SIGXFSZ};
/// What the processor raises, too. A thread that blocks these is killed by its own fault without another word.
constexpr std::array kFaultSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS};
constexpr std::array kCaughtThoughIgnored{SIGINT, SIGQUIT, SIGTERM, SIGPIPE};
constexpr std::array kSignalsByHand{SIGINT, SIGQUIT, SIGTERM};
constexpr std::array kPauseSignals{SIGTSTP, SIGTTIN, SIGTTOU};
constexpr int kFirstRealTime = 32;  // the kernel's; the C library keeps the first ones for itself

std::atomic<bool> flag{false};
std::atomic<int> first{0};
std::atomic<std::int64_t> first_at_ms{0}, longest_echo_ms{0};
std::atomic<int> wake_up{-1};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
                  std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may set nothing else");

std::array<struct sigaction, NSIG> actions_before{};

std::mutex pause_mutex;  // of the two below
int pauses_refused = 0;
std::array<struct sigaction, kPauseSignals.size()> pause_actions_before{};

bool is_signal_of(std::span<const int> signals, int number) {
  return std::ranges::find(signals, number) != signals.end();
}

/// Only what signal-safety(7) allows.
void say_from_handler(const char* words) {
  // NOLINTBEGIN(misc-include-cleaner): the GNU C library's
  for (const char* part : {static_cast<const char*>(program_invocation_short_name), ": ", words, "\n"}) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, part, std::strlen(part));
  }
  // NOLINTEND(misc-include-cleaner)
}

std::int64_t monotonic_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000 + now.tv_nsec / 1'000'000;
}

/// The default comes when the handler returns.
void end_at_once(int number) {
  say_from_handler("ended at once by the second signal; slaves are as they were at that moment");
  ::signal(number, SIG_DFL);
  ::raise(number);
}

void hand_back_fault(int number) {
  ::sigaction(number, &actions_before[static_cast<std::size_t>(number)], nullptr);
  // The others happen again when the instruction is begun again.
  if (number == SIGTRAP || number == SIGSYS) ::raise(number);
}

void on_stop_signal(int number, siginfo_t* information, void* /*context*/) {
  const int kept = errno;
  if (information->si_code > 0 && is_signal_of(kFaultSignals, number)) {  // sent by nobody
    hand_back_fault(number);
    return;
  }
  int none = 0;
  if (first.compare_exchange_strong(none, number)) {
    first_at_ms = monotonic_ms();
  } else if (is_signal_of(kSignalsByHand, number) && monotonic_ms() - first_at_ms >= longest_echo_ms) {
    end_at_once(number);
  }
  flag = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(wake_up, &one, sizeof one);
  errno = kept;
}

void on_pause(int /*number*/) {
  const int kept = errno;
  say_from_handler("not stopped: a stopped master would leave the drives without frames; end with Ctrl-C");
  errno = kept;
}

std::vector<int> find_stop_signals() {
  std::vector<int> found;
  for (int number = 1; number <= SIGRTMAX; ++number) {
    if (!is_signal_of(kSignalsThatEndNothing, number) && (number < kFirstRealTime || number >= SIGRTMIN))
      found.push_back(number);
  }
  return found;
}

}  // namespace

std::span<const int> stop_signals() {
  static const std::vector<int> found = find_stop_signals();
  return found;
}

StopSignals::StopSignals(std::chrono::milliseconds longest_echo) {
  longest_echo_ms = longest_echo.count();
  flag = false;
  first = 0;
  wake_up = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  struct sigaction action {};
  action.sa_sigaction = on_stop_signal;
  ::sigemptyset(&action.sa_mask);
  action.sa_flags = SA_SIGINFO;  // not SA_RESTART: who waits is to notice
  for (const int number : stop_signals()) {
    auto& before = actions_before[static_cast<std::size_t>(number)];
    ::sigaction(number, &action, &before);
    const bool ignored = (before.sa_flags & SA_SIGINFO) == 0 && before.sa_handler == SIG_IGN;
    if (ignored && !is_signal_of(kCaughtThoughIgnored, number)) ::sigaction(number, &before, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (const int number : stop_signals()) {
    ::sigaction(number, &actions_before[static_cast<std::size_t>(number)], nullptr);
  }
  ::close(wake_up.exchange(-1));
}

const std::atomic<bool>& StopSignals::interrupted() const { return flag; }
int StopSignals::number() const { return first; }
int StopSignals::descriptor() const { return wake_up; }
int StopSignals::current() { return wake_up; }

StopSignalsBlocked::StopSignalsBlocked() {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int number : stop_signals()) {
    if (!is_signal_of(kFaultSignals, number)) ::sigaddset(&set, number);
  }
  ::sigaddset(&set, SIGTSTP);
  ::pthread_sigmask(SIG_BLOCK, &set, &previous_);
}

StopSignalsBlocked::~StopSignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &previous_, nullptr); }

PauseRefused::PauseRefused() {
  const std::scoped_lock lock(pause_mutex);
  if (pauses_refused++ > 0) return;
  for (std::size_t i = 0; i < kPauseSignals.size(); ++i) {
    struct sigaction action {};
    // To write to a terminal from the background is not refused where the signal is ignored; a handler would come again
    // and again.
    action.sa_handler = kPauseSignals[i] == SIGTSTP ? on_pause : SIG_IGN;
    ::sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    ::sigaction(kPauseSignals[i], &action, &pause_actions_before[i]);
    if (pause_actions_before[i].sa_handler == SIG_IGN) ::sigaction(kPauseSignals[i], &pause_actions_before[i], nullptr);
  }
}

PauseRefused::~PauseRefused() {
  const std::scoped_lock lock(pause_mutex);
  if (--pauses_refused > 0) return;
  for (std::size_t i = 0; i < kPauseSignals.size(); ++i)
    ::sigaction(kPauseSignals[i], &pause_actions_before[i], nullptr);
}

}  // namespace syncline
