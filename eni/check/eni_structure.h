// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {
class FindingList;
}  // namespace syncline

namespace syncline::eni {

class XmlPieces;

/// Findings of the families ENI-XML and ENI-REF-01: the encoding, element order, counts and types against eni_schema(),
/// and previous ports that lead nowhere, which a NetworkConfig cannot hold.
void check_structure(XmlPieces& pieces, FindingList& findings);

}  // namespace syncline::eni
