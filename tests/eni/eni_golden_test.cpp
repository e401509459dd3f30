// SPDX-License-Identifier: Apache-2.0
// Our export against stored ones, of ours and of other tools: same ESI, same settings, same commands.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "compare/network_compare.h"
#include "compile/compile.h"
#include "config/command_text.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/format/eni_file.h"
#include "findings/error_text.h"
#include "support/byte_order.h"
#include "support/sample_folder.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

std::vector<std::string> words(const std::vector<NetworkDifference>& differences) {
  std::vector<std::string> out;
  for (const auto& difference : differences) {
    out.push_back(describe(difference));
  }
  return out;
}

/// One line for each PDO and entry. Left out: PDO 0x1A26, unassigned, which came with a later edition of the drives'
/// ESI than some of the exports were made from. Names without space at the end: the ESI has such names, our reader
/// trims them.
std::string pdo_lines(const SlaveConfig& slave) {
  std::string out;
  for (const auto& [direction, pdo] : slave.pdos) {
    if (pdo.index == 0x1A26 && !pdo.sync_manager) continue;
    out += fmt::format("{} 0x{:04x} \"{}\" SM {}{}{}\n", direction == PdoDirection::kTx ? "Tx" : "Rx", pdo.index,
                       pdo.name, pdo.sync_manager ? std::to_string(*pdo.sync_manager) : "none",
                       pdo.fixed ? " fixed" : "", pdo.mandatory ? " mandatory" : "");
    for (const std::uint16_t excluded : pdo.exclude) {
      out += fmt::format("  excludes 0x{:04x}\n", excluded);
    }
    for (const auto& entry : pdo.entries) {
      out += fmt::format("  0x{:04x}:{} {} \"{}\" {}\n", entry.index, entry.sub_index, entry.bit_length,
                         entry.name.substr(0, entry.name.find_last_not_of(' ') + 1), entry.data_type);
    }
  }
  return out;
}

/// Drives of one kind in a line as a stored export has them, in EC-Engineer's way: first op mode, 1 ms, bus shift.
struct DriveExport {
  bool own = true;
  std::string name;
  std::string esi;
  Identity identity;
  std::vector<std::uint16_t> rx_pdos, tx_pdos;
  std::string eni;
  std::size_t slaves = 1;
};
void PrintTo(const DriveExport& drives, std::ostream* out) { *out << drives.eni; }

constexpr const char* kElmoEsi = "esi/tormach__hw_device_mgr__Elmo_ECAT_00010420_V11.rev_10420_only.xml";
constexpr Identity kElmoGold{0x9A, 0x30924, 0x10420, 0};
constexpr Identity kAxis{0xF10A11, 0x20, 0x20003, 0};

DriveExport axes(std::string name, std::string eni, std::size_t slaves) {
  return {true,           std::move(name), "esi/axis.xml", kAxis, {0x1610, 0x1612, 0x1613}, {0x1A10, 0x1A11, 0x1A14},
          std::move(eni), slaves};
}
DriveExport elmos(std::string name, std::string eni, std::size_t slaves) {
  return {false,
          std::move(name),
          kElmoEsi,
          kElmoGold,
          {0x160A, 0x160B, 0x160C, 0x160F, 0x161C},
          {0x1A0A, 0x1A0E, 0x1A11, 0x1A13, 0x1A1D},
          std::move(eni),
          slaves};
}

/// SYNCLINE_WRITE_GOLDEN=1 writes ours anew, for review.
void write_golden(bool own, const std::string& eni, const Project& project, EniDialect dialect) {
  if (!own || std::getenv("SYNCLINE_WRITE_GOLDEN") == nullptr) return;
  ASSERT_TRUE(save_eni(compile(project, {dialect})->config, test::sample_path(own, eni), style_of(dialect)));
}

