// SPDX-License-Identifier: Apache-2.0
#include "tests/support/source_dir.h"

namespace syncline::test {

std::string source_dir() { return SYNCLINE_SOURCE_DIR; }

}  // namespace syncline::test
