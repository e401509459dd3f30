// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string esi(const std::string& devices) {
  return "<?xml version=\"1.0\"?>\n<EtherCATInfo>\n<Vendor><Id>#x5EC</Id><Name>Maker</Name></Vendor>\n<Descriptions>"
         "<Groups/><Devices>\n" +
         devices + "\n</Devices></Descriptions></EtherCATInfo>";
}

DeviceDescription read_one(const std::string& device) {
  const auto file = parse_esi(esi(device), "t.xml");
  EXPECT_TRUE(file.has_value());
  if (!file || file->devices.size() != 1) {
    ADD_FAILURE() << (file && !file->warnings.empty() ? file->warnings.front().reason.text() : "no device");
    return {};
  }
  return file->devices.front();
}

constexpr const char* kDrive = R"(
<Device Physics="YY">
  <Type ProductCode="#x00030924" RevisionNo="66592" SerialNo="7" CheckRevisionNo="LW_EQ" UseLrdLwr="1">Drive </Type>
  <HideType RevisionNo="#x00100001E"/>
  <Name LcId="1031"><![CDATA[Antrieb]]></Name>
  <Name LcId="1033"><![CDATA[Servo drive]]></Name>
  <Info><StateMachine><Timeout><PreopTimeout>2000</PreopTimeout><SafeopOpTimeout>9000</SafeopOpTimeout>
    <BackToInitTimeout>4000</BackToInitTimeout><BackToSafeopTimeout>300</BackToSafeopTimeout></Timeout></StateMachine>
    <Mailbox><Timeout><RequestTimeout>50</RequestTimeout><ResponseTimeout>6000</ResponseTimeout></Timeout></Mailbox></Info>
  <GroupType>Servo</GroupType>
  <Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu><Fmmu>MBoxState</Fmmu><Fmmu/>
  <Sm MinSize="34" MaxSize="#x100" DefaultSize="128" StartAddress="#x1800" ControlByte="#x26" Enable="1">MBoxOut</Sm>
  <Sm DefaultSize="128" StartAddress="#x1900" ControlByte="#x22" Enable="1">MBoxIn</Sm>
  <Sm StartAddress="#x1100" ControlByte="#x24" Enable="1" OpOnly="1">Outputs</Sm>
  <Sm StartAddress="#x1180" ControlByte="#x20" Enable="0" Virtual="true">Inputs</Sm>
  <RxPdo Fixed="1" Mandatory="true" Sm="2">
    <Index DependOnSlot="1">#x1600</Index><Name>Outputs</Name><Exclude>#x1601</Exclude>
    <Entry><Index>#x6040</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Control word</Name><DataType>UINT</DataType></Entry>
    <Entry><Index>0</Index><BitLen>8</BitLen></Entry>
  </RxPdo>
  <TxPdo><Index>#x1a00</Index><Name LcId="1033">Inputs</Name></TxPdo>
  <Mailbox DataLinkLayer="1"><EoE IP="1"/><CoE SdoInfo="1" PdoAssign="true" CompleteAccess="0" SegmentedSdo="1">
    <InitCmd Fixed="1" CompleteAccess="1"><Transition>PS</Transition><Transition>SO</Transition><Index>#x6060</Index>
      <SubIndex>#x0</SubIndex><Data AdaptAutomatically="1">08</Data><Comment>Op mode</Comment></InitCmd>
  </CoE><FoE/></Mailbox>
  <Dc UnknownFRMW="1" PotentialReferenceClock="1"><OpMode><Name>DcSync</Name><Desc>DC with SYNC0</Desc>
    <AssignActivate>#x0730</AssignActivate><CycleTimeSync0 Factor="1">0</CycleTimeSync0>
    <ShiftTimeSync0 Input="1">50000</ShiftTimeSync0><CycleTimeSync1 Factor="-2"/><ShiftTimeSync1>-25</ShiftTimeSync1>
    <Sm No="2"><SyncType>2</SyncType><CycleTime Factor="1">0</CycleTime><Pdo>#x1600</Pdo></Sm></OpMode></Dc>
  <ESC><Reg0400>#x09c2</Reg0400><Reg0420>1000</Reg0420></ESC>
  <Eeprom><ByteSize>4096</ByteSize><ConfigData>050C 8008</ConfigData><BootStrap>0018800000188000</BootStrap></Eeprom>
