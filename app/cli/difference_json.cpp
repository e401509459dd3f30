// SPDX-License-Identifier: Apache-2.0
#include "app/cli/difference_json.h"

#include "compare/network_compare.h"

namespace syncline::cli {

Json differences_json(const std::vector<NetworkDifference>& differences) {
  Json rows = Json::array();
  for (const auto& d : differences) {
    rows.push_back({{"where", d.where}, {"field", d.field}, {"left", d.left}, {"right", d.right}});
  }
  return rows;
}

}  // namespace syncline::cli
