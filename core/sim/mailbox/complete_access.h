// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace syncline::coe {
struct ObjectAddress;
}  // namespace syncline::coe

namespace syncline::sim {

class ObjectDictionary;

/// All entries of an object as one image (ETG.1000.6, 5.6.2 "complete access"): from sub-index 0 it begins with
/// the number of entries in 16 bits, then the entries follow, packed by their length in bits.
/// Abort code or 0.
std::uint32_t read_complete(ObjectDictionary& dictionary, const coe::ObjectAddress& object,
                            std::vector<std::uint8_t>& out);

/// Writes an image. An object whose number of entries can be written (PDO mapping and assignment) is emptied
/// first and gets its number last. Abort code or 0; entries before the one that is refused keep their new value,
/// as in a device that writes one after the other.
std::uint32_t write_complete(ObjectDictionary& dictionary, const coe::ObjectAddress& object,
                             std::span<const std::uint8_t> image, bool in_preop);

}  // namespace syncline::sim
