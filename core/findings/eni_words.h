// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "findings/eni_commands_words.h"
#include "findings/eni_cyclic_words.h"
#include "findings/eni_devices_words.h"
#include "findings/eni_image_words.h"
#include "findings/eni_slaves_words.h"
#include "findings/eni_structure_words.h"
#include "findings/joined_words.h"

namespace syncline::words {

/// The rules of the ENI checker, in the order of docs/check.md. Codes are stable: one that is no longer used is not
/// given to another rule.
inline constexpr auto kEni = joined(kEniStructure, kEniSlaves, kEniCommands, kEniCyclic, kEniImage, kEniDevices);

}  // namespace syncline::words
