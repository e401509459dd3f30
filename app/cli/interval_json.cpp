// SPDX-License-Identifier: Apache-2.0
#include "app/cli/interval_json.h"

#include <cmath>

#include "support/confidence.h"

namespace syncline::cli {

Json interval_json(const std::optional<Interval>& interval, bool fine) {
  if (!interval) return nullptr;
  const double scale = fine ? 1e6 : 1e3;
  return Json::array({std::floor(interval->low * scale) / scale, std::ceil(interval->high * scale) / scale});
}

}  // namespace syncline::cli