</Device>)";

TEST(EsiReader, ReadsIdentityAndNames) {
  const auto device = read_one(kDrive);
  EXPECT_EQ(device.identity, (Identity{0x5EC, 0x30924, 0x10420, 7}));
  EXPECT_EQ(device.vendor_name, "Maker");
  EXPECT_EQ(device.type, "Drive ") << "the space belongs to the slave name of other tools";
  EXPECT_EQ(device.name, "Servo drive");
  EXPECT_EQ(device.group_type, "Servo");
  EXPECT_EQ(device.physics, "YY");
  EXPECT_EQ(device.check_revision, RevisionCheck::kLowWordEqual);
  EXPECT_TRUE(device.use_lrd_lwr);
  EXPECT_EQ(device.source, "t.xml");
  EXPECT_EQ(device.timeouts, (StateTimeouts{2000, 9000, 4000, 300}));
}

TEST(EsiReader, ReadsSyncManagersAndFmmus) {
  const auto device = read_one(kDrive);
  EXPECT_THAT(device.fmmus, ElementsAre(FmmuUse::kOutputs, FmmuUse::kInputs, FmmuUse::kMailboxState, FmmuUse::kUnused));
  ASSERT_THAT(device.sync_managers, SizeIs(4));
  EXPECT_EQ(device.sync_managers[0],
            (SyncManagerDescription{SyncManagerType::kMailboxOut, 0x1800, 34, 256, 128, 0x26, true, false, false}));
  EXPECT_TRUE(device.sync_managers[2].op_only);
  EXPECT_TRUE(device.sync_managers[3].is_virtual);
  EXPECT_FALSE(device.sync_managers[3].enable);
  EXPECT_EQ(device.reg_0400, 0x09C2);
  EXPECT_EQ(device.reg_0410, std::nullopt);
  EXPECT_EQ(device.reg_0420, 1000);
}

TEST(EsiReader, ReadsPdosWithPadding) {
  const auto device = read_one(kDrive);
  ASSERT_THAT(device.rx_pdos, SizeIs(1));
  const Pdo& pdo = device.rx_pdos[0];
  EXPECT_TRUE(pdo.fixed);
  EXPECT_TRUE(pdo.mandatory);
  EXPECT_EQ(pdo.sync_manager, 2);
  EXPECT_THAT(pdo.exclude, ElementsAre(0x1601));
  EXPECT_THAT(pdo.entries, ElementsAre(PdoEntry{0x6040, 0, 16, "Control word", "UINT"}, PdoEntry{0, 0, 8, "", ""}));
  EXPECT_EQ(pdo.bit_length(), 24U);
  ASSERT_THAT(device.tx_pdos, SizeIs(1));
  EXPECT_EQ(device.tx_pdos[0].sync_manager, std::nullopt);
}

TEST(EsiReader, ReadsMailboxAndInitCommands) {
  const auto device = read_one(kDrive);
  ASSERT_TRUE(device.mailbox && device.mailbox->coe);
  EXPECT_TRUE(device.mailbox->data_link_layer && device.mailbox->eoe && device.mailbox->foe);
  EXPECT_FALSE(device.mailbox->aoe || device.mailbox->soe || device.mailbox->voe);
  EXPECT_EQ(device.mailbox->request_timeout_ms, 50U);
  EXPECT_EQ(device.mailbox->response_timeout_ms, 6000U);
  const auto& coe = *device.mailbox->coe;
  EXPECT_TRUE(coe.sdo_info && coe.pdo_assign && coe.segmented_sdo);
  EXPECT_FALSE(coe.complete_access || coe.pdo_config);
  ASSERT_THAT(coe.init_commands, SizeIs(1));
  EXPECT_EQ(coe.init_commands[0], (StartupCommand{.transitions = {Transition::kPS, Transition::kSO},
                                                  .index = 0x6060,
                                                  .sub_index = 0,
                                                  .data = {8},
                                                  .complete_access = true,
                                                  .fixed = true,
                                                  .comment = "Op mode",
                                                  .adapt_automatically = true}));
}

