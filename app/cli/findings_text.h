// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <vector>

#include "app/cli/json.h"

namespace syncline {
struct Finding;
struct Place;
}  // namespace syncline

namespace syncline::cli {

/// `code`, `severity`, `slave`, `key`, `text`, `place`, `evidence` (docs/json.md).
[[nodiscard]] Json to_json(const Finding& finding);
[[nodiscard]] Json to_json(const std::vector<Finding>& findings);
/// Where it belongs: `slave`, `key`, `line`, `path`; what its finder does not know is null.
[[nodiscard]] Json place_json(const Place& place);
/// The figures by name, whose end says the unit.
[[nodiscard]] Json figures_json(const Finding& finding);
/// One line a finding; what many slaves have alike is one line.
void print(std::ostream& out, const std::vector<Finding>& findings);

}  // namespace syncline::cli
