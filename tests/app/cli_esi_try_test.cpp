// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "cli_process.h"
#include "cli_runner.h"
#include "engine/try_esi.h"
#include "eni/trial/eni_trial_files.h"
#include "support/sample_folder.h"
#include "tests/support/source_dir.h"

namespace syncline::cli {
namespace {

using ::testing::HasSubstr;

std::string esi(const std::string& devices, const std::string& modules = "") {
  return "<EtherCATInfo><Vendor><Id>#x5C17</Id><Name>Maker</Name></Vendor><Descriptions><Groups/><Devices>" + devices +
         "</Devices>" + modules + "</Descriptions></EtherCATInfo>";
}

/// A terminal with two bytes of outputs in neighbouring SyncManagers and one FMMU for both.
constexpr const char* kNeighbours = R"(<Device Physics="KK"><Type ProductCode="1" RevisionNo="1">DO16</Type>
  <Fmmu OpOnly="1">Outputs</Fmmu>
  <Sm DefaultSize="1" StartAddress="#x0f00" ControlByte="#x44" Enable="1" OpOnly="1">Outputs</Sm>
  <Sm DefaultSize="1" StartAddress="#x0f01" ControlByte="#x44" Enable="1" OpOnly="1">Outputs</Sm>
  <RxPdo Fixed="1" Mandatory="1" Sm="0"><Index>#x1600</Index><Name>A</Name>
    <Entry><Index>#x7000</Index><SubIndex>1</SubIndex><BitLen>8</BitLen><Name>A</Name><DataType>USINT</DataType></Entry></RxPdo>
  <RxPdo Fixed="1" Mandatory="1" Sm="1"><Index>#x1601</Index><Name>B</Name>
    <Entry><Index>#x7010</Index><SubIndex>1</SubIndex><BitLen>8</BitLen><Name>B</Name><DataType>USINT</DataType></Entry></RxPdo>
  <Eeprom><ByteSize>2048</ByteSize><ConfigData>0401000000000000</ConfigData></Eeprom></Device>)";

/// Latched times as process data: a register behind a virtual SyncManager.
constexpr const char* kRegisters = R"(<Device Physics="KK"><Type ProductCode="2" RevisionNo="1">LATCH</Type>
  <Fmmu Sm="0">Inputs</Fmmu><Fmmu Sm="1">Inputs</Fmmu>
  <Sm DefaultSize="1" StartAddress="#x1000" ControlByte="#x00" Enable="1">Inputs</Sm>
  <Sm StartAddress="#x0990" Virtual="true">Inputs</Sm>
  <TxPdo Fixed="1" Mandatory="1" Sm="0"><Index>#x1A00</Index><Name>Channel</Name>
    <Entry><Index>#x6000</Index><SubIndex>1</SubIndex><BitLen>8</BitLen><Name>In</Name><DataType>USINT</DataType></Entry></TxPdo>
  <TxPdo Fixed="1" Sm="1" Virtual="true"><Index>#x1A10</Index><Name>Time</Name>
    <Entry><Index>#x1D09</Index><SubIndex>#x90</SubIndex><BitLen>64</BitLen><Name>Time</Name><DataType>ULINT</DataType></Entry></TxPdo>
  <Dc><OpMode><Name>Dc</Name><AssignActivate>#x0300</AssignActivate><CycleTimeSync0 Factor="1">0</CycleTimeSync0></OpMode></Dc>
  <Eeprom><ByteSize>2048</ByteSize><ConfigData>0401000000000000</ConfigData></Eeprom></Device>)";

constexpr const char* kMailboxes = R"(
  <Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu>
  <Sm MinSize="64" MaxSize="256" DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>
  <Sm MinSize="64" MaxSize="256" DefaultSize="128" StartAddress="#x1080" ControlByte="#x22" Enable="1">MBoxIn</Sm>
  <Sm StartAddress="#x1100" ControlByte="#x64" Enable="1">Outputs</Sm>
  <Sm StartAddress="#x1400" ControlByte="#x20" Enable="1">Inputs</Sm>
  <Mailbox><CoE SdoInfo="1" PdoAssign="1" PdoConfig="1" CompleteAccess="1"/></Mailbox>)";

