// SPDX-License-Identifier: Apache-2.0
// Entry of libFuzzer for the target that SYNCLINE_FUZZ_TARGET names.
#include <cstddef>

#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto* const target = syncline::fuzz::find_target(SYNCLINE_FUZZ_TARGET);
  target->run({data, size});
  return 0;
}
