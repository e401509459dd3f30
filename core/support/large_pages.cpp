// SPDX-License-Identifier: Apache-2.0
#include "support/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace syncline {
namespace {

constexpr std::uintptr_t kLargePage = 2U << 20;

}  // namespace

void use_large_pages(void* begin, std::size_t bytes) {
  const auto from = reinterpret_cast<std::uintptr_t>(begin);
  const auto first = (from + kLargePage - 1) / kLargePage * kLargePage;
  const auto behind = (from + bytes) / kLargePage * kLargePage;
  // A system that has none says so, and nothing is lost.
  if (first < behind) (void)::madvise(static_cast<std::byte*>(begin) + (first - from), behind - first, MADV_HUGEPAGE);
}

}  // namespace syncline
