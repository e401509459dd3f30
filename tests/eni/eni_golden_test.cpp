// SPDX-License-Identifier: Apache-2.0
// Our export against that of other tools: same ESI, same settings, same commands.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

constexpr const char* kElmoEsi = "esi/tormach__hw_device_mgr__Elmo_ECAT_00010420_V11.rev_10420_only.xml";
constexpr Identity kElmoGold{0x9A, 0x30924, 0x10420, 0};

/// Elmo Gold drives in a line with the PDO assignment of the field's export, first op mode, 1 ms, bus shift.
Project elmo_project(const EsiCatalogue& catalogue, std::size_t count) {
  const auto match = catalogue.find(kElmoGold);
  Project project = sample::project(std::vector<DeviceDescription>(count, *match->device));
  for (auto& slave : project.slaves) {
    slave.assigned_rx_pdos = {0x160A, 0x160B, 0x160C, 0x160F, 0x161C};
    slave.assigned_tx_pdos = {0x1A0A, 0x1A0E, 0x1A11, 0x1A13, 0x1A1D};
  }
  return project;
}

void expect_same_as_ec_engineer(const std::string& sample, std::size_t slaves) {
  SYNCLINE_SAMPLE(esi, kElmoEsi);
  SYNCLINE_SAMPLE(eni, sample);
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_file(esi));
  ASSERT_TRUE(catalogue.find(kElmoGold)->exact_revision);
  const auto theirs = read_eni(eni);
  ASSERT_TRUE(theirs) << describe(theirs.error());
  const auto ours = compile(elmo_project(catalogue, slaves));
  ASSERT_TRUE(ours);

  EXPECT_THAT(words(compare_networks(*theirs, ours->config, {.image_offsets = true})), testing::IsEmpty());
  EXPECT_EQ(ours->config.image.input_bytes, theirs->image.input_bytes);
  EXPECT_EQ(ours->config.image.inputs, theirs->image.inputs);
  EXPECT_EQ(ours->config.image.outputs, theirs->image.outputs);
  ASSERT_EQ(theirs->slaves.size(), slaves);
  for (std::size_t i = 0; i < slaves; ++i) {
    EXPECT_EQ(ours->config.slaves[i].send, theirs->slaves[i].send);
    EXPECT_EQ(ours->config.slaves[i].receive, theirs->slaves[i].receive);
    EXPECT_EQ(ours->config.slaves[i].sync_managers, theirs->slaves[i].sync_managers);
    EXPECT_EQ(pdo_lines(ours->config.slaves[i]), pdo_lines(theirs->slaves[i]));
    EXPECT_EQ(ours->config.slaves[i].dc, theirs->slaves[i].dc);
    EXPECT_EQ(ours->config.slaves[i].name, theirs->slaves[i].name);
    EXPECT_EQ(ours->config.slaves[i].identity, theirs->slaves[i].identity);
  }
}

TEST(GoldenEni, OneElmoDriveAsEcEngineerWritesIt) {
  expect_same_as_ec_engineer("eni/magnate3__rocos-ethercat__eni.xml", 1);
}
TEST(GoldenEni, ThreeElmoDrivesAsEcEngineerWritesThem) {
  expect_same_as_ec_engineer("eni/magnate3__rocos-ethercat__bcr_eni.xml", 3);
}
TEST(GoldenEni, FourElmoDrivesAsEcEngineerWritesThem) {
  expect_same_as_ec_engineer("eni/magnate3__rocos-ethercat__eni4.xml", 4);
}

TEST(GoldenEni, TheComparisonSeesAChange) {
  SYNCLINE_SAMPLE(esi, kElmoEsi);
  SYNCLINE_SAMPLE(eni, "eni/magnate3__rocos-ethercat__eni.xml");
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_file(esi));
  Project project = elmo_project(catalogue, 1);
  project.slaves[0].dc.sync0.shift = 1000;
  project.master.dc.dcm.mode = DcmMode::kMasterShift;
  const auto differences = words(compare_networks(*read_eni(eni), compile(project)->config));
  EXPECT_THAT(differences,
              testing::ElementsAre("slave 0, init command 23 (FPWR 1001:0x0990, PS): data is 0000000000000000 in the "
                                   "first file, e803000000000000 in the second",
                                   "cyclic task 1, frame 1, command 4: only in the first file: APWR 0:0x0910, "
                                   "PREOP,SAFEOP,OP"));
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

