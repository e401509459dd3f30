// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "config/identity.h"
#include "protocol/coe.h"

namespace syncline::ui {

class WindowMemory;

/// The objects that the user looks at in every device of a kind, in whatever project: kept with what the window
/// remembers, by vendor and product.
class FavouriteObjects {
 public:
  explicit FavouriteObjects(WindowMemory& memory) : memory_(memory) {}

  [[nodiscard]] std::vector<coe::ObjectAddress> of(const Identity& device) const;
  /// In place of those that were; none: the kind has none any more.
  void set(const Identity& device, const std::vector<coe::ObjectAddress>& objects);

 private:
  WindowMemory& memory_;
};

}  // namespace syncline::ui
