// SPDX-License-Identifier: Apache-2.0
#include "support/stop_signals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>

namespace syncline {
namespace {

using testing::HasSubstr;

struct sigaction action_of(int number) {
  struct sigaction set {};
  ::sigaction(number, nullptr, &set);
  return set;
}

/// 128 and the signal's number, or the exit code; what `work` does, and what the default of a signal does to it, is
/// done in a process of its own.
int outcome_of(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(StopSignals, EveryOneOfThemSetsTheFlagAndNothingIsBegunAgain) {
  for (const int number : stop_signals()) {
    const auto before = action_of(number);
    {
      const StopSignals stop;
      EXPECT_FALSE(stop.interrupted());
      EXPECT_EQ(action_of(number).sa_flags & SA_RESTART, 0) << number;
      ::raise(number);
      EXPECT_TRUE(stop.interrupted()) << number;
      EXPECT_EQ(stop.number(), number);
    }
    EXPECT_EQ(action_of(number).sa_handler, before.sa_handler) << number;
  }
}

TEST(StopSignals, AreAllThatEndAProgramAndCanBeCaught) {
  const auto all = stop_signals();
  for (int number = 1; number <= SIGRTMAX; ++number) {
    if (number == SIGXFSZ || (number >= 32 && number < SIGRTMIN)) continue;  // see the header
    // What ends a child that leaves it alone.
    const int outcome = outcome_of([number] {
      ::signal(number, SIG_DFL);
      if (number != SIGSTOP && number != SIGTSTP && number != SIGTTIN && number != SIGTTOU) ::raise(number);
      return 0;
    });
    const bool ends = outcome == 128 + number && number != SIGKILL;
    EXPECT_EQ(std::ranges::find(all, number) != all.end(), ends) << number;
  }
}

TEST(StopSignals, WhatIsIgnoredStaysIgnoredAsAfterNohup) {
  for (const int number : {SIGHUP, SIGUSR1, SIGXCPU}) {
    ::signal(number, SIG_IGN);
    {
      const StopSignals stop;
      ::raise(number);
      EXPECT_FALSE(stop.interrupted()) << number;
    }
    ::signal(number, SIG_DFL);
  }
}

TEST(StopSignals, ABackgroundJobOfAShellHearsThoseThatTheShellHadItIgnore) {
  ::signal(SIGINT, SIG_IGN);
  {
    const StopSignals stop;
    ::raise(SIGINT);
    EXPECT_TRUE(stop.interrupted());
  }
  EXPECT_EQ(action_of(SIGINT).sa_handler, SIG_IGN);
  ::signal(SIGINT, SIG_DFL);
}

TEST(StopSignals, AFaultOfTheProgramIsNoRequest) {
  const auto fault = [] {
    // The one that sanitizers leave alone.
    ::signal(SIGILL, SIG_DFL);
    const StopSignals stop;
    __builtin_trap();
    return 0;
  };
  EXPECT_EQ(outcome_of(fault), 128 + SIGILL);
}

TEST(StopSignals, ASecondOneEndsAtOnceWhenItIsNoEchoOfTheFirst) {
  const auto twice = [](int first, std::chrono::milliseconds longest_echo, int second) {
    return outcome_of([=] {
      const StopSignals stop(longest_echo);
      ::raise(first);
      ::raise(second);
      return 7;
    });
  };
  // The second one comes at once, which is one or the other.
  const auto echo = StopSignals::kLongestEcho;
  const std::chrono::milliseconds later(0);
  EXPECT_EQ(twice(SIGINT, echo, SIGINT), 7) << "timeout and terminals send theirs twice";
  EXPECT_EQ(twice(SIGINT, later, SIGINT), 128 + SIGINT);
  EXPECT_EQ(twice(SIGHUP, later, SIGTERM), 128 + SIGTERM);
  EXPECT_EQ(twice(SIGPIPE, later, SIGPIPE), 7) << "each line that nobody reads sends it again";
}

TEST(PauseRefused, CtrlZGetsALineAndNothingStops) {
  const auto before = action_of(SIGTSTP);
  testing::internal::CaptureStderr();
  {
    const PauseRefused outer;
    { const PauseRefused inner; }
    for (const int number : {SIGTSTP, SIGTTIN, SIGTTOU}) ::raise(number);
  }
  const auto said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("a stopped master would leave the drives without frames; end with Ctrl-C\n"));
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  EXPECT_EQ(action_of(SIGTSTP).sa_handler, before.sa_handler);
}

TEST(PauseRefused, WhatIsIgnoredStaysIgnored) {
  ::signal(SIGTSTP, SIG_IGN);
  testing::internal::CaptureStderr();
  {
    const PauseRefused refused;
    ::raise(SIGTSTP);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(action_of(SIGTSTP).sa_handler, SIG_IGN);
  ::signal(SIGTSTP, SIG_DFL);
}

}  // namespace
}  // namespace syncline
