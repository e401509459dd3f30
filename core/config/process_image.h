// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Inputs and outputs of all slaves, and where they lie: offsets in bits and bytes (ETG.2100, ProcessImage).
namespace syncline {

/// Piece of the process image in bits.
struct ImageRange {
  std::uint32_t bit_start = 0;
  std::uint32_t bit_length = 0;
  std::uint16_t sync_managers = 0;  // ENI Send@Sm0..Sm15 as bits; 0 = not said
  bool operator==(const ImageRange&) const = default;
  /// Some of it lies in these bytes of the image.
  [[nodiscard]] bool touches(std::uint64_t first_byte, std::uint64_t bytes) const {
    return bit_length > 0 && bit_start < (first_byte + bytes) * 8 &&
           std::uint64_t{bit_start} + bit_length > first_byte * 8;
  }
};

struct Variable {
  std::string name;
  std::string data_type;
  std::string comment;
  std::uint32_t bit_size = 0;
  std::uint32_t bit_offset = 0;
  bool operator==(const Variable&) const = default;
};

struct ProcessImage {
  std::uint32_t input_bytes = 0;
  std::uint32_t output_bytes = 0;
  std::vector<Variable> inputs, outputs;
  /// Bytes from CyclicCmd::input_offset and output_offset to the datagram's data in the image: 0 where a tool counts
  /// the data (EC-Engineer), 10 where it counts datagram headers (ET9000, TwinCAT).
  std::uint32_t command_data_offset = 0;
  bool operator==(const ProcessImage&) const = default;
};

}  // namespace syncline
