// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// What a message of the diagnosis history is (ETG.1020, 16): low bits of its flags.
enum class DiagnosisMessageType : std::uint8_t { kInfo = 0, kWarning = 1, kError = 2 };

}  // namespace syncline
