// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <array>
#include <atomic>
#include <cstddef>

namespace syncline {

/// What asks a program to end: Ctrl-C (SIGINT), Ctrl-\ (SIGQUIT), SIGTERM, a closed terminal (SIGHUP), a reader of the
/// output that is gone (SIGPIPE).
inline constexpr std::array kStopSignals{SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGPIPE};

/// While it lives, these signals end the work, not the program: what runs takes itself down and the report is printed.
/// Calls that wait (for a pipe's writer) return with EINTR, they are not begun again. SIGHUP stays ignored where it was
/// (nohup). One at a time in a program.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Set by the first signal.
  [[nodiscard]] const std::atomic<bool>& interrupted() const;
  /// The first signal's number, 0 before.
  [[nodiscard]] int number() const;
  /// Readable from the first signal on, for loops that wait for descriptors.
  [[nodiscard]] int descriptor() const;

 private:
  std::array<struct sigaction, kStopSignals.size()> previous_{};
};

/// Threads that are started while it lives never run the handler: their waiting stays as exact as it is.
class StopSignalsBlocked {
 public:
  StopSignalsBlocked();
  ~StopSignalsBlocked();
  StopSignalsBlocked(const StopSignalsBlocked&) = delete;
  StopSignalsBlocked& operator=(const StopSignalsBlocked&) = delete;

 private:
  sigset_t previous_{};
};

}  // namespace syncline
