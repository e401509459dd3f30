// SPDX-License-Identifier: Apache-2.0
#include "ui/session/calc_and_copy.h"

#include "channels/slave_evidence.h"
#include "config/identity.h"
#include "families/device_family.h"
#include "families/families.h"

namespace syncline::ui {

std::optional<Nanoseconds> calcAndCopy(const Identity& identity, const SlaveEvidence* told) {
  if (told != nullptr && told->calc_and_copy_ns > 0) return told->calc_and_copy_ns;
  const auto* family = families::find(identity);
  return family != nullptr && family->times ? std::optional(family->times->calc_and_copy) : std::nullopt;
}

}  // namespace syncline::ui
