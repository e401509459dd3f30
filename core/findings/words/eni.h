// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "findings/words/eni_commands.h"
#include "findings/words/eni_cyclic.h"
#include "findings/words/eni_devices.h"
#include "findings/words/eni_image.h"
#include "findings/words/eni_slaves.h"
#include "findings/words/eni_structure.h"
#include "findings/words/joined.h"

namespace syncline::words {

/// The rules of the ENI checker, in the order of docs/check.md. Codes are stable: one that is no longer used is not
/// given to another rule.
inline constexpr auto kEni = joined(kEniStructure, kEniSlaves, kEniCommands, kEniCyclic, kEniImage, kEniDevices);

}  // namespace syncline::words
