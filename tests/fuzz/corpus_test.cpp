// SPDX-License-Identifier: Apache-2.0
// The fuzz targets as ordinary tests: their corpora, and thousands of damaged inputs, the same in each run.
#include <gtest/gtest.h>

#include <algorithm>

#include "fuzz/kept_corpus.h"
#include "fuzz/targets.h"
#include "support/random.h"

namespace syncline::fuzz {
namespace {

class FuzzTargets : public testing::TestWithParam<Target> {};

/// A read beyond the end leaves the allocation, so that a sanitizer sees it.
void run(const Target& target, Bytes bytes) {
  bytes.shrink_to_fit();
  target.run(bytes);
}

TEST_P(FuzzTargets, SurviveTheirCorpusAndThousandsOfDamagedInputs) {
  const auto& target = GetParam();
  const auto corpus = target.corpus();
  ASSERT_FALSE(corpus.empty());
  Random random(20'261'121);
  const auto rounds = target.test_runs / corpus.size() + 1;
  for (const auto& good : corpus) {
    run(target, good);
    auto bytes = good;
    for (std::size_t i = 0; i < rounds; ++i) {
      // Damage upon damage goes further, and further away from what is good.
      bytes = target.damage(i % 4 == 0 ? good : bytes, random);
      run(target, bytes);
    }
  }
}

/// Each of them is the only one to reach something, with what a fuzzer knew when it was found.
TEST_P(FuzzTargets, SurviveWhatAFuzzerHasFound) {
  const auto kept = kept_corpus(GetParam().name);
  const auto corpus = GetParam().corpus();
  const bool too_large = std::ranges::all_of(corpus, [](const Bytes& good) { return good.size() > kMostKept; });
  ASSERT_TRUE(!kept.empty() || too_large) << "scripts/fuzz --keep";
  std::size_t bytes = 0;
  for (const auto& input : kept) {
    bytes += input.size();
    run(GetParam(), input);
  }
  EXPECT_LE(bytes, kMostKept);
}

TEST_P(FuzzTargets, SurviveRandomBytesOfEveryLength) {
  Random random(7);
  const auto longest = std::min<std::size_t>(600, GetParam().test_runs);
  for (std::size_t length = 0; length < longest; ++length) {
    Bytes bytes(length);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
    run(GetParam(), bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzTargets, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace syncline::fuzz
