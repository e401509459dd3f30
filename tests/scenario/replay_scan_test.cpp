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
  bool own = false;
};
void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

class RecordedBuses : public testing::TestWithParam<Known> {};

TEST_P(RecordedBuses, AreScannedFromTheirCaptures) {
  const auto path = test::sample_path(GetParam().own, std::string("pcap/") + GetParam().file);
  const auto scan = scan_bus(open_link("replay:" + path));
  ASSERT_TRUE(scan) << describe(scan.error());
  std::vector<std::uint32_t> products;
  for (const auto& slave : scan->slaves) products.push_back(slave.identity.product_code);
  EXPECT_EQ(products, GetParam().products);
}

constexpr std::uint32_t kEk1100 = 0x044C2C52, kEk1914 = 0x077A2C52, kEl1004 = 0x03EC3052, kEl2004 = 0x07D43052,
                        kEl2828 = 0x0B0C3052, kEl2889 = 0x0B493052, kEl3004 = 0x0BBC3052;

// Simulated devices; then what stands in the captures' names: terminals of Beckhoff, an AKD drive, a bare LAN9252.
INSTANTIATE_TEST_SUITE_P(
    Samples, RecordedBuses,
    testing::ValuesIn(test::with_others<Known>(
        {{"scan_of_a_row.pcapng", {0x1100, 0x1002, 0x2002, 0x3002, 0x4002}, true},
         {"start_of_a_tree.pcapng", {0x1100, 0x1002, 0x7001, 0x1100, 0x2002, 0x7002}, true}},
        {Known{"ethercrab-rs__ethercrab__replay-ek1100-el2828-el2889.pcapng", {kEk1100, kEl2828, kEl2889}},
         Known{"ethercrab-rs__ethercrab__replay-ek1914-el3004-configure.pcapng", {kEk1914, kEl3004}},
         Known{"ethercrab-rs__ethercrab__rs-example-sii-el2004.pcapng", {kEk1100, kEl2004, kEl2004}},
         Known{"ethercrab-rs__ethercrab__soem-sdinfo-akd.pcapng", {0x00414B44}},
         Known{"ethercrab-rs__ethercrab__soem-sdinfo-ek1100-el1004.pcapng", {kEk1100, kEl1004}},
         Known{"ethercrab-rs__ethercrab__soem-single-lan9252.pcapng", {0x00009252}},
         Known{"ethercrab-rs__ethercrab__twincat-scan-boxes.pcapng", {kEk1100, kEl1004}}})));

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

struct KnownWiring {
  bool own = true;
  std::string file;
  std::vector<std::optional<PreviousPort>> previous;
};
void PrintTo(const KnownWiring& known, std::ostream* out) { *out << known.file; }

class RecordedWiring : public testing::TestWithParam<KnownWiring> {};
INSTANTIATE_TEST_SUITE_P(
    Samples, RecordedWiring,
    testing::ValuesIn(test::with_others<KnownWiring>({{true,
                                                       "pcap/start_of_a_tree.pcapng",
                                                       {std::nullopt, PreviousPort{0, 1}, PreviousPort{0, 2},
                                                        PreviousPort{2, 1}, PreviousPort{3, 1}, PreviousPort{3, 2}}}},
                                                     {{false,
                                                       "pcap/ethercrab-rs__ethercrab__replay-dc.pcapng",
                                                       {std::nullopt, PreviousPort{0, 1}, PreviousPort{1, 1}}}})));

TEST_P(RecordedWiring, IsThatOfTheCapture) {
  const auto scan = scan_bus(open_link("replay:" + test::sample_path(GetParam().own, GetParam().file)));
  ASSERT_TRUE(scan) << describe(scan.error());
  std::vector<std::optional<PreviousPort>> previous;
  for (const auto& slave : scan->slaves) previous.push_back(slave.previous);
  EXPECT_EQ(previous, GetParam().previous);
}

}  // namespace
}  // namespace syncline
