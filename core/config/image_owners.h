// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace syncline {

struct ImageRange;
struct NetworkConfig;

/// Whose process data stands where in the process image. Pure; valid for the configuration it was made of.
class ImageOwners {
 public:
  explicit ImageOwners(const NetworkConfig& config);

  /// The slave to which a bit of the image belongs; nothing for those of no slave (padding, the master's own).
  [[nodiscard]] std::optional<std::size_t> of_output(std::uint32_t bit) const { return find(outputs_, bit); }
  [[nodiscard]] std::optional<std::size_t> of_input(std::uint32_t bit) const { return find(inputs_, bit); }

 private:
  struct Piece {
    std::uint32_t begin = 0, length = 0;  // bits
    std::size_t slave = 0;
  };
  static void add(std::vector<Piece>& pieces, const std::optional<ImageRange>& whole,
                  const std::vector<ImageRange>& parts, std::size_t slave);
  [[nodiscard]] static std::optional<std::size_t> find(const std::vector<Piece>& pieces, std::uint32_t bit);

  std::vector<Piece> outputs_, inputs_;  // by begin
};

}  // namespace syncline