/// Two slots with an analogue module each; the module writes an object that no dictionary names.
std::string modular() {
  return std::string(R"(<Device Physics="YY"><Type ProductCode="3" RevisionNo="1">STATION</Type>)") + kMailboxes +
         R"(<Slots MaxSlotCount="2" SlotPdoIncrement="1" SlotIndexIncrement="16">
           <Slot MinInstances="2" MaxInstances="2"><Name>Slot</Name><ModuleIdent Default="1">#x21</ModuleIdent></Slot></Slots>
         <Eeprom><ByteSize>2048</ByteSize><ConfigData>0500000000000000</ConfigData></Eeprom></Device>)";
}
constexpr const char* kModules = R"(<Modules><Module><Type ModuleIdent="#x21">AI</Type><Name>Analogue</Name>
  <RxPdo Sm="2"><Index DependOnSlot="1">#x1600</Index><Name>Out</Name>
    <Entry><Index DependOnSlot="1">#x7000</Index><SubIndex>1</SubIndex><BitLen>16</BitLen><Name>Out</Name><DataType>INT</DataType></Entry></RxPdo>
  <TxPdo Sm="3"><Index DependOnSlot="1">#x1A00</Index><Name>In</Name>
    <Entry><Index DependOnSlot="1">#x6000</Index><SubIndex>1</SubIndex><BitLen>32</BitLen><Name>In</Name><DataType>DINT</DataType></Entry></TxPdo>
  <Mailbox><CoE><InitCmd><Transition>PS</Transition><Index DependOnSlot="1">#x8000</Index><SubIndex>1</SubIndex>
    <Data>0100</Data></InitCmd></CoE></Mailbox></Module></Modules>)";

/// A safety module: outputs and inputs of its own for the safety frames, in SyncManagers 4 and 5.
constexpr const char* kSafety = R"(<Device Physics="YY"><Type ProductCode="11" RevisionNo="1">SAFE</Type>
  <Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu><Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu>
  <Sm MinSize="64" MaxSize="256" DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>
  <Sm MinSize="64" MaxSize="256" DefaultSize="128" StartAddress="#x1080" ControlByte="#x22" Enable="1">MBoxIn</Sm>
  <Sm StartAddress="#x1100" ControlByte="#x64" Enable="1">Outputs</Sm>
  <Sm StartAddress="#x1400" ControlByte="#x20" Enable="1">Inputs</Sm>
  <Sm StartAddress="#x1600" ControlByte="#x64" Enable="1">Outputs</Sm>
  <Sm StartAddress="#x1700" ControlByte="#x20" Enable="1">Inputs</Sm>
  <RxPdo Fixed="1" Sm="2"><Index>#x1600</Index><Name>A</Name>
    <Entry><Index>#x7000</Index><SubIndex>1</SubIndex><BitLen>16</BitLen><Name>A</Name><DataType>UINT</DataType></Entry></RxPdo>
  <RxPdo Fixed="1" Mandatory="1" Sm="4"><Index>#x1610</Index><Name>Safety out</Name>
    <Entry><Index>#x7080</Index><SubIndex>1</SubIndex><BitLen>48</BitLen><Name>Frame</Name><DataType>ARRAY [0..5] OF BYTE</DataType></Entry></RxPdo>
  <TxPdo Fixed="1" Sm="3"><Index>#x1A00</Index><Name>B</Name>
    <Entry><Index>#x6000</Index><SubIndex>1</SubIndex><BitLen>32</BitLen><Name>B</Name><DataType>UDINT</DataType></Entry></TxPdo>
  <TxPdo Fixed="1" Mandatory="1" Sm="5"><Index>#x1A10</Index><Name>Safety in</Name>
    <Entry><Index>#x6080</Index><SubIndex>1</SubIndex><BitLen>48</BitLen><Name>Frame</Name><DataType>ARRAY [0..5] OF BYTE</DataType></Entry></TxPdo>
  <Mailbox><CoE SdoInfo="1" PdoAssign="1"/></Mailbox>
  <Eeprom><ByteSize>2048</ByteSize><ConfigData>0500000000000000</ConfigData></Eeprom></Device>)";

