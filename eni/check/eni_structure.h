// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <vector>

#include "findings/finding.h"

namespace syncline::eni {

/// Findings of the families ENI-XML and ENI-REF-01: element order, counts and types against eni_schema(), and previous
/// ports that lead nowhere, which a NetworkConfig cannot hold.
[[nodiscard]] std::vector<Finding> check_structure(const tinyxml2::XMLElement& root);

}  // namespace syncline::eni
