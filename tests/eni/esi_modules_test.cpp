// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "eni/esi/esi_reader.h"
#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kHead = "<EtherCATInfo><Vendor><Id>2</Id><Name>Maker</Name></Vendor>";
constexpr const char* kGroups = R"(<Groups><Group SortOrder="4" ParentGroup="Top"><Type>IO</Type>
  <Name LcId="1033">Stations</Name><Name LcId="1031">Stationen</Name></Group></Groups>)";
constexpr const char* kStation = R"(<Devices><Device Physics="YKY" Invisible="1">
  <Type ProductCode="7" RevisionNo="3" CheckProductCode="EQ" CheckRevisionNo="EQ_OR_G" CheckSerialNo="NONE" ModulePdoGroup="0"
    DownloadModuleList="1">Station</Type>
  <HideType RevisionNo="1"/><HideType ProductRevision="Station-0000-0001">Station</HideType>
  <AlternativeType ProductCode="8" RevisionNo="1"/><SubDevice ProductCode="9" RevisionNo="2"/>
  <Name LcId="1031">Haus</Name><Name LcId="1033">House</Name>
  <Info><Electrical><EBusCurrent>-500</EBusCurrent></Electrical>
    <StateMachine><Behavior StartToSafeopNoSync="1"/></StateMachine>
    <EtherCATController><DpramSize>8192</DpramSize><SmCount>8</SmCount><FmmuCount>4</FmmuCount></EtherCATController>
    <Port><Type>MII</Type><Label>X1</Label><RxDelay>2000</RxDelay></Port>
    <IdentificationAdo>#x134</IdentificationAdo><IdentificationReg134>true</IdentificationReg134></Info>
  <GroupType>IO</GroupType>
  <Fmmu Sm="2" Su="1" OpOnly="1">Outputs</Fmmu><Fmmu>Inputs</Fmmu>
  <Sm StartAddress="#x1100" OneByteMode="1" Watchdog="0">Outputs</Sm>
  <Su SeparateSu="1" SeparateFrame="1" DependOnInputState="1" FrameRepeatSupport="1">Axes</Su>
  <RxPdo Su="1" OSFac="4" OSMin="1" OSMax="10" OSIndexInc="16" PdoOrder="-1" OverwrittenByModule="1"><Index>#x1600</Index>
    <Name>P</Name><Entry Fixed="1"><Index>#x7000</Index><BitLen>8</BitLen></Entry><ExcludedSm>3</ExcludedSm></RxPdo>
  <Mailbox RealTimeMode="1"><AoE AdsRouter="1"><InitCmd><Transition>PS</Transition><Data>0102</Data></InitCmd></AoE>
    <EoE IP="1" MAC="1" TimeStamp="1"><InitCmd><Transition>IP</Transition><Type>2</Type><Data>03</Data></InitCmd></EoE>
    <CoE DS402Channels="2" DiagHistory="1" EdsFile="s.eds"/>
    <SoE ChannelCount="2"><InitCmd Chn="1"><Transition>PS</Transition><IDN>33</IDN><Data>04</Data></InitCmd></SoE></Mailbox>
  <Dc ExternalRefClock="1"><OpMode><Name>M</Name><ShiftTimeSync0 OutputDelayTime="10" InputDelayTime="20">0</ShiftTimeSync0>
    <Sm No="2"><ShiftTime MinAfterSync="5" MinBeforeFrame="6">7</ShiftTime><Pdo OSFac="4">#x1600</Pdo></Sm></OpMode></Dc>
  <Slots MaxSlotCount="4" MaxSlotGroupCount="1" SlotPdoIncrement="1" SlotIndexIncrement="16" SlotGroupPdoIncrement="#x100"
      IdentifyModuleBy="IdentityObjekt" DownloadModuleIdentList="1">
    <Slot MinInstances="0" MaxInstances="2" SlotGroup="0" SlotPdoIncrement="2"><Name>In</Name>
      <ModuleIdent>#x10</ModuleIdent><ModuleIdent Default="1">#x11</ModuleIdent></Slot>
    <Slot MinInstances="1" MaxInstances="1"><Name>Any</Name><ModuleClass><Class>AX</Class><Name>Axes</Name></ModuleClass></Slot>
    <ModulePdoGroup Alignment="2" RxPdo="#x16FF" TxPdo="#x1AFF">Words</ModulePdoGroup></Slots>
  <ESC><Reg0108>#x11</Reg0108></ESC>
  <Eeprom AssignToPdi="1"><ByteSize>2048</ByteSize><ConfigData>05</ConfigData>
    <Category><CatNo>2049</CatNo><DataUINT>513</DataUINT></Category></Eeprom>
  <ImageData16x14>424D</ImageData16x14></Device></Devices>)";