class GoldenDrives : public testing::TestWithParam<DriveExport> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(catalogue_.add_file(test::sample_path(GetParam().own, GetParam().esi)));
    const auto match = catalogue_.find(GetParam().identity);
    ASSERT_TRUE(match && match->exact_revision);
    project_ = sample::project(std::vector<DeviceDescription>(GetParam().slaves, *match->device));
    for (auto& slave : project_.slaves) {
      slave.assigned_rx_pdos = GetParam().rx_pdos;
      slave.assigned_tx_pdos = GetParam().tx_pdos;
    }
    write_golden(GetParam().own, GetParam().eni, project_, EniDialect::kEcEngineer);
    auto theirs = read_eni(test::sample_path(GetParam().own, GetParam().eni));
    ASSERT_TRUE(theirs) << describe(theirs.error());
    theirs_ = std::move(*theirs);
  }
  EsiCatalogue catalogue_;
  Project project_;
  NetworkConfig theirs_;
};

INSTANTIATE_TEST_SUITE_P(Exports, GoldenDrives,
                         testing::ValuesIn(test::with_others<DriveExport>(
                             {axes("OneAxis", "eni/axis.eni.xml", 1), axes("ThreeAxes", "eni/axes.eni.xml", 3)},
                             {elmos("OneElmo", "eni/magnate3__rocos-ethercat__eni.xml", 1),
                              elmos("ThreeElmos", "eni/magnate3__rocos-ethercat__bcr_eni.xml", 3),
                              elmos("FourElmos", "eni/magnate3__rocos-ethercat__eni4.xml", 4)})),
                         [](const auto& drives) { return drives.param.name; });

TEST_P(GoldenDrives, AreWrittenAsInTheStoredExport) {
  const auto ours = compile(project_);
  ASSERT_TRUE(ours);
  EXPECT_THAT(words(compare_networks(theirs_, ours->config, {.image_offsets = true})), testing::IsEmpty());
  EXPECT_EQ(ours->config.image.input_bytes, theirs_.image.input_bytes);
  EXPECT_EQ(ours->config.image.inputs, theirs_.image.inputs);
  EXPECT_EQ(ours->config.image.outputs, theirs_.image.outputs);
  ASSERT_EQ(theirs_.slaves.size(), GetParam().slaves);
  for (std::size_t i = 0; i < theirs_.slaves.size(); ++i) {
    EXPECT_EQ(ours->config.slaves[i].send, theirs_.slaves[i].send);
    EXPECT_EQ(ours->config.slaves[i].receive, theirs_.slaves[i].receive);
    EXPECT_EQ(ours->config.slaves[i].sync_managers, theirs_.slaves[i].sync_managers);
    EXPECT_EQ(pdo_lines(ours->config.slaves[i]), pdo_lines(theirs_.slaves[i]));
    EXPECT_EQ(ours->config.slaves[i].dc, theirs_.slaves[i].dc);
    EXPECT_EQ(ours->config.slaves[i].name, theirs_.slaves[i].name);
    EXPECT_EQ(ours->config.slaves[i].identity, theirs_.slaves[i].identity);
  }
}

TEST_P(GoldenDrives, TheComparisonSeesAChange) {
  project_.slaves[0].dc.sync0.shift = 1000;
  project_.master.dc.dcm.mode = DcmMode::kMasterShift;
  const auto differences = words(compare_networks(theirs_, compile(project_)->config));
  EXPECT_THAT(differences,
              testing::ElementsAre(
                  testing::MatchesRegex("slave 0, init command [0-9]+ \\(FPWR 1001:0x0990, PS\\): data is "
                                        "0000000000000000 in the first file, e803000000000000 in the second"),
                  "cyclic task 1, frame 1, command 4: only in the first file: APWR 0:0x0910, PREOP,SAFEOP,OP"));
}

/// A terminal with mailbox state FMMU whose only purpose is to take its place in the image.
DeviceDescription place_holder(std::uint16_t output_bytes, std::uint16_t input_bytes) {
  DeviceDescription device = sample::servo();
  device.dc.reset();
  device.fmmus.push_back(FmmuUse::kMailboxState);
  const auto block = [](std::uint16_t bytes) {
    return std::vector<PdoEntry>{{0x3000, 1, static_cast<std::uint16_t>(bytes * 8), "Block", "ARRAY"}};
  };
  device.rx_pdos[0].entries = block(output_bytes);
  device.tx_pdos[0].entries = block(input_bytes);
  if (output_bytes == 0) device.rx_pdos.clear();
  if (input_bytes == 0) device.tx_pdos.clear();
  return device;
}

