// SPDX-License-Identifier: Apache-2.0
#include "support/memory_reserve.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace syncline {
namespace {

/// Large enough to be a mapping of its own, which goes back to the system when it is freed.
constexpr std::size_t kReserve = std::size_t{1} << 20;

std::atomic<void*> reserve{nullptr};

void give_back() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

}  // namespace

void hold_memory_reserve() noexcept {
  if (reserve.load() != nullptr) return;
  std::free(reserve.exchange(std::malloc(kReserve)));
  std::set_new_handler(give_back);
}

}  // namespace syncline