constexpr const char* kModules = R"(<Modules>
  <Module><Type ModuleIdent="#x10" ModulePdoGroup="1">DI</Type><Name>Digital</Name>
    <TxPdo><Index DependOnSlot="1">#x1A00</Index><Name>I</Name><Exclude DependOnSlot="1">#x1A01</Exclude>
      <Entry><Index DependOnSlot="1">#x6000</Index><SubIndex>1</SubIndex><BitLen>1</BitLen></Entry></TxPdo>
    <Mailbox><CoE ModuleOD="1"><InitCmd CompleteAccess="1"><Transition>PS</Transition><Index DependOnSlot="1">#x8000</Index>
      <SubIndex>0</SubIndex><Data AdaptAutomatically="1">00</Data></InitCmd></CoE></Mailbox></Module>
  <Module><Type ModuleIdent="#x11">DO</Type><Name>Out</Name></Module>
  <Module><Type ModuleIdent="#x12" ModuleClass="AX">Axis</Type><Name>Axis</Name><DcOpModeName>M</DcOpModeName></Module>
  <Module><Type ModuleIdent="#x13">Other</Type><Name>No slot takes it</Name></Module>
  <Module><Type>broken</Type><Name>No ident</Name></Module></Modules>)";

std::string station(const std::string& references = "") {
  return std::string(kHead) + references + "<Descriptions>" + kGroups + kStation + kModules +
         "</Descriptions></EtherCATInfo>";
}

TEST(EsiModules, SlotsSayWhichModulesFit) {
  const auto file = parse_esi(station(), "s.xml");
  ASSERT_TRUE(file);
  ASSERT_THAT(file->devices, SizeIs(1)) << file->warnings.front().reason.text();
  const auto& device = file->devices.front();
  ASSERT_TRUE(device.slots);
  EXPECT_EQ(device.slots->max_slot_count, 4);
  EXPECT_EQ(device.slots->increments.slot_pdo, 1);
  EXPECT_EQ(device.slots->increments.slot_group_pdo, 0x100);
  EXPECT_EQ(device.slots->slots[0].increments.slot_pdo, 2);
  EXPECT_EQ(device.slots->identify_by, ModuleIdentification::kIdentityObject);
  EXPECT_TRUE(device.slots->download_ident_list);
  EXPECT_EQ(device.slots->slots[0].default_module(), 0x11U) << "the one that is marked";
  EXPECT_THAT(device.slots->slots[1].classes, ElementsAre(ModuleClass{"AX", std::nullopt, "Axes"}));
  EXPECT_THAT(device.slots->pdo_groups, ElementsAre(ModulePdoGroup{"Words", 2, 0x16FF, 0x1AFF}));
  EXPECT_THAT(device.modules,
              ElementsAre(Field(&ModuleDescription::ident, 0x10U), Field(&ModuleDescription::ident, 0x11U),
                          Field(&ModuleDescription::ident, 0x12U)))
      << "by ident or by class; others are no use to this device";
  const auto& digital = *device.module(0x10);
  EXPECT_TRUE(digital.tx_pdos[0].depend_on_slot);
  EXPECT_TRUE(digital.tx_pdos[0].entries[0].depend_on_slot);
  EXPECT_THAT(digital.tx_pdos[0].exclude_by_slot, ElementsAre(0x1A01));
  EXPECT_TRUE(digital.coe->init_commands[0].depend_on_slot);
  EXPECT_TRUE(digital.coe->init_commands[0].adapt_automatically);
  EXPECT_EQ(device.module(0x12)->dc_op_mode, "M");
  ASSERT_THAT(file->warnings, SizeIs(1));
  EXPECT_THAT(file->warnings[0].reason.text(), HasSubstr("the module is left out"));
}

TEST(EsiModules, DeviceKeepsAllThatTheFileSaysOfIt) {
  const auto file = parse_esi(station(), "s.xml");
  ASSERT_TRUE(file && file->devices.size() == 1);
  const auto& device = file->devices.front();
  EXPECT_TRUE(device.invisible);
  EXPECT_EQ(device.group_name, "Stations");
  EXPECT_EQ(device.check_revision, RevisionCheck::kEqualOrGreater);
  EXPECT_EQ(device.check_product_code, true);
  EXPECT_EQ(device.check_serial_no, false);
  EXPECT_THAT(device.hides, ElementsAre(DeviceReference{"", std::nullopt, 1, ""},
                                        DeviceReference{"Station", std::nullopt, std::nullopt, "Station-0000-0001"}));
  EXPECT_EQ(device.ebus_current_ma, -500);
  EXPECT_EQ(device.identification_ado, 0x134);
  EXPECT_TRUE(device.identification_reg134);
  EXPECT_EQ(device.fmmu_count, 4);
  EXPECT_TRUE(device.behavior.to_safeop_no_sync);
  EXPECT_THAT(device.ports, ElementsAre(PortDescription{"MII", "", "X1", 2000, std::nullopt}));
  EXPECT_EQ(device.reg_0108, 0x11);
  EXPECT_THAT(device.fmmu_options, ElementsAre(FmmuOptions{2, 1, true}, FmmuOptions{}));
  EXPECT_THAT(device.sync_units, ElementsAre(SyncUnitDescription{"Axes", true, true, true, true}));
  EXPECT_EQ(device.rx_pdos[0].os_factor, 4);
  EXPECT_EQ(device.rx_pdos[0].order, -1);
  EXPECT_EQ(device.mailbox->soe_options.init_commands.at(0).drive, 1);
  EXPECT_EQ(device.mailbox->eoe_options.init_commands.at(0).type, 2);
  const auto& manager = device.dc->op_modes[0].sync_managers[0];
  EXPECT_THAT(manager.oversampling, ElementsAre(PdoOversampling{0x1600, 4}));
  EXPECT_EQ(manager.shift_time, (OpModeTime{7, std::nullopt, 5, 6}));
  EXPECT_EQ(device.dc->op_modes[0].shift_time_sync0.output_delay_ns, 10);
  EXPECT_THAT(device.eeprom.categories, ElementsAre(EepromCategory{2049, {0x01, 0x02}}));
  EXPECT_THAT(device.image.data, ElementsAre(0x42, 0x4D));
}