/// With DC and master shift in TwinCAT's way: a non-DC sensor (place holder) of 14 bytes and drives, the second slave
/// is the reference.
struct MasterShiftExport {
  bool own = true;
  std::string esi;
  Identity identity;
  std::uint16_t rx_pdo = 0, tx_pdo = 0;
  std::string eni;
  std::size_t drives = 0;
  /// TwinCAT 3 gives the AL control writes a time-out, and here its LRD area comes before the LRW area: two things that
  /// ET9000, which this dialect follows, does otherwise.
  std::vector<std::string> timeouts;
  bool areas_moved = false;
};
void PrintTo(const MasterShiftExport& drives, std::ostream* out) { *out << drives.eni; }

class GoldenMasterShift : public testing::TestWithParam<MasterShiftExport> {};
INSTANTIATE_TEST_SUITE_P(
    Exports, GoldenMasterShift,
    testing::ValuesIn(test::with_others<MasterShiftExport>(
        {{true, "esi/axis.xml", kAxis, 0x1602, 0x1A02, "eni/sensor_and_axes.eni.xml", 2, {}, false}},
        {{false,
          kElmoEsi,
          kElmoGold,
          0x1601,
          0x1A03,
          "eni/kpierczy__ethercat-lib__test_eni.xml",
          4,
          {"5000", "3000", "200", "200", "3000", "3000", "10000", "10000"},
          true}})));

TEST_P(GoldenMasterShift, DrivesAreWrittenAsInTheStoredExport) {
  const auto& stored = GetParam();
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_file(test::sample_path(stored.own, stored.esi)));
  std::vector<DeviceDescription> devices(stored.drives, *catalogue.find(stored.identity)->device);
  devices.insert(devices.begin(), place_holder(0, 14));
  Project project = sample::project(std::move(devices));
  project.master.cycle_time = 10 * kMillisecond;
  project.master.dc.dcm.mode = DcmMode::kMasterShift;
  for (std::size_t i = 1; i < project.slaves.size(); ++i) {
    project.slaves[i].assigned_rx_pdos = {stored.rx_pdo};
    project.slaves[i].assigned_tx_pdos = {stored.tx_pdo};
  }
  write_golden(stored.own, stored.eni, project, EniDialect::kTwinCat);
  const auto theirs = read_eni(test::sample_path(stored.own, stored.eni));
  ASSERT_TRUE(theirs) << describe(theirs.error());
  const auto ours = compile(project, {EniDialect::kTwinCat});
  ASSERT_TRUE(ours);
  EXPECT_EQ(ours->config.dc.reference_clock, theirs->dc.reference_clock);
  EXPECT_EQ(theirs->dc.reference_clock, 1);
  ASSERT_EQ(theirs->slaves.size(), project.slaves.size());
  for (std::size_t i = 1; i < project.slaves.size(); ++i) {
    std::vector<std::string> timeouts, others;
    for (const auto& difference : compare_slaves(theirs->slaves[i], ours->config.slaves[i], "")) {
      if (difference.field == "time-out") {
        EXPECT_EQ(difference.right, "none");
        timeouts.push_back(difference.left);
      } else {
        others.push_back(difference.field + " " + difference.left.substr(0, 8) + " " + difference.right.substr(0, 8));
        EXPECT_EQ(difference.left.substr(8), difference.right.substr(8));
      }
    }
    EXPECT_EQ(timeouts, stored.timeouts);
    if (!stored.areas_moved) {
      EXPECT_THAT(others, testing::IsEmpty());
      continue;
    }
    const std::string offset = hex_text(le_bytes(static_cast<std::uint16_t>(14 * (i - 1))));
    const std::string moved =
        "data " + hex_text(le_bytes(static_cast<std::uint16_t>(0x800 + 14 * (i - 1)))) + "0001 " + offset + "0001";
    EXPECT_THAT(others, testing::ElementsAre(moved, moved));
  }
}

