// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

// Made once, in json.cpp: every file that prints JSON would compile all of it again.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace syncline::cli {

/// Keys keep the order in which they are written, so that the output is stable and readable.
using Json = nlohmann::ordered_json;

}  // namespace syncline::cli
