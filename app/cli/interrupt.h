// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

namespace syncline::cli {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM end the work, not the program: what runs takes itself down and
/// the report is printed. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Set by the signal.
  [[nodiscard]] const std::atomic<bool>& interrupted() const;

 private:
  using Handler = void (*)(int);
  Handler previous_interrupt_, previous_terminate_;
};

}  // namespace syncline::cli
