// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/round_step.h"

#include <cmath>
#include <initializer_list>

namespace syncline::ui {

double roundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (least <= factor * power * (1 + 1e-9)) return factor * power;
  }
  return 10 * power;
}

}  // namespace syncline::ui
