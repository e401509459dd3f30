// SPDX-License-Identifier: Apache-2.0
#include "eni/project/project_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "channels/values/bus_scan.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/esi/esi_writer.h"
#include "eni/project/line_wiring.h"
#include "eni/xml/file_warning.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"

namespace syncline::eni {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

DeviceDescription device(std::uint32_t product, std::uint32_t revision, const char* physics = "YY") {
  DeviceDescription d;
  d.identity = {0x5EC, product, revision, 0};
  d.type = "T" + std::to_string(product);
  d.name = "Thing";
  d.physics = physics;
  return d;
}

class ProjectBuilder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "syncline-esi-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    auto clock = device(3, 1);
    clock.dc.emplace().op_modes.push_back({"DcSync", "", 0x0300, {}, {}, {}, {}, {}});
    int n = 0;
    for (const auto& d : {device(1, 0x10), device(1, 0x30), device(2, 0x20), clock}) {
      ASSERT_TRUE(write_file_atomic((folder_ / (std::to_string(n++) + ".xml")).string(), write_esi(d)));
    }
    std::ofstream(folder_ / "broken.XML") << "<EtherCATInfo>";
    std::ofstream(folder_ / "readme.txt") << "no ESI";
    ASSERT_TRUE(catalogue_.add_folder(folder_.string()));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::uint32_t found(std::uint32_t product, std::uint32_t revision) const {
    const auto match = catalogue_.find({0x5EC, product, revision, 0});
    return match ? match->device->identity.revision_no : 0;
  }

  std::filesystem::path folder_;
  EsiCatalogue catalogue_;
};

TEST_F(ProjectBuilder, CatalogueReadsAFolderAndWarnsOfWhatItCannotRead) {
  EXPECT_EQ(catalogue_.device_count(), 4U);
  ASSERT_THAT(catalogue_.warnings(), SizeIs(1));
  EXPECT_THAT(catalogue_.warnings()[0].file, HasSubstr("broken.XML"));
  EsiCatalogue other;
  EXPECT_EQ(other.add_folder((folder_ / "none").string()).error().code, ErrorCode::kFileNotFound);
}

TEST_F(ProjectBuilder, CatalogueFindsTheNearestRevision) {
  EXPECT_EQ(found(1, 0x10), 0x10U);
  EXPECT_EQ(found(1, 0x20), 0x10U) << "the newest that is not newer";
  EXPECT_EQ(found(1, 0x40), 0x30U);
  EXPECT_EQ(found(1, 0x05), 0x30U) << "only newer ones: the newest";
  EXPECT_EQ(found(1, 0), 0x30U) << "any: the newest";
  EXPECT_TRUE(catalogue_.find({0x5EC, 1, 0x30, 0})->exact_revision);
  EXPECT_FALSE(catalogue_.find({0x5EC, 1, 0x31, 0})->exact_revision);
  EXPECT_FALSE(catalogue_.find({0x5EC, 9, 0, 0}));
  EXPECT_FALSE(catalogue_.find({0x5ED, 1, 0x10, 0}));
}

TEST_F(ProjectBuilder, DevicesInOrderBecomeALine) {
  const auto project = project_from_devices({{0x5EC, 3, 1, 0}, {0x5EC, 2, 0, 0}, {0x5EC, 1, 0x10, 0}}, catalogue_);
  ASSERT_TRUE(project);
  ASSERT_THAT(project->slaves, SizeIs(3));
  EXPECT_EQ(project->slaves[0].previous, std::nullopt);
  EXPECT_EQ(project->slaves[1].previous, (PreviousPort{0, 1}));
  EXPECT_EQ(project->slaves[2].previous, (PreviousPort{1, 1}));
  EXPECT_EQ(project->slaves[0].dc.op_mode, "DcSync");
  EXPECT_EQ(project->slaves[2].station_address, 1003);
  EXPECT_EQ(project->master.dc.reference_clock, std::nullopt);
}

