// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct Finding;
}  // namespace syncline

namespace syncline::eni {

class XmlPieces;

/// Findings of the families ENI-XML and ENI-REF-01: element order, counts and types against eni_schema(), and previous
/// ports that lead nowhere, which a NetworkConfig cannot hold.
[[nodiscard]] std::vector<Finding> check_structure(XmlPieces& pieces);

}  // namespace syncline::eni
