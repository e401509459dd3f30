// SPDX-License-Identifier: Apache-2.0
// The fuzz targets as ordinary tests: their corpora, and thousands of damaged inputs, the same in each run.
#include <gtest/gtest.h>

#include <algorithm>

#include "fuzz/targets.h"
#include "fuzz/xml_damage.h"
#include "support/random.h"

namespace syncline::fuzz {
namespace {

class FuzzTargets : public testing::TestWithParam<Target> {};

/// A few bytes changed, cut off or doubled: further into a parser than random bytes come.
Bytes damage(const Bytes& good, Random& random) {
  auto bytes = good;
  for (auto changes = random.next() % 4 + 1; changes > 0 && !bytes.empty(); --changes) {
    auto& byte = bytes[random.next() % bytes.size()];
    byte = random.next() % 3 == 0 ? std::uint8_t{0xFF} : static_cast<std::uint8_t>(random.next());
  }
  if (random.next() % 3 == 0) bytes.resize(random.next() % (bytes.size() + 1));
  if (random.next() % 5 == 0) bytes.insert(bytes.end(), good.begin(), good.end());
  bytes.shrink_to_fit();  // a read beyond the end leaves the allocation
  return bytes;
}

Bytes damage_text(const Bytes& good, Random& random) {
  const auto text = damage_xml({reinterpret_cast<const char*>(good.data()), good.size()}, random);
  return {text.begin(), text.end()};
}

TEST_P(FuzzTargets, SurviveTheirCorpusAndThousandsOfDamagedInputs) {
  const auto& target = GetParam();
  const auto corpus = target.corpus();
  ASSERT_FALSE(corpus.empty());
  Random random(20'261'121);
  for (const auto& good : corpus) {
    target.run(good);
    // A text takes longer than a frame, and a text of many devices longer than one of a few.
    const auto rounds = std::clamp<std::size_t>(4'000'000 / good.size(), 100, 3'000);
    for (std::size_t i = 0; i < rounds; ++i) {
      target.run(target.is_xml && i % 8 != 0 ? damage_text(good, random) : damage(good, random));
    }
  }
}

TEST_P(FuzzTargets, SurviveRandomBytesOfEveryLength) {
  Random random(7);
  for (std::size_t length = 0; length < 600; ++length) {
    Bytes bytes(length);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
    GetParam().run(bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzTargets, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace syncline::fuzz