TEST(EsiReader, ReadsOperationModesAndEeprom) {
  const auto device = read_one(kDrive);
  ASSERT_TRUE(device.dc);
  EXPECT_TRUE(device.dc->unknown_frmw && device.dc->potential_reference_clock);
  ASSERT_THAT(device.dc->op_modes, SizeIs(1));
  const auto& mode = device.dc->op_modes[0];
  EXPECT_EQ(mode.name, "DcSync");
  EXPECT_EQ(mode.assign_activate, 0x0730);
  EXPECT_EQ(mode.cycle_time_sync0, (DcTime{0, 1, false}));
  EXPECT_EQ(mode.shift_time_sync0, (DcTime{50000, std::nullopt, true}));
  EXPECT_EQ(mode.cycle_time_sync1, (DcTime{0, -2, false}));
  EXPECT_EQ(mode.shift_time_sync1, (DcTime{-25, std::nullopt, false}));
  OpModeSyncManager outputs{2, 2, {0x1600}};
  outputs.cycle_time = OpModeTime{.factor = 1};
  EXPECT_THAT(mode.sync_managers, ElementsAre(outputs));
  EXPECT_EQ(device.eeprom.byte_size, 4096U);
  EXPECT_THAT(device.eeprom.config_data, ElementsAre(0x05, 0x0C, 0x80, 0x08));
  EXPECT_THAT(device.eeprom.boot_strap, SizeIs(8));
}

TEST(EsiReader, FlattensTheDictionary) {
  const auto device =
      read_one(R"(<Device Physics="YY"><Type ProductCode="1">D</Type><Profile><ProfileNo>5001</ProfileNo>
    <AddInfo>2</AddInfo><Dictionary><DataTypes>
      <DataType><Name>UDINT</Name><BitSize>32</BitSize></DataType>
      <DataType><Name>ARR</Name><BaseType>UDINT</BaseType><BitSize>64</BitSize><ArrayInfo><LBound>1</LBound><Elements>2</Elements></ArrayInfo></DataType>
      <DataType><Name>DT2000</Name><BitSize>80</BitSize>
        <SubItem><SubIdx>0</SubIdx><Name>Count</Name><Type>USINT</Type><BitSize>8</BitSize><Flags><Access>ro</Access></Flags></SubItem>
        <SubItem><Name>Elements</Name><Type>ARR</Type><BitSize>64</BitSize><BitOffs>16</BitOffs><Flags><Access WriteRestrictions="PreOP">rw</Access></Flags></SubItem>
      </DataType></DataTypes><Objects>
      <Object><Index>#x1000</Index><Name>Device type</Name><Type>UDINT</Type><BitSize>32</BitSize><Info><DefaultData>92010200</DefaultData></Info></Object>
      <Object><Index>#x2000</Index><Name>List</Name><Type>DT2000</Type><BitSize>80</BitSize>
        <Info><SubItem><Name>Count</Name><Info><DefaultValue>2</DefaultValue></Info></SubItem><SubItem><Name>First</Name></SubItem></Info></Object>
      <Object><Index>broken</Index><Type>UDINT</Type></Object>
    </Objects></Dictionary></Profile></Device>)");
  EXPECT_THAT(device.profiles, ElementsAre(ChannelProfile{5001, 2}));
  ASSERT_THAT(device.dictionary, SizeIs(2)) << "the broken object alone is left out";
  EXPECT_THAT(device.dictionary[0].entries,
              ElementsAre(ObjectEntry{0, "Device type", "UDINT", 32, true, false, {0x92, 0x01, 0x02, 0x00}}));
  ObjectEntry first{1, "First", "UDINT", 32, true, true, {}}, second{2, "SubIndex 002", "UDINT", 32, true, true, {}};
  first.bit_offset = 16;
  second.bit_offset = 48;
  first.write_restrictions = second.write_restrictions = "PreOP";
  EXPECT_THAT(device.dictionary[1].entries,
              ElementsAre(ObjectEntry{0, "Count", "USINT", 8, true, false, {2}}, first, second));
  EXPECT_EQ(device.dictionary[1].code, ObjectCode::kArray);
}

