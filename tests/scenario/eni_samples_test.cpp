// SPDX-License-Identifier: Apache-2.0
// Every ENI of the samples: read, written again, compared, and run on the bus that it describes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/composition/open_link.h"
#include "channels/event.h"
#include "compare/network_compare.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "eni/format/eni_file.h"
#include "findings/error_text.h"
#include "support/sample_folder.h"

namespace syncline {
namespace {

/// Files that cannot be read, and why.
const std::map<std::string, std::string> kNoEni{
    {"robotcontrol-xyz__openethercat__beckhoff_demo.eni.xml", "another format: root element Network"},
    {"another_format.xml", "another format: root element Plant"},
};

/// Files that are read and written but describe no bus that could run.
const std::map<std::string, std::string> kNotComplete{
    {"OpenEtherCATsociety__SOEM__sample-eni.xml", "only CoE commands: no init commands, no cyclic frames"},
    {"jasper-node__jn-ec-master__coe_slave.eni.xml", "fixture of a parser: no init commands"},
    {"jasper-node__jn-ec-master__compliant.eni.xml", "fixture of a parser: no init commands"},
    {"jasper-node__jn-ec-master__no_protocol.eni.xml", "fixture of a parser: no init commands"},
    {"jasper-node__jn-ec-master__protocol_tag_only.eni.xml", "fixture of a parser: no init commands"},
    {"kj4tmp__pyecm__empty.xml", "no slaves"},
    {"fragment.eni.xml", "written by hand: no init commands"},
};

std::vector<std::string> sample_enis() {
  std::vector<std::string> files;
  for (const auto& path : test::all_samples("eni", ".xml")) files.push_back(path.string());
  return files;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::path(info.param).filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

class SampleEni : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    path_ = GetParam();
    name_ = std::filesystem::path(path_).filename().string();
  }
  std::string path_, name_;
};

TEST_P(SampleEni, IsReadAndWrittenAgain) {
  const auto config = eni::read_eni(path_);
  if (const auto excepted = kNoEni.find(name_); excepted != kNoEni.end()) {
    ASSERT_FALSE(config);
    EXPECT_EQ(config.error().code, ErrorCode::kNotThatKindOfFile) << excepted->second;
    return;
  }
  ASSERT_TRUE(config) << describe(config.error());
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    const auto text = eni::write_eni(*config, eni::style_of(dialect));
    const auto again = eni::parse_eni(text, "again.xml");
    ASSERT_TRUE(again) << describe(again.error());
    std::vector<std::string> differences;
    for (const auto& difference : compare_networks(*config, *again, {.image_offsets = true})) {
      differences.push_back(describe(difference));
    }
    EXPECT_THAT(differences, testing::IsEmpty());
    EXPECT_EQ(eni::write_eni(*again, eni::style_of(dialect)), text);
    EXPECT_TRUE(*again == *config) << "something that compare_networks does not look at";
  }
}

/// Those that describe a bus as a whole.
class CompleteEni : public SampleEni {};

std::vector<std::string> complete_enis() {
  auto files = sample_enis();
  std::erase_if(files, [](const std::string& file) {
    const auto name = std::filesystem::path(file).filename().string();
    return kNoEni.contains(name) || kNotComplete.contains(name);
  });
  return files;
}

TEST_P(CompleteEni, RunsOnTheBusThatItDescribes) {
  const auto config = eni::read_eni(path_);
  ASSERT_TRUE(config) << describe(config.error());
  RunRequest request;
  request.duration = 20 * kSecond;
  std::vector<std::string> events;
  request.on_event = [&](const Event& event) {
    if (const auto* failure = event.as<events::Failure>()) events.push_back(describe(failure->error));
  };
  const auto outcome = run_network(*config, open_link("sim:" + path_ + "?virtual"), request);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  EXPECT_FALSE(outcome->error) << describe(*outcome->error);
  EXPECT_EQ(outcome->report.state, AlState::kOp) << testing::PrintToString(events);
  EXPECT_EQ(outcome->report.wkc_errors, 0U);
  EXPECT_GT(outcome->report.cycles, 100U);
}

INSTANTIATE_TEST_SUITE_P(Files, SampleEni, testing::ValuesIn(sample_enis()), test_name);
INSTANTIATE_TEST_SUITE_P(Files, CompleteEni, testing::ValuesIn(complete_enis()), test_name);

}  // namespace
}  // namespace syncline
