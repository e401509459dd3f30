// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "channels/latest_box.h"
#include "support/types.h"

namespace syncline {

/// What stands in the process image of the running bus: one byte for each of the configuration's (struct ProcessImage).
struct ImageContents {
  std::uint64_t cycle = 0;      // the outputs go out with this one; counts from going online
  Nanoseconds time = 0;         // its send time, host clock
  Nanoseconds inputs_time = 0;  // of the cycle in which all inputs came back last with the expected working counter; 0
                                // = not yet. Where a counter is wrong, the inputs of its datagram keep what they were.
  std::size_t input_bytes = 0;
  std::vector<std::uint8_t>
      bytes;  // inputs, outputs as they are sent, and a 1 for each bit of the outputs that is forced

  [[nodiscard]] std::size_t output_bytes() const { return (bytes.size() - input_bytes) / 2; }
  [[nodiscard]] std::span<const std::uint8_t> inputs() const { return std::span(bytes).first(input_bytes); }
  [[nodiscard]] std::span<const std::uint8_t> outputs() const {
    return std::span(bytes).subspan(input_bytes, output_bytes());
  }
  [[nodiscard]] std::span<const std::uint8_t> forced() const {
    return std::span(bytes).subspan(input_bytes + output_bytes());
  }
};

[[nodiscard]] inline std::size_t room_of(const ImageContents& image) { return image.bytes.size(); }
inline void make_room(ImageContents& image, std::size_t bytes) { image.bytes.reserve(bytes); }

using ImageBox = LatestBox<ImageContents>;

}  // namespace syncline