TEST(EsiReader, BrokenDeviceIsLeftOutWithLineAndElement) {
  const auto file =
      parse_esi(esi("<Device><Type ProductCode=\"1\">A</Type>\n<RxPdo><Index>oops</Index></RxPdo></Device>\n"
                    "<Device><Type ProductCode=\"2\">B</Type></Device>\n<Device/>"),
                "t.xml");
  ASSERT_TRUE(file);
  ASSERT_THAT(file->devices, SizeIs(1));
  EXPECT_EQ(file->devices[0].type, "B");
  ASSERT_THAT(file->warnings, SizeIs(2));
  EXPECT_EQ(file->warnings[0].line, 6);
  EXPECT_EQ(file->warnings[0].element, "Index");
  EXPECT_THAT(file->warnings[0].reason.text(), HasSubstr("Device A is left out"));
  EXPECT_THAT(file->warnings[0].reason.text(), HasSubstr("t.xml:6"));
  EXPECT_EQ(file->warnings[1].element, "Type");
}

TEST(EsiReader, UnknownWordsAreToleratedWithAWarning) {
  const auto file = parse_esi(esi("<Device><Type>A</Type><Fmmu>Own</Fmmu><Sm ControlByte=\"#x64\">OwnOut</Sm>"
                                  "<Sm ControlByte=\"#x20\">OwnIn</Sm><Sm ControlByte=\"#x22\">OwnBox</Sm></Device>"),
                              "t.xml");
  ASSERT_TRUE(file);
  ASSERT_THAT(file->devices, SizeIs(1));
  const auto& managers = file->devices[0].sync_managers;
  EXPECT_EQ(managers[0].type, SyncManagerType::kOutputs);
  EXPECT_EQ(managers[1].type, SyncManagerType::kInputs);
  EXPECT_EQ(managers[2].type, SyncManagerType::kMailboxIn);
  EXPECT_THAT(file->warnings, SizeIs(4));
}

TEST(EsiReader, OtherFilesAreRefusedWithTheirReason) {
  EXPECT_EQ(read_esi("/no/such/file.xml").error().code, ErrorCode::kFileNotFound);
  const auto other = parse_esi("<EtherCATConfig/>", "t.xml");
  EXPECT_EQ(other.error().code, ErrorCode::kNotThatKindOfFile);
  EXPECT_THAT(other.error().detail.text(), HasSubstr("EtherCATConfig"));
  const auto no_vendor = parse_esi("<EtherCATInfo>\n<Descriptions/></EtherCATInfo>", "t.xml");
  EXPECT_EQ(no_vendor.error().code, ErrorCode::kXmlMissingElement);
  EXPECT_EQ(no_vendor.error().subject, "Vendor");
  EXPECT_EQ(no_vendor.error().line, 1);
  EXPECT_EQ(parse_esi(kDrive + std::string("<"), "t.xml").error().code, ErrorCode::kXmlMalformed);
}

TEST(EsiReader, LatinOneBecomesUtf8) {
  const auto device = read_one(
      "<Device><Type>A</Type><Name>Gr\xF6\xDF"
      "e \xB5s</Name></Device>");
  EXPECT_EQ(device.name, "Größe µs");
}

TEST(EsiWriter, ReadingWhatWasWrittenGivesTheSame) {
  const auto device = read_one(kDrive);
  const auto again = parse_esi(write_esi(device), "t.xml");
  ASSERT_TRUE(again);
  EXPECT_THAT(again->warnings, IsEmpty());
  EXPECT_THAT(again->devices, ElementsAre(device));
}

}  // namespace
}  // namespace syncline::eni
