// SPDX-License-Identifier: Apache-2.0
// Puts random defects into good ENIs, and asks the comparison and the checker what they see.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "compare/compare_configs.h"
#include "config/network_config.h"
#include "eni/check/check_bed.h"
#include "eni/mutation/defects.h"
#include "support/sample_folder.h"

namespace syncline::test {
namespace {

struct GoodFile {
  std::string name;
  NetworkConfig config;
  std::multiset<std::string> findings;  // that it has already
};

std::multiset<std::string> findings_of(const std::string& text) {
  std::multiset<std::string> out;
  const auto check = eni::check_eni_text(text, "file.xml");
  if (!check) return {"not checked"};
  for (const auto& finding : check->findings) {
    if (finding.severity != Severity::kNote) out.emplace(fmt::format("{} {}", finding.code, facts_text(finding)));
  }
  return out;
}

GoodFile good_file(std::string name, const NetworkConfig& config) {
  return {std::move(name), config, findings_of(eni::write_eni(config))};
}

std::vector<GoodFile> own_files() {
  return {good_file("machine in EC-Engineer's way", checked_machine()),
          good_file("machine in TwinCAT's way", checked_machine(EniDialect::kTwinCat)),
          good_file("small machine", compile(sample::small_machine())->config)};
}

/// Stored exports that describe a bus as a whole, of ours and, where they are at hand, of other tools.
std::vector<GoodFile> sample_files() {
  std::vector<GoodFile> out;
  for (const char* name : {"row.eni.xml", "drives.eni.xml", "one_line.eni.xml"}) {
    if (const auto config = eni::read_eni((own_samples("eni") / name).string()))
      out.push_back(good_file(name, *config));
  }
  for (const char* name : {"eni/jasper-node__jn-ec-master__mega_master_eni.xml", "eni/kj4tmp__pyecm__basic.xml",
                           "eni/kpierczy__ethercat-lib__test_eni.xml", "eni/magnate3__rocos-ethercat__bcr_eni.xml",
                           "eni/magnate3__rocos-ethercat__eni.xml", "eni/magnate3__rocos-ethercat__eni4.xml"}) {
    const auto path = sample_file(name);
    const auto config = path ? eni::read_eni(*path) : fail(Error{.code = ErrorCode::kFileNotFound});
    if (config) out.push_back(good_file(name, *config));
  }
  return out;
}

std::vector<DefectKind> all_kinds() {
  std::vector<DefectKind> out;
  for (const auto kinds : {slave_defects(), command_defects(), mailbox_defects(), cyclic_defects()})
    out.insert(out.end(), kinds.begin(), kinds.end());
  return out;
}

/// What came of the defects.
struct Account {
  int tried = 0, seen_by_compare = 0, stumbling = 0, found_by_check = 0;
  std::map<std::string, int> missed_by_check;  // kind: count
};

/// `count` random defects, spread over the files; each kind comes about as often as every other.
Account try_defects(const std::vector<GoodFile>& files, int count, std::uint64_t seed) {
  const auto kinds = all_kinds();
  Random random(seed);
  Account account;
  for (std::size_t turn = 0; account.tried < count; ++turn) {
    const GoodFile& good = files[pick(random, files.size())];
    const DefectKind& kind = kinds[turn % kinds.size()];
    NetworkConfig bad = good.config;
    if (!kind.apply(bad, random)) continue;
    ++account.tried;
    const std::string text = eni::write_eni(bad);
    const auto read = eni::parse_eni(text, "bad.xml");
    // A file that cannot be read at all is told by both.
    const bool compared = !read || !compare_configs(good.config, *read).empty();
    if (compared) ++account.seen_by_compare;
    EXPECT_TRUE(compared) << "compare: " << kind.name << " in " << good.name << ", seed " << seed << ", no. "
                          << account.tried;
    if (!kind.stumbles) continue;
    ++account.stumbling;
    const auto found = findings_of(text);
    const bool more = std::ranges::any_of(
        found, [&](const std::string& finding) { return found.count(finding) > good.findings.count(finding); });
    if (more) {
      ++account.found_by_check;
    } else {
      ++account.missed_by_check[fmt::format("{} in {}", kind.name, good.name)];
    }
  }
  return account;
}

void expect_good(const Account& account, int count) {
  EXPECT_EQ(account.seen_by_compare, count);
  std::string missed;
  for (const auto& [kind, times] : account.missed_by_check) missed += fmt::format("\n  {} x {}", times, kind);
  EXPECT_GE(account.found_by_check * 100, account.stumbling * 95) << "check misses:" << missed;
  fmt::print("{} defects: compare sees {}; {} that a master or slave stumbles over, check finds {} ({:.1f} %){}\n",
             count, account.seen_by_compare, account.stumbling, account.found_by_check,
             100.0 * account.found_by_check / std::max(1, account.stumbling), missed);
}

TEST(Mutation, TwoHundredDefectsInFilesOfOurs) { expect_good(try_defects(own_files(), 200, 1), 200); }

TEST(Mutation, OtherDefectsInFilesOfOurs) { expect_good(try_defects(own_files(), 200, 20260722), 200); }

TEST(Mutation, TwoHundredDefectsInStoredFiles) {
  const auto files = sample_files();
  ASSERT_GE(files.size(), 3U);
  expect_good(try_defects(files, 200, 2), 200);
}

/// Every kind can be put into one of our files, so that none is asked in vain.
TEST(Mutation, EachKindHasAPlace) {
  const auto files = own_files();
  for (const DefectKind& kind : all_kinds()) {
    bool applied = false;
    for (std::uint64_t seed = 1; seed < 20 && !applied; ++seed) {
      Random random(seed);
      NetworkConfig config = files[seed % files.size()].config;
      const NetworkConfig before = config;
      applied = kind.apply(config, random) && !(config == before);
    }
    EXPECT_TRUE(applied) << kind.name;
  }
}

}  // namespace
}  // namespace syncline::test
