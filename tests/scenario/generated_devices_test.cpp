// SPDX-License-Identifier: Apache-2.0
// Devices that nobody wrote for the simulator: out of EEPROM images and ESI files, and many of them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/composition/open_link.h"
#include "compile/compile.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/project/project_builder.h"
#include "findings/error_text.h"
#include "support/sample_folder.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

std::string scenario(const std::string& name) { return test::source_dir() + "/resources/scenarios/" + name; }

/// A scenario file of the test's own.
class ScenarioFile {
 public:
  explicit ScenarioFile(const std::string& text)
      : path_(fs::temp_directory_path() / ("syncline-generated-" + std::to_string(::getpid()) + ".toml")) {
    std::ofstream(path_) << text;
  }
  ~ScenarioFile() { fs::remove(path_); }
  ScenarioFile(const ScenarioFile&) = delete;
  ScenarioFile& operator=(const ScenarioFile&) = delete;
  [[nodiscard]] std::string link() const { return "sim:" + path_.string() + "?virtual"; }

 private:
  fs::path path_;
};

struct IndexRow {
  std::string file;
  std::uint32_t vendor = 0, product = 0, revision = 0;
};

/// The rows whose note says "vendor=0x.. product=0x.. rev=0x..".
std::vector<IndexRow> read_index(const std::string& path) {
  std::ifstream in(path);
  std::vector<IndexRow> rows;
  for (std::string line; std::getline(in, line);) {
    const auto number = [&line](const std::string& name) {
      const auto at = line.find(name);
      return at == std::string::npos ? 0UL : std::stoul(line.substr(at + name.size()), nullptr, 16);
    };
    const auto vendor = number("vendor=");
    if (vendor == 0) continue;
    rows.push_back({line.substr(0, line.find('\t')), static_cast<std::uint32_t>(vendor),
                    static_cast<std::uint32_t>(number("product=")), static_cast<std::uint32_t>(number("rev="))});
  }
  return rows;
}

TEST(GeneratedDevices, BusOfAllEepromImagesShowsTheirIdentities) {
  const auto others = test::sample_file("sii/INDEX.tsv");
  const std::string index = others.value_or((test::own_samples("sii") / "INDEX.tsv").string());
  const auto folder = fs::path(index).parent_path();
  std::string text;
  std::vector<IndexRow> used;
  for (const auto& row : read_index(index)) {
    if (fs::path(row.file).extension() != ".bin") continue;  // the others are the same as text
    text += "[[slave]]\nsii = '" + (folder / row.file).string() + "'\n\n";
    used.push_back(row);
  }
  ASSERT_GT(used.size(), others ? 10U : 5U);
  const ScenarioFile file(text);
  const auto scan = scan_bus(open_link(file.link()));
  ASSERT_TRUE(scan) << describe(scan.error());
  ASSERT_EQ(scan->slaves.size(), used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    const auto& identity = scan->slaves[i].identity;
    EXPECT_EQ(identity.vendor_id, used[i].vendor) << used[i].file;
    EXPECT_EQ(identity.product_code, used[i].product) << used[i].file;
    EXPECT_EQ(identity.revision_no, used[i].revision) << used[i].file;
  }
}

TEST(GeneratedDevices, EsiFilesOfTheFieldBecomeSlavesThatReachPreop) {
  eni::EsiCatalogue catalogue;
  std::size_t reached = 0, files = 0;
  const auto others = test::sample_file("esi");
  for (const auto& entry : fs::directory_iterator(others.value_or(test::source_dir() + "/resources/esi"))) {
    // The largest files have hundreds of devices; the first of a file stands for its style.
    if (entry.path().extension() != ".xml" || ++files > 40) continue;
    const ScenarioFile file("[[slave]]\nesi = '" + entry.path().string() + "'\n");
    const auto scan = scan_bus(open_link(file.link()));
    if (!scan) continue;  // EtherCAT modules and files without devices
    ASSERT_EQ(scan->slaves.size(), 1U);
    EXPECT_FALSE(scan->slaves[0].sii_error) << entry.path() << describe(*scan->slaves[0].sii_error);
    auto project = eni::project_from_scan(*scan, catalogue).project;
    const auto compiled = compile(project);
    ASSERT_TRUE(compiled) << entry.path();
    RunRequest request;
    request.target = AlState::kPreop;
    request.duration = 5 * kSecond;
    const auto outcome = run_network(compiled->config, open_link(file.link()), request);
    ASSERT_TRUE(outcome) << entry.path();
    EXPECT_EQ(outcome->report.state, AlState::kPreop)
        << entry.path() << ": " << (outcome->error ? describe(*outcome->error) : "");
    reached += outcome->report.state == AlState::kPreop ? 1 : 0;
  }
  EXPECT_GT(reached, others ? 10U : 5U);
}

TEST(LargeScenarios, ThousandSlavesAreScannedAndBroughtToOp) {
  const auto link = "sim:" + scenario("thousand.toml") + "?virtual";
  const auto scan = scan_bus(open_link(link));
  ASSERT_TRUE(scan) << describe(scan.error());
  ASSERT_EQ(scan->slaves.size(), 1'000U);
  EXPECT_EQ(scan->slaves[999].previous->position, 998);
  eni::EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  auto project = eni::project_from_scan(*scan, catalogue).project;
  project.master.cycle_time = 4 * kMillisecond;
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  RunRequest request;
  request.duration = 20 * kSecond;
  const auto outcome = run_network(compiled->config, open_link(link), request);
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->error) << describe(*outcome->error);
  EXPECT_EQ(outcome->report.state, AlState::kOp);
  EXPECT_EQ(outcome->report.wkc_errors, 0U);
}

TEST(LargeScenarios, NetworksOfOneScenarioDifferOnlyInTheirRandomProcesses) {
  const auto link = "sim:" + scenario("sixteen-networks.toml") + "?virtual&network=";
  for (const auto* network : {"0", "7", "15"}) {
    const auto scan = scan_bus(open_link(link + network));
    ASSERT_TRUE(scan) << describe(scan.error());
    EXPECT_EQ(scan->slaves.size(), 100U);
  }
  const auto beyond = scan_bus(open_link(link + "16"));
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, ErrorCode::kBadValue);
}

}  // namespace
}  // namespace syncline
