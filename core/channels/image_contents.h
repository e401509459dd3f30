// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "channels/latest_box.h"
#include "support/types.h"

namespace syncline {

/// What stands in the process image of the running bus: one byte for each of the configuration's (ProcessImage).
class ImageContents {
 public:
  std::uint64_t cycle = 0;      // the outputs go out with this one; counts from going online
  Nanoseconds time = 0;         // its send time, host clock; 0: no cycle yet
  std::size_t input_bytes = 0;  // of the two parts of `bytes` that are of inputs
  /// Inputs; a 1 for each of their bits that came back lately with the expected working counter (the others keep what
  /// they were); outputs as they are sent; a 1 for each of their bits that is forced.
  std::vector<std::uint8_t> bytes;

  [[nodiscard]] std::size_t output_bytes() const { return bytes.size() / 2 - input_bytes; }
  [[nodiscard]] std::span<const std::uint8_t> inputs() const { return part(0, input_bytes); }
  [[nodiscard]] std::span<const std::uint8_t> known() const { return part(input_bytes, input_bytes); }
  [[nodiscard]] std::span<const std::uint8_t> outputs() const { return part(2 * input_bytes, output_bytes()); }
  [[nodiscard]] std::span<const std::uint8_t> forced() const {
    return part(2 * input_bytes + output_bytes(), output_bytes());
  }

 private:
  [[nodiscard]] std::span<const std::uint8_t> part(std::size_t first, std::size_t count) const {
    return std::span(bytes).subspan(first, count);
  }
};

[[nodiscard]] inline std::size_t room_of(const ImageContents& image) { return image.bytes.size(); }
inline void make_room(ImageContents& image, std::size_t bytes) { image.bytes.reserve(bytes); }

using ImageBox = LatestBox<ImageContents>;

}  // namespace syncline