/// A bus coupler whose start-up commands write objects that its dictionary calls read-only or does not have.
std::string coupler() {
  return std::string(R"(<Device Physics="YY"><Type ProductCode="12" RevisionNo="1">COUPLER</Type>
  <Profile><Dictionary><DataTypes><DataType><Name>UINT</Name><BitSize>16</BitSize></DataType></DataTypes>
    <Objects><Object><Index>#x4000</Index><Name>Table</Name><Type>UINT</Type><BitSize>16</BitSize>
      <Flags><Access>ro</Access></Flags></Object></Objects></Dictionary></Profile>
  <Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu>
  <Sm MinSize="64" MaxSize="256" DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>
  <Sm MinSize="64" MaxSize="256" DefaultSize="128" StartAddress="#x1080" ControlByte="#x22" Enable="1">MBoxIn</Sm>
  <Sm StartAddress="#x1100" ControlByte="#x64" Enable="1">Outputs</Sm>
  <Sm StartAddress="#x1400" ControlByte="#x20" Enable="1">Inputs</Sm>
  <TxPdo Fixed="1" Sm="3"><Index>#x1A00</Index><Name>B</Name>
    <Entry><Index>#x6000</Index><SubIndex>1</SubIndex><BitLen>32</BitLen><Name>B</Name><DataType>UDINT</DataType></Entry></TxPdo>
  <Mailbox><CoE SdoInfo="1">
    <InitCmd><Transition>PS</Transition><Index>#x4000</Index><SubIndex>0</SubIndex><Data>0100</Data></InitCmd>
    <InitCmd><Transition>PS</Transition><Index>#x4012</Index><SubIndex>1</SubIndex><Data>0100</Data></InitCmd>
    <InitCmd><Transition>PS</Transition><Index>#x1B00</Index><SubIndex>0</SubIndex><Data>00</Data></InitCmd></CoE></Mailbox>
  <Eeprom><ByteSize>2048</ByteSize><ConfigData>0500000000000000</ConfigData></Eeprom></Device>)");
}

/// A SoE drive with start-up commands on the way to PREOP, and a PDO that excludes itself.
std::string soe_drive() {
  std::string text = kSafety;
  text.replace(text.find("<CoE"), std::string("<CoE SdoInfo=\"1\" PdoAssign=\"1\"/>").size(),
               "<SoE><InitCmd><Transition>IP</Transition><IDN>15</IDN><Data>0700</Data></InitCmd>"
               "<InitCmd><Transition>PS</Transition><IDN>32</IDN><Data>0B00</Data></InitCmd></SoE>");
  text.replace(text.find("<Name>A</Name>"), 14, "<Name>A</Name><Exclude>#x1600</Exclude>");
  return text;
}

class EsiTry : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("esi_try_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  [[nodiscard]] TryReport report() const {
    auto report = try_esi({.path = folder_.string(), .threads = 1}, eni::trial_files());
    EXPECT_TRUE(report);
    return report ? *std::move(report) : TryReport{};
  }

  std::filesystem::path folder_;
};

void expect_passed(const TriedDevice& device, std::uint16_t wkc) {
  EXPECT_EQ(device.outcome, TryOutcome::kPassed)
      << device.type << ": " << step_name(device.step) << ": " << device.reason;
  EXPECT_EQ(device.wkc_expected, wkc) << device.type;
  EXPECT_GE(device.cycles, 50U) << device.type;
}

TEST_F(EsiTry, DevicesOfEveryKindReachOp) {
  write("a.xml", esi(kNeighbours));
  write("b.xml", esi(kRegisters));
  write("c.XML", esi(modular(), kModules));
  const auto tried = report();
  ASSERT_EQ(tried.devices.size(), 3U);
  EXPECT_EQ(tried.files, 3U);
  expect_passed(tried.devices[0], 2);  // LRW: written
  expect_passed(tried.devices[1], 1);  // read
  expect_passed(tried.devices[2], 3);
  EXPECT_EQ(tried.devices[2].modules, 2U);
}

TEST_F(EsiTry, OwnObjectsSafetyDataAndOddWordsAreNoFailures) {
  std::string no_mailbox = kNeighbours;
  no_mailbox.replace(no_mailbox.find("<Eeprom>"), 8, "<Mailbox/><Eeprom>");
  write("a.xml", esi(kSafety));
  write("b.xml", esi(coupler()));
  write("c.xml", esi(soe_drive()));
  write("d.xml", esi(no_mailbox));
  const auto tried = report();
  ASSERT_EQ(tried.devices.size(), 4U);
  expect_passed(tried.devices[0], 3);
  expect_passed(tried.devices[1], 1);
  expect_passed(tried.devices[2], 3);
  expect_passed(tried.devices[3], 2);
}

