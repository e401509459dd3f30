// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/output_forces.h"

#include <algorithm>
#include <bit>

#include "channels/command.h"

namespace syncline {
namespace {

constexpr std::uint32_t kMostForcedBits = 64;

/// What stands under the mask is taken from `from`.
constexpr std::uint8_t mixed(std::uint8_t into, std::uint8_t from, std::uint8_t mask) {
  return static_cast<std::uint8_t>((into & ~mask) | (from & mask));
}

}  // namespace

bool OutputForces::inside(std::uint32_t bit_offset, std::uint32_t bit_size) const {
  return bit_size >= 1 && bit_size <= kMostForcedBits &&
         static_cast<std::uint64_t>(bit_offset) + bit_size <= mask_.size() * std::uint64_t{8};
}

bool OutputForces::force(const ForceOutputCommand& wanted) {
  if (!inside(wanted.bit_offset, wanted.bit_size)) return false;
  for (std::uint32_t i = 0; i < wanted.bit_size; ++i) {
    const auto place = wanted.bit_offset + i;
    const auto bit = static_cast<std::uint8_t>(1U << (place % 8));
    mask_[place / 8] = static_cast<std::uint8_t>(mask_[place / 8] | bit);
    values_[place / 8] = mixed(values_[place / 8], (wanted.value >> i & 1U) != 0 ? bit : std::uint8_t{0}, bit);
  }
  recount();
  return true;
}

bool OutputForces::release(const ReleaseOutputCommand& wanted) {
  if (!inside(wanted.bit_offset, wanted.bit_size)) return false;
  for (auto place = wanted.bit_offset; place < wanted.bit_offset + wanted.bit_size; ++place) {
    mask_[place / 8] = static_cast<std::uint8_t>(mask_[place / 8] & ~(1U << (place % 8)));
  }
  recount();
  return true;
}

void OutputForces::release_all() {
  std::ranges::fill(mask_, std::uint8_t{0});
  count_ = 0;
}

void OutputForces::recount() {
  count_ = 0;
  for (const auto byte : mask_) count_ += static_cast<std::uint32_t>(std::popcount(byte));
}

void OutputForces::apply(std::span<std::uint8_t> outputs) {
  if (count_ == 0) return;
  std::ranges::copy(outputs, kept_.begin());
  for (std::size_t i = 0; i < outputs.size(); ++i) outputs[i] = mixed(outputs[i], values_[i], mask_[i]);
}

void OutputForces::restore(std::span<std::uint8_t> outputs) const {
  if (count_ != 0) std::ranges::copy(kept_, outputs.begin());
}

}  // namespace syncline
