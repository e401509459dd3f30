// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace syncline {

struct ForceOutputCommand;
struct ReleaseOutputCommand;

/// Bits of the outputs that somebody holds at a value of his own, whatever the application calculates. Sized once; in
/// a cycle nothing is allocated.
class OutputForces {
 public:
  explicit OutputForces(std::size_t output_bytes) : mask_(output_bytes), values_(output_bytes), kept_(output_bytes) {}

  /// False when it reaches beyond the outputs, or is no value (1 to 64 bits).
  bool force(const ForceOutputCommand& wanted);
  bool release(const ReleaseOutputCommand& wanted);
  void release_all();

  /// For the frames that are filled next; what the application wrote is kept.
  void apply(std::span<std::uint8_t> outputs);
  /// What the application wrote stands there again. After apply().
  void restore(std::span<std::uint8_t> outputs) const;

  [[nodiscard]] std::span<const std::uint8_t> mask() const { return mask_; }
  /// Bits that are forced.
  [[nodiscard]] std::uint32_t count() const { return count_; }

 private:
  [[nodiscard]] bool inside(std::uint32_t bit_offset, std::uint32_t bit_size) const;
  void recount();

  std::vector<std::uint8_t> mask_, values_, kept_;
  std::uint32_t count_ = 0;
};

}  // namespace syncline