TEST_F(EsiTry, WhatCannotBeOnABusIsExcepted) {
  std::string turned = kNeighbours;
  turned.replace(turned.find("ControlByte=\"#x44\""), 18, "ControlByte=\"#x20\"");
  write("a.xml", esi(turned));
  write("b.xml", esi("<Device Physics=\"\"><Type>CAP</Type><Name>End cap</Name></Device>"));
  const auto tried = report();
  ASSERT_EQ(tried.devices.size(), 2U);
  for (const auto& device : tried.devices) EXPECT_EQ(device.outcome, TryOutcome::kExcepted) << device.reason;
  EXPECT_THAT(tried.devices[0].reason, HasSubstr("control byte 0x20"));
  EXPECT_THAT(tried.devices[1].reason, HasSubstr("no EtherCAT slave controller"));
}

TEST_F(EsiTry, DescriptionsThatContradictThemselvesAreExceptedWithTheReason) {
  std::string in_each_other = modular();
  in_each_other.replace(in_each_other.find("#x1080"), 6, "#x1040");
  write("a.xml", esi(in_each_other, kModules));
  std::string twice = kNeighbours;
  twice.replace(twice.find("#x1601"), 6, "#x1600");
  write("b.xml", esi(twice));
  std::string negative = kNeighbours;
  negative.replace(negative.find("<BitLen>8"), 9, "<BitLen>-8");
  write("c.xml", esi("\n" + negative));
  const auto tried = report();
  ASSERT_EQ(tried.devices.size(), 3U);
  for (const auto& device : tried.devices) EXPECT_EQ(device.outcome, TryOutcome::kExcepted) << device.reason;
  EXPECT_THAT(tried.devices[0].reason, HasSubstr("one mailbox"));
  EXPECT_THAT(tried.devices[1].reason, HasSubstr("0x1600 is used twice"));
  EXPECT_THAT(tried.devices[2].reason, HasSubstr("\"-8\" is out of range"));
  EXPECT_EQ(tried.devices[2].line, 7);
}

/// Whether the mapping could be changed is no matter: what the ESI assigns does not fit where the ESI puts it.
TEST_F(EsiTry, PdosThatDoNotFitIntoTheirSyncManagerAreExcepted) {
  std::string fixed = kNeighbours;
  fixed.replace(fixed.find("DefaultSize"), 0, "MaxSize=\"1\" ");
  fixed.replace(fixed.find("<BitLen>8"), 9, "<BitLen>24");
  std::string changeable = fixed;
  changeable.replace(changeable.find("Fixed=\"1\" "), 10, "");
  std::string together = kNeighbours;
  together.replace(together.find("DefaultSize"), 0, "MaxSize=\"1\" ");
  together.replace(together.find("Sm=\"1\"><Index"), 6, "Sm=\"0\"");
  std::string fits = together;
  fits.replace(fits.find("MaxSize=\"1\""), 11, "MaxSize=\"2\"");
  write("a.xml", esi(fixed));
  write("b.xml", esi(changeable));
  write("c.xml", esi(together));
  write("d.xml", esi(fits));
  const auto tried = report();
  ASSERT_EQ(tried.devices.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(tried.devices[i].outcome, TryOutcome::kExcepted) << i << tried.devices[i].reason;
    EXPECT_EQ(tried.devices[i].step, TryStep::kRead) << i;
  }
  EXPECT_EQ(tried.devices[1].reason, "the ESI assigns 3 bytes (PDO 0x1600) to SM0, which takes 1");
  EXPECT_EQ(tried.devices[2].reason, "the ESI assigns 2 bytes (PDO 0x1600, 0x1601) to SM0, which takes 1");
  EXPECT_EQ(tried.devices[3].outcome, TryOutcome::kPassed) << tried.devices[3].reason;
}

