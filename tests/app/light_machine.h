// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/support/source_dir.h"

namespace syncline::test {

/// A scenario that takes next to nothing of the processor, so that many may run at once: a coupler and its outputs.
inline std::string light_machine() {
  const auto esi = source_dir() + "/resources/esi/";
  return "[[slave]]\nname = \"Coupler\"\ndc = \"none\"\nesi = \"" + esi +
         "SL-1100.xml\"\n[[slave]]\nname = \"Outputs\"\ndc = \"none\"\nparent = 0\nport = \"B\"\nesi = \"" + esi +
         "SL-2002.xml\"\n";
}

}  // namespace syncline::test
