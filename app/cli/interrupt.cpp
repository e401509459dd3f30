// SPDX-License-Identifier: Apache-2.0
#include "app/cli/interrupt.h"

#include <csignal>

namespace syncline::cli {
namespace {

std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set nothing else");

void raise_flag(int) { flag = true; }

}  // namespace

InterruptGuard::InterruptGuard() {
  flag = false;
  previous_interrupt_ = std::signal(SIGINT, raise_flag);
  previous_terminate_ = std::signal(SIGTERM, raise_flag);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, previous_interrupt_);
  std::signal(SIGTERM, previous_terminate_);
}

const std::atomic<bool>& InterruptGuard::interrupted() const { return flag; }

}  // namespace syncline::cli