/// A table that is not whole is no "all passed".
TEST_F(EsiTry, EndedByASignalItSaysSo) {
  for (int i = 0; i < 4'000; ++i) write(fmt::format("{:04}.xml", i), esi(kRegisters));
  test::CliProcess lines({"esi", "try", folder_.string(), "--threads", "1", "--all"});
  ASSERT_TRUE(lines.wait_for_out("passed"));
  lines.signal(SIGTERM);
  EXPECT_EQ(lines.wait(), kAnswerIsNo);
  EXPECT_THAT(lines.out(), HasSubstr("0 failed; cancelled before all were tried"));
  test::CliProcess json({"esi", "try", folder_.string(), "--threads", "1", "--json"});
  while (!json.catches(SIGTERM)) std::this_thread::yield();
  json.signal(SIGTERM);
  EXPECT_EQ(json.wait(), kAnswerIsNo);
  EXPECT_EQ(nlohmann::json::parse(json.out())["cancelled"], true);
}

/// What a vendor's file says of its own SyncManager is not what the compiler can do: such a device fails, visibly.
TEST_F(EsiTry, FailuresAndUnreadableFilesAreTheAnswerNo) {
  std::string too_many = kRegisters;
  too_many.replace(too_many.find("<Fmmu Sm=\"1\">Inputs</Fmmu>"), 26, "");
  write("a.xml", esi(too_many));
  const auto run = test::cli_run({"esi", "try", folder_.string(), "--json"});
  EXPECT_EQ(run.code, kAnswerIsNo);
  const auto json = run.json();
  EXPECT_EQ(json["tried"], 1);
  EXPECT_EQ(json["failed"], 1);
  EXPECT_EQ(json["devices"][0]["step"], "compile");
  EXPECT_THAT(json["devices"][0]["reason"].get<std::string>(), HasSubstr("FMMU"));
  write("a.xml", esi(kRegisters));
  EXPECT_EQ(test::cli_run({"esi", "try", folder_.string()}).code, kDone);
  write("b.xml", "<EtherCATConfig/>");
  EXPECT_EQ(test::cli_run({"esi", "try", folder_.string()}).code, kAnswerIsNo);
  EXPECT_EQ(test::cli_run({"esi", "try", (folder_ / "absent").string()}).code, kFailed);
}

TEST(EsiTryOwnFiles, EachReachesOp) {
  const auto tried = try_esi({.path = test::source_dir() + "/resources/esi", .threads = 2}, eni::trial_files());
  ASSERT_TRUE(tried);
  EXPECT_GT(tried->devices.size(), 5U);
  for (const auto& device : tried->devices) {
    EXPECT_EQ(device.outcome, TryOutcome::kPassed) << device.file << ": " << device.reason;
  }
}

class EsiTrySamples : public testing::TestWithParam<test::SampleRoot> {};
INSTANTIATE_TEST_SUITE_P(Roots, EsiTrySamples, testing::ValuesIn(test::sample_roots()), test::SampleRootName());

/// Devices of several vendors; of those of others the sanitizers make do with a part.
TEST_P(EsiTrySamples, EveryDeviceReachesOpOrItsEsiContradictsItself) {
#if defined(SYNCLINE_SANITIZED)
  const unsigned every = GetParam().own ? 1 : 10;
#else
  const unsigned every = 1;
#endif
  const auto tried =
      try_esi({.path = (GetParam().folder / "esi").string(), .threads = 2, .every = every}, eni::trial_files());
  ASSERT_TRUE(tried);
  for (const auto& device : tried->devices) {
    EXPECT_NE(device.outcome, TryOutcome::kFailed)
        << device.file << ": " << device.type << " " << to_string(device.identity) << ": " << step_name(device.step)
        << ": " << device.reason;
  }
  std::cout << tried->devices.size() << " devices tried, " << tried->count(TryOutcome::kPassed) << " passed, "
            << tried->count(TryOutcome::kExcepted) << " excepted\n";
  EXPECT_TRUE(tried->unreadable.empty());
  // Whose ESI contradicts itself, each looked at by hand.
  const std::set<std::string> known =
      GetParam().own ? std::set<std::string>{"WK-78", "line 38"}
                     : std::set<std::string>{"CX2040 EtherCAT slave", "AX2000-B120", "kickcat_esi_test_sm_fmmu",
                                             "B090.SO.3.0",           "B090.SO.3.1", "line 55388"};  // an EL2252
  std::size_t passive = 0;  // end caps, supplies and the like, without a product code
  for (const auto& device : tried->devices) {
    if (device.outcome == TryOutcome::kExcepted && device.identity.product_code == 0 && device.line == 0) {
      EXPECT_THAT(device.reason, HasSubstr("no EtherCAT slave controller")) << device.type;
      ++passive;
    } else if (device.outcome == TryOutcome::kExcepted) {
      const auto name = device.type.empty() ? fmt::format("line {}", device.line) : device.type;
      EXPECT_TRUE(known.contains(name)) << device.file << ": " << device.type << ": " << device.reason;
    }
  }
  EXPECT_LE(passive, GetParam().own ? 1U : 29U);
  EXPECT_LE(tried->count(TryOutcome::kExcepted) - passive, known.size());
}

}  // namespace
}  // namespace syncline::cli
