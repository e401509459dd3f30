// SPDX-License-Identifier: Apache-2.0
// Entry of libFuzzer: fuzz_target with the name of the target in the environment variable FUZZ_TARGET.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>

#include "fuzz/targets.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

const syncline::fuzz::Target& target() {
  static const auto* const found = [] {
    const char* const name = std::getenv("FUZZ_TARGET");
    const auto* const wanted = syncline::fuzz::find_target(name == nullptr ? "" : name);
    if (wanted != nullptr) return wanted;
    std::cerr << "fuzz_target: set FUZZ_TARGET to one of";
    for (const auto& each : syncline::fuzz::targets()) std::cerr << ' ' << each.name;
    std::cerr << '\n';
    std::exit(2);
  }();
  return *found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target().run({data, size});
  return 0;
}

/// libFuzzer's own mutations, which learn from the comparisons, and those that know what the input is.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  syncline::Random random(seed);
  if (random.next() % 3 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const auto damaged = target().damage({data, data + size}, random);
  const auto length = std::min(damaged.size(), max_size);
  std::copy_n(damaged.begin(), length, data);
  return length;
}
