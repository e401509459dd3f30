// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <atomic>
#include <chrono>
#include <span>

namespace syncline {

/// What asks a program to end: every signal that can be caught and whose default is to end it, real-time ones too, but
/// SIGXFSZ, which both programs ignore: a file that may not grow is an error of that file. Of SIGSEGV, SIGBUS, SIGFPE,
/// SIGILL, SIGTRAP and SIGSYS only what another program sends; a fault of our own is for the handler that was there
/// before. Source: signal(7).
[[nodiscard]] std::span<const int> stop_signals();

/// While it lives, these signals end the work, not the program: what runs takes itself down and the report is printed.
/// Calls that wait (for a pipe's writer) return with EINTR, they are not begun again. What was ignored (SIGHUP after
/// nohup) stays ignored, SIGINT, SIGQUIT, SIGTERM and SIGPIPE excepted: shells have their background jobs ignore them.
/// Another of SIGINT, SIGQUIT and SIGTERM ends the program at once, with a line on the error stream, if it comes as
/// long after the first as no echo does, or later: shells and timeout send theirs twice. One at a time in a program.
class StopSignals {
 public:
  static constexpr std::chrono::milliseconds kLongestEcho{1'000};
  explicit StopSignals(std::chrono::milliseconds longest_echo = kLongestEcho);
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Set by the first signal.
  [[nodiscard]] const std::atomic<bool>& interrupted() const;
  /// The first signal's number, 0 before.
  [[nodiscard]] int number() const;
  /// Readable from the first signal on, for loops that wait for descriptors.
  [[nodiscard]] int descriptor() const;
  /// That of the one that lives, -1 when there is none. Any thread.
  [[nodiscard]] static int current();
};

/// Threads that are started while it lives never run the handlers: their waiting stays as exact as it is.
class StopSignalsBlocked {
 public:
  StopSignalsBlocked();
  ~StopSignalsBlocked();
  StopSignalsBlocked(const StopSignalsBlocked&) = delete;
  StopSignalsBlocked& operator=(const StopSignalsBlocked&) = delete;

 private:
  sigset_t previous_{};
};

/// While one lives, a bus is driven in real time and the program is not stopped by job control: Ctrl-Z (SIGTSTP) gets a
/// line on the error stream that says why, a terminal that a background job reads or writes (SIGTTIN, SIGTTOU) does not
/// stop it. What was ignored stays ignored. SIGSTOP cannot be refused. Any number at a time, on any thread.
class PauseRefused {
 public:
  PauseRefused();
  ~PauseRefused();
  PauseRefused(const PauseRefused&) = delete;
  PauseRefused& operator=(const PauseRefused&) = delete;
};

}  // namespace syncline
