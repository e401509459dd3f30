// SPDX-License-Identifier: Apache-2.0
// Whatever becomes a project is written, read again and equal: devices of ESI files, EEPROM images, damaged images.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>

#include "channels/values/bus_scan.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/esi/esi_reader.h"
#include "eni/project/project_builder.h"
#include "eni/project/project_file.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "support/sample_folder.h"
#include "tests/support/source_dir.h"

namespace syncline::eni {
namespace {

namespace fs = std::filesystem;

/// "" when the project comes back as it was.
std::string comes_back(const Project& project) {
  const auto text = write_project(project);
  const auto read = parse_project(text, "p.syncline");
  if (!read) return describe(read.error());
  if (!(*read == project)) return "another project came back";
  return write_project(*read) == text ? "" : "the same project is written in another way";
}

Project scanned(const sii::Image& image) {
  BusScan scan;
  for (std::uint16_t position = 0; position < 2; ++position) {
    ScannedSlave slave;
    slave.position = position;
    slave.dc = DcCapability::kSystemTime64;
    slave.identity = {image.vendor_id, image.product_code, image.revision_no, image.serial_no};
    slave.sii = image;
    if (position > 0) slave.previous = PreviousPort{0, 1};
    scan.slaves.push_back(slave);
  }
  return project_from_scan(scan, EsiCatalogue()).project;
}

/// An image with everything in it, and a PDO index that stands in it twice, as in some devices.
sii::Image own_image() {
  sii::Image image;
  image.vendor_id = 0x5EC;
  image.product_code = 0x1234;
  image.mailbox_protocols = sii::kProtocolCoe | sii::kProtocolFoe;
  image.mailbox = {0x1000, 128, 0x1080, 128};
  image.bootstrap_mailbox = {0x1000, 256, 0x1400, 256};
  image.general =
      sii::General{.group = "Drives", .image = "", .order = "SV-1", .name = "Servo", .physical_ports = 0x11};
  image.fmmus = {1, 2, 3};
  image.sync_managers = {{0x1000, 128, 0x26, 0, 1, 1},
                         {0x1080, 128, 0x22, 0, 1, 2},
                         {0x1100, 6, 0x64, 0, 1, 0},
                         {0x1180, 6, 0x20, 0, 1, 0}};
  image.rx_pdos = {{0x1600, 2, 0, "Outputs", 0, {{0x6040, 0, "Control word", 6, 16, 0}, {0, 0, "", 0, 8, 0}}},
                   {0x1700, 0xFF, 0, "More", 0, {}},
                   {0x1700, 0xFF, 0, "More again", 0, {}}};
  image.tx_pdos = {{0x1A00, 3, 0, "Inputs", 0, {{0x6041, 0, "Status word", 6, 16, 0}}}};
  image.dc_modes = {{0, 0, 0, 0, 0x0300, 1, "DcSync", "Synchronous"}, {0, 500, 0, 1, 0x0700, 1, "", ""}};
  return image;
}

TEST(WrittenIsRead, AnEepromWithOnePdoIndexTwice) { EXPECT_EQ(comes_back(scanned(own_image())), ""); }

TEST(WrittenIsRead, SyncManagersWithoutTypeAreKnownByTheirControlByte) {
  const auto managers = scanned(own_image()).slaves[0].device.sync_managers;
  ASSERT_EQ(managers.size(), 4U);
  EXPECT_EQ(managers[2].type, SyncManagerType::kOutputs);
  EXPECT_EQ(managers[3].type, SyncManagerType::kInputs);
  auto image = own_image();
  for (auto& manager : image.sync_managers) manager.type = 0;
  image.sync_managers[3].enable = 0;
  const auto without = scanned(image).slaves[0].device.sync_managers;
  EXPECT_EQ(without[0].type, SyncManagerType::kMailboxOut);
  EXPECT_EQ(without[1].type, SyncManagerType::kMailboxIn);
  EXPECT_EQ(without[3].type, SyncManagerType::kUnused) << "not in use";
}

TEST(WrittenIsRead, DamagedEeproms) {
  const auto whole = sii::encode(own_image());
  int decoded = 0;
  EXPECT_TRUE(rc::check([&] {
    auto bytes = whole;
    for (int i = *rc::gen::inRange(1, 12); i > 0; --i) {
      bytes[*rc::gen::inRange<std::size_t>(0, 0x240)] = *rc::gen::arbitrary<std::uint8_t>();
    }
    const auto image = sii::decode(bytes);
    if (!image) return;
    ++decoded;
    RC_ASSERT(comes_back(scanned(*image)) == "");
  }));
  EXPECT_GT(decoded, 20);
}

TEST(WrittenIsRead, EveryEepromOfTheSamples) {
  int images = 0;
  for (const auto& path : test::all_samples("sii", ".bin")) {
    const auto text = read_file(path.string());
    ASSERT_TRUE(text);
    const auto image = sii::decode(std::span(reinterpret_cast<const std::uint8_t*>(text->data()), text->size()));
    if (!image) continue;
    ++images;
    EXPECT_EQ(comes_back(scanned(*image)), "") << path;
  }
  EXPECT_GE(images, test::sample_folder() ? 26 : 6);
}

/// Number of devices.
int every_device(const fs::path& folder) {
  int devices = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".xml") continue;
    const auto file = read_esi(entry.path().string());
    if (!file) continue;
    for (const DeviceDescription& device : file->devices) {
      Project project;
      project.slaves = {default_slave(device, 0)};
      EXPECT_EQ(comes_back(project), "") << entry.path() << ' ' << device.type;
      ++devices;
    }
  }
  return devices;
}

TEST(WrittenIsRead, EveryDeviceOfEsiFiles) {
  EXPECT_GE(every_device(fs::path(test::source_dir()) / "resources/esi"), 9);
  const auto others = test::sample_folder();
  if (!others) return;
  EXPECT_GE(every_device(*others / "esi"), 500);
}

}  // namespace
}  // namespace syncline::eni
