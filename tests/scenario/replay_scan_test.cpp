// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

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

std::string demo() { return "sim:" + test::source_dir() + "/resources/demo/machine.toml?virtual"; }

/// A capture of the demonstration machine's bring-up.
class OwnCapture : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }
  std::string path_ = (fs::temp_directory_path() / ("syncline-own-" + std::to_string(::getpid()) + ".pcapng")).string();
};

TEST_F(OwnCapture, ScanOfTheCaptureIsTheScanOfTheBusAsFarAsItWasLookedAt) {
  const auto scan = scan_bus(open_link(demo()));
  ASSERT_TRUE(scan);
  eni::EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  const auto compiled = compile(eni::project_from_scan(*scan, catalogue).project);
  ASSERT_TRUE(compiled);
  RunRequest request;
  request.target = AlState::kPreop;
  request.duration = 8 * kSecond;
  request.capture = path_;
  ASSERT_TRUE(run_network(compiled->config, open_link(demo()), request));

  const auto replayed = scan_bus(open_link("replay:" + path_));
  ASSERT_TRUE(replayed) << describe(replayed.error());
  ASSERT_EQ(replayed->slaves.size(), scan->slaves.size());
  for (std::size_t i = 0; i < scan->slaves.size(); ++i) {
    // The bring-up checks vendor and product only.
    EXPECT_EQ(replayed->slaves[i].identity.vendor_id, scan->slaves[i].identity.vendor_id) << i;
    EXPECT_EQ(replayed->slaves[i].identity.product_code, scan->slaves[i].identity.product_code) << i;
  }
}

struct Known {
  const char* file;
  std::vector<std::uint32_t> products;
};
void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

class RecordedBuses : public testing::TestWithParam<Known> {};

TEST_P(RecordedBuses, AreScannedFromTheirCaptures) {
  SYNCLINE_SAMPLE(path, std::string("pcap/") + GetParam().file);
  const auto scan = scan_bus(open_link("replay:" + path));
  ASSERT_TRUE(scan) << describe(scan.error());
  std::vector<std::uint32_t> products;
  for (const auto& slave : scan->slaves) products.push_back(slave.identity.product_code);
  EXPECT_EQ(products, GetParam().products);
}

constexpr std::uint32_t kEk1100 = 0x044C2C52, kEk1914 = 0x077A2C52, kEl1004 = 0x03EC3052, kEl2004 = 0x07D43052,
                        kEl2828 = 0x0B0C3052, kEl2889 = 0x0B493052, kEl3004 = 0x0BBC3052;

// What stands in the captures' names: terminals of Beckhoff, an AKD drive, a bare LAN9252.
INSTANTIATE_TEST_SUITE_P(
    Samples, RecordedBuses,
    testing::Values(Known{"ethercrab-rs__ethercrab__replay-ek1100-el2828-el2889.pcapng", {kEk1100, kEl2828, kEl2889}},
                    Known{"ethercrab-rs__ethercrab__replay-ek1914-el3004-configure.pcapng", {kEk1914, kEl3004}},
                    Known{"ethercrab-rs__ethercrab__rs-example-sii-el2004.pcapng", {kEk1100, kEl2004, kEl2004}},
                    Known{"ethercrab-rs__ethercrab__soem-sdinfo-akd.pcapng", {0x00414B44}},
                    Known{"ethercrab-rs__ethercrab__soem-sdinfo-ek1100-el1004.pcapng", {kEk1100, kEl1004}},
                    Known{"ethercrab-rs__ethercrab__soem-single-lan9252.pcapng", {0x00009252}},
                    Known{"ethercrab-rs__ethercrab__twincat-scan-boxes.pcapng", {kEk1100, kEl1004}}));

/// A capture of our own: coupler and four terminals.
TEST(RecordedBus, OurCaptureShowsItsSlavesAndTheirWiring) {
  const auto scan = scan_bus(open_link("replay:" + (test::own_samples("pcap") / "scan_of_a_row.pcapng").string()));
  ASSERT_TRUE(scan) << describe(scan.error());
  std::vector<std::uint32_t> products;
  for (const auto& slave : scan->slaves) products.push_back(slave.identity.product_code);
  EXPECT_EQ(products, (std::vector<std::uint32_t>{0x1100, 0x1002, 0x2002, 0x3002, 0x4002}));
  for (std::size_t i = 1; i < scan->slaves.size(); ++i) {
    ASSERT_TRUE(scan->slaves[i].previous) << i;
    EXPECT_EQ(scan->slaves[i].previous->position, i - 1);
  }
}

TEST(RecordedBus, WiringIsThatOfTheCapture) {
  SYNCLINE_SAMPLE(path, "pcap/ethercrab-rs__ethercrab__replay-dc.pcapng");
  const auto scan = scan_bus(open_link("replay:" + path));
  ASSERT_TRUE(scan) << describe(scan.error());
  ASSERT_EQ(scan->slaves.size(), 3U);
  EXPECT_FALSE(scan->slaves[0].previous);
  EXPECT_EQ(scan->slaves[1].previous->position, 0);
  EXPECT_EQ(scan->slaves[2].previous->position, 1);
  EXPECT_EQ(scan->slaves[2].previous->port, 1);
}

}  // namespace
}  // namespace syncline
