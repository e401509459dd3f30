// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::test {

/// How many of `all` cases alike a test goes through in this build: all of them, but a quarter with a sanitizer. Each
/// goes the same way through the code, ten times as slowly; what a sanitizer sees in a few of them it would see in all.
constexpr int cases(int all) {
#if defined(SYNCLINE_SANITIZED)
  return (all + 3) / 4;
#else
  return all;
#endif
}

/// Of long rows of things alike (all settings, all values of a file) every so-manyth is gone through; 1: each. Which
/// are left out with a sanitizer, the release build goes through.
constexpr int kEvery = 4 / cases(4);

}  // namespace syncline::test
