// SPDX-License-Identifier: Apache-2.0
#include "support/jitter_profile.h"

namespace syncline {
namespace {

constexpr double kUs = 1e3, kMs = 1e6;

}  // namespace

// Where the numbers come from: docs/scenarios.md, "Hosts". What lies between two measured parts is a straight line.

JitterProfile JitterProfile::quiet() {
  JitterProfile profile;
  profile.wake_up = {
      {{0, 0.05 * kUs}, {0.5, 0.5 * kUs}, {0.9, 1 * kUs}, {0.99, 5 * kUs}, {0.999, 12 * kUs}, {1, 40 * kUs}}};
  profile.stamp_error = {
      {{0, 0}, {0.5, 0.3 * kUs}, {0.9, 0.8 * kUs}, {0.99, 3 * kUs}, {0.999, 12 * kUs}, {1, 72 * kUs}}};
  return profile;
}

JitterProfile JitterProfile::desktop() {
  JitterProfile profile;
  profile.wake_up = {
      {{0, 2 * kUs}, {0.5, 16.4 * kUs}, {0.9, 19.5 * kUs}, {0.99, 29.7 * kUs}, {0.999, 205 * kUs}, {1, 450 * kUs}}};
  profile.stamp_error = {{{0, 0},
                          {0.1, 1.2 * kUs},
                          {0.5, 2.5 * kUs},
                          {0.9, 3.6 * kUs},
                          {0.99, 4.7 * kUs},
                          {0.999, 6.8 * kUs},
                          {0.9999, 31 * kUs},
                          {1, 44 * kUs}}};
  return profile;
}

JitterProfile JitterProfile::bad() {
  JitterProfile profile;
  profile.wake_up = {
      {{0, 2 * kUs}, {0.5, 17.4 * kUs}, {0.9, 22.5 * kUs}, {0.99, 74 * kUs}, {0.999, 442 * kUs}, {1, 1500 * kUs}}};
  profile.stamp_error = {{{0, 0},
                          {0.1, 1 * kUs},
                          {0.5, 2.4 * kUs},
                          {0.9, 3.4 * kUs},
                          {0.99, 5.1 * kUs},
                          {0.999, 10.5 * kUs},
                          {0.9999, 74 * kUs},
                          {1, 157 * kUs}}};
  profile.stalls_per_second = 0.5;
  profile.stall = {{{0, 1.5 * kMs}, {0.5, 2.1 * kMs}, {0.9, 4.6 * kMs}, {1, 7.6 * kMs}}};
  return profile;
}

}  // namespace syncline
