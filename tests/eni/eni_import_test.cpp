// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compile/eoe_ip.h"
#include "eni/check/check_bed.h"
#include "recover/recover_project.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Project with_eoe() {
  DeviceDescription drive = sample::servo();
  drive.mailbox->eoe = true;
  Project project = sample::project({sample::coupler(), drive, drive, drive});
  EoeSlaveSettings& eoe = project.slaves[1].eoe;
  eoe.ip = "192.168.1.10";
  eoe.subnet = "255.255.255.0";
  project.slaves[2].eoe.mac = {2, 0, 0, 0, 0, 7};
  project.slaves[2].eoe.ip = "192.168.1.11";
  project.slaves[2].eoe.host_name = "drive-2";
  return project;
}

TEST(EniImport, EoeSettingsComeBack) {
  const Project project = with_eoe();
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  EXPECT_EQ(compiled->config.master.eoe_settings.max_ports, 4U);
  EXPECT_EQ(compiled->config.master.eoe_settings.max_frames, 160U) << "100 and 20 for each of three slaves";
  const auto imported = eni::import_eni_text(eni::write_eni(compiled->config), "eoe.xml");
  ASSERT_TRUE(imported);
  EXPECT_THAT(imported->unread, IsEmpty());
  const auto recovered = recover_project(imported->config);
  for (std::size_t i = 1; i < project.slaves.size(); ++i) {
    EXPECT_EQ(recovered.project.slaves[i].eoe, project.slaves[i].eoe) << i;
  }
}

/// Address, mask and gateway as one tool writes them: 62 bytes, or without the header in front.
TEST(EniImport, SetIpCommandsOfOtherTools) {
  std::vector<std::uint8_t> bytes{0x02, 0, 0, 0,   0x3F, 0, 0,   0,   0x10, 0x18, 0x9E, 0xFF, 1,
                                  4,    4, 1, 168, 192,  0, 255, 255, 255,  10,   1,    168,  192};
  bytes.resize(62);
  EoeSlaveSettings expected;
  expected.mac = {0x10, 0x18, 0x9E, 0xFF, 1, 4};
  expected.ip = "192.168.1.4";
  expected.subnet = "255.255.255.0";
  expected.gateway = "192.168.1.10";
  EXPECT_EQ(decode_ip_parameters(bytes, 1001), expected);
  EXPECT_EQ(decode_ip_parameters(std::span(bytes).subspan(4), 1001), expected);
  bytes[0] = 0x06;  // get IP
  EXPECT_EQ(decode_ip_parameters(bytes, 1001), std::nullopt);
  EXPECT_EQ(decode_ip_parameters({}, 1001), std::nullopt);
}

/// What EoE sends beside the address is kept, through the file and back.
TEST(EniImport, OtherEoeCommandsAndOwnRegistersAreKept) {
  auto project = with_eoe();
  project.slaves[3].eoe_startup = {{.transitions = {Transition::kPS}, .data = {4, 0, 0, 0, 1}, .comment = "filter"}};
  RegisterCommand own;
  own.address = 0x0F10;
  own.data = {1, 2};
  own.comment = "outputs";
  project.slaves[2].register_commands = project.master.register_commands = {own};
  const auto text = eni::write_eni(compile(project)->config);
  EXPECT_THAT(text, HasSubstr("<Ado>3856</Ado>"));
  const auto imported = eni::import_eni_text(text, "eoe.xml");
  ASSERT_TRUE(imported);
  const auto recovered = recover_project(imported->config);
  EXPECT_EQ(recovered.project.slaves[3].eoe_startup, project.slaves[3].eoe_startup);
  EXPECT_EQ(recovered.project.slaves[2].register_commands, project.slaves[2].register_commands);
  EXPECT_EQ(recovered.project.master.register_commands, project.master.register_commands);
  for (const Finding& finding : recovered.findings) EXPECT_NE(finding.code, "startup-lost");
}

TEST(EniImport, WhatIsNotReadIsNamedOnceWithItsLine) {
  std::string text = eni::write_eni(checked_machine());
  text = replaced(text, "<VendorId>", "<Colour>red</Colour><VendorId>");
  text = replaced(text, "<Cyclic", "<Slave><Info><Name>Cap</Name><VendorId>2</VendorId></Info></Slave><Cyclic");
  const auto imported = eni::import_eni_text(text, "other.xml");
  ASSERT_TRUE(imported);
  ASSERT_EQ(imported->unread.size(), 2U);
  EXPECT_THAT(describe(imported->unread[0]), HasSubstr("<Colour> in <Info>"));
  EXPECT_THAT(describe(imported->unread[1]), HasSubstr("end caps"));
  EXPECT_THAT(describe(imported->unread[0]), HasSubstr("Line "));
}

/// Where it names nobody in the file it hangs nowhere, the first one too.
TEST(EniImport, APreviousPortOfNobodyIsNone) {
  const std::string text =
      replaced(eni::write_eni(checked_machine()), "<Slave>",
               "<Slave><PreviousPort Selected=\"1\"><Port>B</Port><PhysAddr>9999</PhysAddr></PreviousPort>");
  const auto imported = eni::import_eni_text(text, "other.xml");
  ASSERT_TRUE(imported);
  EXPECT_FALSE(imported->config.slaves[0].previous);
  EXPECT_TRUE(imported->config.slaves[1].previous);
}

/// What the schema knows and nobody reads; and what it does not know either is no second finding.
TEST(EniImport, WhatMakersAddIsNamedWithItsFirstLineAndHowOften) {
  std::string text = eni::write_eni(checked_machine());
  text = replaced(text, "<Config>", "<Manufacturer>A</Manufacturer>\n<Manufacturer>B</Manufacturer>\n<Config>");
  text = replaced(text, "<VendorId>", "<VendorSpecific>x</VendorSpecific><VendorId>");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(text.find("<Manufacturer>")), '\n');
  const auto imported = eni::import_eni_text(text, "other.xml");
  ASSERT_TRUE(imported);
  ASSERT_EQ(imported->unread.size(), 2U);
  EXPECT_THAT(describe(imported->unread[0]), HasSubstr("<VendorSpecific> in <Info>"));
  EXPECT_THAT(describe(imported->unread[1]), HasSubstr("<Manufacturer> in <EtherCATConfig>, 2 times"));
  EXPECT_THAT(describe(imported->unread[1]), HasSubstr("Line " + std::to_string(line)));
}

}  // namespace
}  // namespace syncline::test