TEST_F(ProjectBuilder, UnknownDevicesAreNamed) {
  const auto unknown = project_from_devices({{0x5EC, 9, 1, 0}}, catalogue_);
  EXPECT_EQ(unknown.error().code, ErrorCode::kUnknownDevice);
  EXPECT_EQ(unknown.error().subject, "0x000005ec:0x00000009:0x00000001");
  const auto revision = project_from_devices({{0x5EC, 2, 0x77, 0}}, catalogue_);
  EXPECT_EQ(revision.error().code, ErrorCode::kUnknownDevice);
  EXPECT_THAT(revision.error().detail.text(), HasSubstr("0x00000020"));
}

ScannedSlave scanned(std::uint16_t position, std::uint32_t product, std::uint32_t revision, DcCapability dc) {
  ScannedSlave s;
  s.position = position;
  s.identity = {0x5EC, product, revision, 77};
  s.dc = dc;
  if (position > 0) s.previous = PreviousPort{static_cast<std::uint16_t>(position - 1), 2};
  return s;
}

TEST_F(ProjectBuilder, ScanTakesWiringAndAliasFromTheBus) {
  BusScan scan;
  scan.slaves = {scanned(0, 3, 1, DcCapability::kSystemTime64), scanned(1, 2, 0x20, DcCapability::kNone)};
  scan.slaves[1].alias = 5;
  const auto built = project_from_scan(scan, catalogue_);
  EXPECT_THAT(built.warnings, IsEmpty());
  ASSERT_THAT(built.project.slaves, SizeIs(2));
  EXPECT_EQ(built.project.slaves[0].dc.op_mode, "DcSync");
  EXPECT_EQ(built.project.slaves[0].device, catalogue_.find({0x5EC, 3, 1, 0})->device[0]);
  EXPECT_EQ(built.project.slaves[1].alias, 5);
  EXPECT_EQ(built.project.slaves[1].previous, (PreviousPort{0, 2}));
}

TEST_F(ProjectBuilder, ASlaveThatSaysItCannotDoLrwGetsNone) {
  BusScan scan;
  scan.slaves = {scanned(0, 1, 0x10, DcCapability::kNone), scanned(1, 2, 0x20, DcCapability::kNone)};
  scan.slaves[1].features = 0x020C;
  const auto built = project_from_scan(scan, catalogue_);
  EXPECT_FALSE(built.project.slaves[0].device.use_lrd_lwr);
  EXPECT_TRUE(built.project.slaves[1].device.use_lrd_lwr);
}

TEST_F(ProjectBuilder, ScanWarnsOfOtherRevisionsAndMissingClocks) {
  BusScan scan;
  scan.slaves = {scanned(0, 1, 0x20, DcCapability::kNone), scanned(1, 3, 1, DcCapability::kReceiveTimesOnly)};
  const auto built = project_from_scan(scan, catalogue_);
  ASSERT_THAT(built.warnings, SizeIs(2));
  EXPECT_EQ(built.warnings[0].code, "scan-other-revision");
  EXPECT_THAT(describe(built.warnings[0]), AllOf(HasSubstr("Slave 0"), HasSubstr("0x00000010")));
  EXPECT_EQ(built.warnings[1].code, "scan-no-clock");
  EXPECT_EQ(built.warnings[1].place.key, "slave.1.dc.op_mode");
  EXPECT_EQ(built.project.slaves[1].dc.op_mode, "");
}