/// Terminals without mailbox from their ESI in TwinCAT's way, and behind them place holders of the others' sizes.
struct TerminalExport {
  bool own = true;
  std::vector<std::string> esi;
  std::vector<Identity> known;
  std::vector<std::pair<std::uint16_t, std::uint16_t>> others;  // bytes of outputs and inputs
  std::string eni;
};
void PrintTo(const TerminalExport& terminals, std::ostream* out) { *out << terminals.eni; }

class GoldenTerminals : public testing::TestWithParam<TerminalExport> {};
INSTANTIATE_TEST_SUITE_P(Exports, GoldenTerminals,
                         testing::ValuesIn(test::with_others<TerminalExport>(
                             {{true,
                               {"esi/terminals.xml"},
                               {{0xF10B22, 0x100, 0x120000, 0},
                                {0xF10B22, 0x104, 0x110000, 0},
                                {0xF10B22, 0x202, 0x110000, 0},
                                {0xF10B22, 0x202, 0x110000, 0}},
                               {{0, 12}, {6, 4}},
                               "eni/terminals.eni.xml"}},
                             {{false,
                               {"esi/DermotAckermann__dotnet-modules-ecenibuilderacontis__Beckhoff_EK11xx.xml",
                                "esi/DiamondLightSource__ethercat__Beckhoff_EL1xxx.xml",
                                "esi/DiamondLightSource__ethercat__Beckhoff_EL2xxx.xml"},
                               {{2, 0x044C2C52, 0x120000, 0},
                                {2, 0x03EA3052, 0x110000, 0},
                                {2, 0x03F03052, 0x110000, 0},
                                {2, 0x07D43052, 0x110000, 0},
                                {2, 0x07D83052, 0x110000, 0}},
                               {{0, 32}, {0, 8}, {4, 0}, {16, 0}, {8, 8}},
                               "eni/kj4tmp__pyecm__basic.xml"}})));

TEST_P(GoldenTerminals, AreWrittenAsInTheStoredExport) {
  const auto& stored = GetParam();
  EsiCatalogue catalogue;
  for (const auto& file : stored.esi) {
    ASSERT_TRUE(catalogue.add_file(test::sample_path(stored.own, file)));
  }
  std::vector<DeviceDescription> devices;
  for (const Identity& identity : stored.known) {
    const auto match = catalogue.find(identity);
    ASSERT_TRUE(match && match->exact_revision);
    devices.push_back(*match->device);
  }
  for (const auto& [outputs, inputs] : stored.others) devices.push_back(place_holder(outputs, inputs));
  const auto project = sample::project(std::move(devices));
  write_golden(stored.own, stored.eni, project, EniDialect::kTwinCat);
  const auto theirs = read_eni(test::sample_path(stored.own, stored.eni));
  ASSERT_TRUE(theirs) << describe(theirs.error());
  const auto ours = compile(project, {EniDialect::kTwinCat});
  ASSERT_TRUE(ours);
  for (std::size_t i = 0; i < stored.known.size(); ++i) {
    EXPECT_THAT(words(compare_slaves(theirs->slaves[i], ours->config.slaves[i], "slave " + std::to_string(i))),
                testing::IsEmpty());
    EXPECT_EQ(ours->config.slaves[i].send, theirs->slaves[i].send);
    EXPECT_EQ(ours->config.slaves[i].receive, theirs->slaves[i].receive);
    EXPECT_EQ(ours->config.slaves[i].sync_managers, theirs->slaves[i].sync_managers);
    EXPECT_EQ(pdo_lines(ours->config.slaves[i]), pdo_lines(theirs->slaves[i]));
  }
  EXPECT_EQ(ours->config.master.init_cmds.size(), theirs->master.init_cmds.size());
  NetworkConfig masters_and_frames[2];
  masters_and_frames[0].master = theirs->master;
  masters_and_frames[0].cyclic = theirs->cyclic;
  masters_and_frames[1].master = ours->config.master;
  masters_and_frames[1].cyclic = ours->config.cyclic;
  EXPECT_THAT(words(compare_networks(masters_and_frames[0], masters_and_frames[1], {.image_offsets = true})),
              testing::IsEmpty());
}

}  // namespace
}  // namespace syncline::eni
