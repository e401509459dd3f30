// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "app/composition/open_link.h"
#include "compile/compile.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/project/project_builder.h"
#include "findings/error_text.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

TEST(AllDevices, AreScannedAndBroughtToOp) {
  const std::string link = "sim:" + test::source_dir() + "/resources/scenarios/all-devices.toml?virtual";
  const auto scan = scan_bus(open_link(link));
  ASSERT_TRUE(scan) << describe(scan.error());
  ASSERT_EQ(scan->slaves.size(), 10U);
  EXPECT_EQ(scan->slaves[9].previous->position, 6) << "three branches leave the junction";
  eni::EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  const auto project = eni::project_from_scan(*scan, catalogue).project;
  std::set<std::string> types;
  for (const auto& slave : project.slaves) types.insert(slave.device.type);
  EXPECT_THAT(types, testing::ElementsAre("SL-1002", "SL-1100", "SL-1122", "SL-2002", "SL-3002", "SL-4002", "SL-6751",
                                          "SL-SV7", "SL-XE2"));
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  RunRequest request;
  request.duration = 15 * kSecond;
  const auto outcome = run_network(compiled->config, open_link(link), request);
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->error) << describe(*outcome->error);
  EXPECT_EQ(outcome->report.state, AlState::kOp);
  EXPECT_EQ(outcome->report.wkc_errors, 0U);
}

}  // namespace
}  // namespace syncline