TEST(EsiModules, WriterKeepsThemToo) {
  const auto file = parse_esi(station(), "s.xml");
  ASSERT_TRUE(file && file->devices.size() == 1);
  const auto again = parse_esi(write_esi(file->devices.front()), "s.xml");
  ASSERT_TRUE(again);
  EXPECT_THAT(again->warnings, IsEmpty());
  EXPECT_TRUE(again->devices == file->devices);
}

TEST(EsiLanguages, NamesAreInTheChosenOneElseInEnglish) {
  const auto german = parse_esi(station(), "s.xml", {.language = 1031});
  ASSERT_TRUE(german && german->devices.size() == 1);
  EXPECT_EQ(german->devices[0].name, "Haus");
  EXPECT_EQ(german->devices[0].group_name, "Stationen");
  const auto french = parse_esi(station(), "s.xml", {.language = 1036});
  EXPECT_EQ(french->devices.at(0).name, "House");
  EXPECT_THAT(french->devices[0].names, ElementsAre(LocalizedText{1031, "Haus"}, LocalizedText{1033, "House"}));
}

class EsiSideFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("esi_side_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::filesystem::path folder_;
};

constexpr const char* kPlain = R"(<Descriptions><Groups/><Devices><Device Physics="YY"><Type ProductCode="1">A</Type>
  <Profile><ProfileNo>5001</ProfileNo><DictionaryFile>a_dict.xml</DictionaryFile></Profile>
  <Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>#x55</ModuleIdent></Slot></Slots></Device></Devices></Descriptions>)";

TEST_F(EsiSideFiles, DictionaryAndModulesComeFromOtherFiles) {
  write("a_dict.xml",
        "<EtherCATDict><Dictionary><Objects><Object><Index>#x2000</Index><Name>Gain</Name><Type>UINT</Type>"
        "<BitSize>16</BitSize></Object></Objects></Dictionary></EtherCATDict>");
  // It refers back to the file that refers to it.
  write("a_mod.xml",
        "<EtherCATModule><InfoReference>a.xml</InfoReference><Modules><Module><Type ModuleIdent=\"#x55\">M</Type>"
        "<Name>M</Name></Module></Modules></EtherCATModule>");
  const auto path =
      write("a.xml", std::string(kHead) + "<InfoReference>a_mod.xml</InfoReference>" + kPlain + "</EtherCATInfo>");
  const auto file = read_esi(path);
  ASSERT_TRUE(file);
  ASSERT_THAT(file->devices, SizeIs(1));
  EXPECT_THAT(file->warnings, IsEmpty());
  EXPECT_THAT(file->devices[0].dictionary, ElementsAre(Field(&ObjectDescription::name, "Gain")));
  EXPECT_NE(file->devices[0].module(0x55), nullptr);
}

TEST_F(EsiSideFiles, WhatIsMissingOrElsewhereIsAWarningAtTheReference) {
  const auto path = write(
      "a.xml", std::string(kHead) + "\n<InfoReference>../../etc/passwd</InfoReference>" + kPlain + "</EtherCATInfo>");
  const auto file = read_esi(path);
  ASSERT_TRUE(file);
  ASSERT_THAT(file->devices, SizeIs(1));
  ASSERT_THAT(file->warnings, SizeIs(3));
  EXPECT_EQ(file->warnings[0].line, 2);
  EXPECT_EQ(file->warnings[0].element, "InfoReference");
  EXPECT_THAT(file->warnings[0].reason.text(), HasSubstr("outside of the folder"));
  EXPECT_EQ(file->warnings[1].element, "DictionaryFile");
  EXPECT_THAT(file->warnings[2].reason.text(), HasSubstr("no file describes the module 0x00000055"));
}

}  // namespace
}  // namespace syncline::eni
