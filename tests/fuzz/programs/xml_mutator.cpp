// SPDX-License-Identifier: Apache-2.0
// Mutations for libFuzzer that leave most of an XML text XML.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "fuzz/xml_damage.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  syncline::Random random(seed);
  if (random.next() % 8 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const auto damaged = syncline::fuzz::damage_xml({reinterpret_cast<const char*>(data), size}, random);
  const auto length = std::min(damaged.size(), max_size);
  std::memcpy(data, damaged.data(), length);
  return length;
}