/// TwinCAT 3 with DC and master shift: a non-DC sensor (place holder) and four drives, the second slave is the
/// reference.
TEST(GoldenEni, FourElmoDrivesAsTwinCat3WritesThem) {
  SYNCLINE_SAMPLE(esi, kElmoEsi);
  SYNCLINE_SAMPLE(eni, "eni/kpierczy__ethercat-lib__test_eni.xml");
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_file(esi));
  const DeviceDescription drive = *catalogue.find(kElmoGold)->device;
  Project project = sample::project({place_holder(0, 14), drive, drive, drive, drive});
  project.master.cycle_time = 10 * kMillisecond;
  project.master.dc.dcm.mode = DcmMode::kMasterShift;
  for (std::size_t i = 1; i < 5; ++i) {
    project.slaves[i].assigned_rx_pdos = {0x1601};
    project.slaves[i].assigned_tx_pdos = {0x1A03};
  }
  const auto theirs = read_eni(eni);
  ASSERT_TRUE(theirs) << describe(theirs.error());
  const auto ours = compile(project, {EniDialect::kTwinCat});
  ASSERT_TRUE(ours);
  EXPECT_EQ(ours->config.dc.reference_clock, theirs->dc.reference_clock);
  // TwinCAT 3 gives the AL control writes a time-out, and here its LRD area comes before the LRW area: two things that
  // ET9000, which this dialect follows, does otherwise.
  for (std::size_t i = 1; i < 5; ++i) {
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
    EXPECT_THAT(timeouts, testing::ElementsAre("5000", "3000", "200", "200", "3000", "3000", "10000", "10000"));
    const std::string offset = hex_text(le_bytes(static_cast<std::uint16_t>(14 * (i - 1))));
    const std::string moved =
        "data " + hex_text(le_bytes(static_cast<std::uint16_t>(0x800 + 14 * (i - 1)))) + "0001 " + offset + "0001";
    EXPECT_THAT(others, testing::ElementsAre(moved, moved));
  }
}

/// The bus of ten slaves: the first five from their ESI, the others as place holders of the same sizes.
std::optional<Project> ten_terminals(const EsiCatalogue& catalogue) {
  const Identity known[] = {{2, 0x044C2C52, 0x120000, 0},
                            {2, 0x03EA3052, 0x110000, 0},
                            {2, 0x03F03052, 0x110000, 0},
                            {2, 0x07D43052, 0x110000, 0},
                            {2, 0x07D83052, 0x110000, 0}};
  std::vector<DeviceDescription> devices;
  for (const Identity& identity : known) {
    const auto match = catalogue.find(identity);
    if (!match || !match->exact_revision) {
      return std::nullopt;
    }
    devices.push_back(*match->device);
  }
  devices.push_back(place_holder(0, 32));
  devices.push_back(place_holder(0, 8));
  devices.push_back(place_holder(4, 0));
  devices.push_back(place_holder(16, 0));
  devices.push_back(place_holder(8, 8));
  return sample::project(std::move(devices));
}

TEST(GoldenEni, FiveTerminalsAsEt9000WritesThem) {
  SYNCLINE_SAMPLE(couplers, "esi/DermotAckermann__dotnet-modules-ecenibuilderacontis__Beckhoff_EK11xx.xml");
  SYNCLINE_SAMPLE(inputs, "esi/DiamondLightSource__ethercat__Beckhoff_EL1xxx.xml");
  SYNCLINE_SAMPLE(outputs, "esi/DiamondLightSource__ethercat__Beckhoff_EL2xxx.xml");
  SYNCLINE_SAMPLE(eni, "eni/kj4tmp__pyecm__basic.xml");
  EsiCatalogue catalogue;
  for (const auto& file : {couplers, inputs, outputs}) {
    ASSERT_TRUE(catalogue.add_file(file));
  }
  const auto project = ten_terminals(catalogue);
  ASSERT_TRUE(project);
  const auto theirs = read_eni(eni);
  ASSERT_TRUE(theirs) << describe(theirs.error());
  const auto ours = compile(*project, {EniDialect::kTwinCat});
  ASSERT_TRUE(ours);
  for (std::size_t i = 0; i < 5; ++i) {
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
