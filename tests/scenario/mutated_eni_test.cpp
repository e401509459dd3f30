// SPDX-License-Identifier: Apache-2.0
// Which defects trip a master or a slave is not ours to say: each damaged file is run on the bus of the good one, and
// what does not come to OP with right working counters has to be found by the checker, in the file alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/composition/open_link.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "eni/check/eni_check.h"
#include "eni/format/eni_file.h"
#include "eni/xml/xml_text.h"
#include "support/eni_values.h"
#include "support/random.h"
#include "support/sample_folder.h"
#include "tests/support/cases.h"

namespace syncline {
namespace {

std::size_t findings(const std::string& text) {
  const auto check = eni::check_eni_text(text, "file.xml");
  if (!check) return 1;
  return static_cast<std::size_t>(
      std::ranges::count_if(check->findings, [](const auto& finding) { return finding.severity != Severity::kNote; }));
}

bool runs(const NetworkConfig& config, const std::string& bus) {
  RunRequest request;
  request.duration = 4 * kSecond;
  const auto outcome = run_network(config, open_link("sim:" + bus + "?virtual"), request);
  return outcome && !outcome->error && outcome->report.state == AlState::kOp && outcome->report.wkc_errors == 0;
}

/// Line of the text around a place, for whoever reads the failure.
std::string around(const std::string& text, std::size_t at) {
  const auto begin = text.rfind("<Comment>", at);
  const auto element = text.rfind('<', at);
  return fmt::format("{} ... {}", text.substr(begin == std::string::npos ? element : begin, 60),
                     text.substr(element, text.find('\n', at) - element));
}

class MutatedEni : public testing::TestWithParam<std::uint64_t> {};

TEST_P(MutatedEni, WhatTripsOurMasterOrBusIsFound) {
  constexpr int kWanted = test::cases(40);  // files that do not run
  Random random(GetParam());
  int tried = 0, stumbled = 0, found = 0;
  std::string missed;
  std::vector<std::string> paths;
  for (const char* name : {"row.eni.xml", "drives.eni.xml"})
    paths.push_back((test::own_samples("eni") / name).string());
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    texts.push_back(*eni::read_file(path));
    ASSERT_TRUE(runs(*eni::parse_eni(texts.back(), path), path)) << path;
    ASSERT_EQ(findings(texts.back()), 0U) << path;
  }
  while (stumbled < kWanted && tried < 20 * kWanted) {
    ++tried;
    const std::size_t file = random.next() % paths.size();
    std::string text = texts[file];
    const auto places = test::values_of(text);
    const test::EniValue place = places[random.next() % places.size()];
    const std::size_t digit = place.at + random.next() % place.length;
    text[digit] = static_cast<char>('0' + (text[digit] - '0' + 1 + static_cast<int>(random.next() % 9)) % 10);
    if (text == texts[file]) continue;
    const auto config = eni::parse_eni(text, "bad.xml");
    if (config && runs(*config, paths[file])) continue;
    ++stumbled;
    if (findings(text) > 0) {
      ++found;
    } else {
      missed += fmt::format("\n  {}: {}", paths[file].substr(paths[file].rfind('/') + 1), around(text, digit));
    }
  }
  fmt::print("{} values changed, {} files do not run any more, check finds {} ({:.1f} %){}\n", tried, stumbled, found,
             100.0 * found / std::max(1, stumbled), missed);
  EXPECT_EQ(stumbled, kWanted);
  EXPECT_LE(stumbled - found, (kWanted + 19) / 20) << missed;  // 95 of a hundred
}

INSTANTIATE_TEST_SUITE_P(Seeds, MutatedEni, testing::Values(7U, 8U, 9U));

}  // namespace
}  // namespace syncline
