// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/damage.h"

namespace syncline::fuzz {

/// Something that takes what others made, with good inputs to start from. `run` aborts when a promise is broken; what
/// it reads is for the sanitizers to watch.
struct Target {
  const char* name;
  void (*run)(std::span<const std::uint8_t> bytes);
  std::vector<Bytes> (*corpus)();
  Bytes (*damage)(const Bytes& good, Random& random);  // what gets further than plain changes of bytes
  std::size_t test_runs;                               // damaged inputs in the ordinary test: a second or two
};

[[nodiscard]] std::span<const Target> targets();
/// nullptr when there is none of this name.
[[nodiscard]] const Target* find_target(std::string_view name);

/// The run ends here with the input that broke it.
inline void promise(bool kept) {
  if (!kept) std::abort();
}

[[nodiscard]] inline std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
[[nodiscard]] inline Bytes bytes_of_text(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace syncline::fuzz
