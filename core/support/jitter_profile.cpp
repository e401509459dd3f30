// SPDX-License-Identifier: Apache-2.0
#include "support/jitter_profile.h"

namespace syncline {
namespace {

constexpr double kUs = 1e3;

/// Of a one-sided normal delay.
QuantileCurve one_sided(double sigma) {
  return {{{0, 0},
           {0.25, 0.319 * sigma},
           {0.5, 0.674 * sigma},
           {0.75, 1.15 * sigma},
           {0.9, 1.645 * sigma},
           {0.99, 2.576 * sigma},
           {0.999, 3.29 * sigma},
           {1, 4 * sigma}}};
}

}  // namespace

JitterProfile JitterProfile::quiet() {
  JitterProfile profile;
  profile.wake_up = {
      {{0, 0}, {0.25, 64}, {0.5, 135}, {0.75, 230}, {0.9, 330}, {0.99, 520}, {0.9995, 700}, {1, 2.2 * kUs}}};
  profile.stamp_error = one_sided(33);
  return profile;
}

JitterProfile JitterProfile::desktop() {
  JitterProfile profile;
  profile.wake_up = {{{0, 0},
                      {0.25, 960},
                      {0.5, 2 * kUs},
                      {0.75, 3.4 * kUs},
                      {0.9, 4.9 * kUs},
                      {0.99, 7.7 * kUs},
                      {0.998, 9.3 * kUs},
                      {1, 32 * kUs}}};
  profile.stamp_error = one_sided(500);
  return profile;
}

JitterProfile JitterProfile::bad() {
  JitterProfile profile;
  profile.wake_up = {{{0, 0},
                      {0.25, 6.4 * kUs},
                      {0.5, 13.5 * kUs},
                      {0.75, 23 * kUs},
                      {0.9, 33 * kUs},
                      {0.99, 58 * kUs},
                      {1, 414 * kUs}}};
  profile.stamp_error = one_sided(3300);
  return profile;
}

}  // namespace syncline