TEST_F(ProjectBuilder, DeviceWithoutEsiComesFromItsEeprom) {
  BusScan scan;
  scan.slaves = {scanned(0, 9, 1, DcCapability::kNone), scanned(1, 8, 1, DcCapability::kNone)};
  auto& image = scan.slaves[0].sii.emplace();
  image.vendor_id = 0x5EC;
  image.product_code = 9;
  image.general.emplace().name =
      "Gr\xF6\xDF"
      "e\x01 ";
  image.mailbox_protocols = sii::kProtocolCoe;
  image.general->coe_details = 0x24;  // PDO assignment, complete access
  sii::Pdo pdo;
  pdo.index = 0x1A00;
  pdo.sync_manager = 0;
  image.tx_pdos.push_back(pdo);
  scan.slaves[1].sii_error = Error{.code = ErrorCode::kSii, .subject = "slave 1"};
  const auto built = project_from_scan(scan, catalogue_);
  ASSERT_THAT(built.project.slaves, SizeIs(2));
  EXPECT_THAT(built.project.slaves[0].assigned_tx_pdos, ElementsAre(0x1A00));
  EXPECT_EQ(built.project.slaves[0].device.name, "Größe");
  const auto& coe = built.project.slaves[0].device.mailbox->coe;
  EXPECT_TRUE(coe->pdo_assign);
  EXPECT_FALSE(coe->complete_access) << "entry by entry works with every slave";
  EXPECT_EQ(built.project.slaves[1].device.identity, (Identity{0x5EC, 8, 1, 0}));
  ASSERT_THAT(built.warnings, SizeIs(3));
  EXPECT_EQ(built.warnings[0].code, "scan-no-esi");
  EXPECT_EQ(built.warnings[2].code, "eeprom-unusable");
}

PreviousPort wired(const std::vector<SlaveSettings>& slaves, std::size_t i) {
  return slaves[i].previous.value_or(PreviousPort{99, 99});
}

TEST(LineWiring, TerminalsHangOnTheirCouplerAndTheNextCouplerOnItsCable) {
  std::vector<SlaveSettings> slaves;
  for (const char* physics : {"YKY", "KK", "KK", "YKY", "KK", "YY"}) {
    slaves.push_back(default_slave(device(1, 1, physics), static_cast<std::uint16_t>(slaves.size())));
  }
  wire_in_order(slaves);
  EXPECT_EQ(slaves[0].previous, std::nullopt);
  EXPECT_EQ(wired(slaves, 1), (PreviousPort{0, 1}));
  EXPECT_EQ(wired(slaves, 2), (PreviousPort{1, 1}));
  EXPECT_EQ(wired(slaves, 3), (PreviousPort{0, 2}));
  EXPECT_EQ(wired(slaves, 4), (PreviousPort{3, 1}));
  EXPECT_EQ(wired(slaves, 5), (PreviousPort{3, 2}));
}

TEST(LineWiring, UnknownPhysicsIsALine) {
  std::vector<SlaveSettings> slaves;
  for (int i = 0; i < 3; ++i) slaves.push_back(default_slave(device(1, 1, ""), static_cast<std::uint16_t>(i)));
  wire_in_order(slaves);
  EXPECT_EQ(wired(slaves, 1), (PreviousPort{0, 1}));
  EXPECT_EQ(wired(slaves, 2), (PreviousPort{1, 1}));
}

TEST_F(ProjectBuilder, WhatSlavesTellThemselvesIsCompletedOnce) {
  BusScan scan;
  scan.slaves.resize(2);
  int asked = 0;
  const auto built = project_from_scan(scan, catalogue_, [&asked](Project& project) -> Result<std::vector<Error>> {
    ++asked;
    project.slaves[1].name = "told";
    return std::vector<Error>{Error{ErrorCode::kNoResponse, "slave 0"}};
  });
  ASSERT_TRUE(built);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(built->project.slaves[1].name, "told");
  const auto plain = project_from_scan(scan, catalogue_);
  ASSERT_EQ(built->warnings.size(), plain.warnings.size() + 1);
  EXPECT_EQ(built->warnings.back(), finding_of(Error{ErrorCode::kNoResponse, "slave 0"}));
  const auto undescribed = project_from_scan(scan, catalogue_, {});
  ASSERT_TRUE(undescribed);
  EXPECT_EQ(undescribed->warnings.size(), plain.warnings.size());
}

TEST_F(ProjectBuilder, WhoCannotAskSaysSo) {
  const auto built = project_from_scan({}, catalogue_, [](Project&) -> Result<std::vector<Error>> {
    return tl::unexpected(Error{ErrorCode::kCancelled});
  });
  ASSERT_FALSE(built);
  EXPECT_EQ(built.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace syncline::eni
