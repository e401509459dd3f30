// SPDX-License-Identifier: Apache-2.0
#include "config/image_owners.h"

#include <algorithm>

#include "config/network_config.h"
#include "config/process_image.h"

namespace syncline {

ImageOwners::ImageOwners(const NetworkConfig& config) {
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto& slave = config.slaves[i];
    add(outputs_, slave.send, slave.send_parts, i);
    add(inputs_, slave.receive, slave.receive_parts, i);
  }
  std::ranges::stable_sort(outputs_, {}, &Piece::begin);
  std::ranges::stable_sort(inputs_, {}, &Piece::begin);
}

void ImageOwners::add(std::vector<Piece>& pieces, const std::optional<ImageRange>& whole,
                      const std::vector<ImageRange>& parts, std::size_t slave) {
  for (const auto& part : parts) pieces.push_back({part.bit_start, part.bit_length, slave});
  if (parts.empty() && whole) pieces.push_back({whole->bit_start, whole->bit_length, slave});
}

std::optional<std::size_t> ImageOwners::find(const std::vector<Piece>& pieces, std::uint32_t bit) {
  const auto after = std::ranges::upper_bound(pieces, bit, {}, &Piece::begin);
  if (after == pieces.begin()) return std::nullopt;
  const auto& piece = *std::prev(after);
  return bit - piece.begin < piece.length ? std::optional(piece.slave) : std::nullopt;
}

}  // namespace syncline
