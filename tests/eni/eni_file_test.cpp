// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>
#include <fstream>

#include "compare/network_compare.h"
#include "compile/compile.h"
#include "findings/error_text.h"
#include "support/sample_folder.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

using testing::HasSubstr;
using testing::Not;

NetworkConfig compiled(const Project& project, EniDialect dialect = EniDialect::kEcEngineer) {
  return compile(project, {dialect}).value().config;
}

/// A machine that uses everything an ENI can hold.
Project full_machine() {
  Project project = sample::project(
      {sample::coupler(), sample::digital_input(), sample::digital_output(), sample::servo(), sample::servo()});
  project.master.name = "Line 3 <press> & \"feeder\"";
  project.master.source_mac = {0x02, 0x00, 0x5E, 0x10, 0x20, 0x30};
  project.master.dc.sync_window.enabled = true;
  auto& servo = project.slaves[4];
  servo.name =
      "Vorsch\xC3\xBC"
      "be";
  servo.alias = 77;
  servo.hot_connect = "Trolley";
  servo.previous = PreviousPort{0, 2};
  servo.device.identity.vendor_id = 0x80000001;
  servo.device.identity.product_code = 0xFFFFFFFF;
  servo.device.fmmus.push_back(FmmuUse::kMailboxState);
  servo.device.mailbox->eoe = servo.device.mailbox->data_link_layer = true;
  servo.device.timeouts = {3500, 9000, 4500, 250};
  servo.startup[0].enabled = false;
  servo.check.revision = true;
  servo.dc.sync0.shift = -125'000;
  servo.dc.potential_reference_clock = true;
  return project;
}

/// Parts of the run-time DC settings that no ENI holds, set to what a reader assumes.
NetworkConfig without_run_time_numbers(NetworkConfig config) {
  DcMasterSettings dc;
  dc.enabled = config.dc.enabled;
  dc.reference_clock = config.dc.reference_clock;
  dc.show_64bit_system_time = config.dc.show_64bit_system_time;
  dc.sync_window.enabled = config.dc.sync_window.enabled;
  dc.dcm.mode = config.dc.dcm.mode;
  config.dc = dc;
  for (auto& slave : config.slaves) {
    if (slave.mailbox) slave.mailbox->timeouts = {};
  }
  return config;
}

TEST(EniFile, ReadsWhatItWrote) {
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    const NetworkConfig config = compiled(full_machine(), dialect);
    const auto read = parse_eni(write_eni(config), "memory");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(write_eni(*read), write_eni(config));
    EXPECT_EQ(*read, without_run_time_numbers(config));
  }
}

TEST(EniFile, ReadsEveryDcModeBack) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift}) {
    for (const bool window : {false, true}) {
      for (const bool wide : {false, true}) {
        Project project = sample::small_machine();
        project.master.dc.dcm.mode = mode;
        project.master.dc.sync_window.enabled = window;
        project.master.dc.show_64bit_system_time = wide;
        const auto read = parse_eni(write_eni(compiled(project)), "memory");
        ASSERT_TRUE(read);
        EXPECT_TRUE(read->dc.enabled);
        EXPECT_EQ(read->dc.dcm.mode, mode);
        EXPECT_EQ(read->dc.sync_window.enabled, window);
        EXPECT_EQ(read->dc.show_64bit_system_time, wide);
        EXPECT_EQ(read->dc.reference_clock, 3);
        EXPECT_EQ(read->reference_clock(), 3);
      }
    }
  }
  const auto without = parse_eni(write_eni(compiled(sample::project({sample::coupler()}))), "memory");
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->dc.enabled);
  EXPECT_EQ(without->dc.dcm.mode, DcmMode::kOff);
}

TEST(EniFile, WritesTheSameBytesForTheSameProject) {
  EXPECT_EQ(write_eni(compiled(full_machine())), write_eni(compiled(full_machine())));
}

TEST(EniFile, DoesNotDependOnTheLocale) {
  const std::string plain = write_eni(compiled(full_machine()));
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool changed = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const std::string german = write_eni(compiled(full_machine()));
  const auto read = parse_eni(german, "memory");
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(german, plain);
  EXPECT_TRUE(read);
  if (!changed) GTEST_SKIP() << "no German locale here";
}

TEST(EniFile, WritesLargeIdentitiesAsNegativeNumbers) {
  const std::string text = write_eni(compiled(full_machine()));
  EXPECT_THAT(text, HasSubstr("<VendorId>-2147483647</VendorId>"));
  EXPECT_THAT(text, HasSubstr("<ProductCode>-1</ProductCode>"));
}

TEST(EniFile, EscapesNames) {
  const std::string text = write_eni(compiled(full_machine()));
  EXPECT_THAT(text, HasSubstr("Line 3 &lt;press&gt; &amp; \"feeder\""));
  EXPECT_THAT(text, HasSubstr("Vorsch\xC3\xBC"
                              "be"));
}

TEST(EniFile, RoundsACycleToWholeMicroseconds) {
  Project project = sample::small_machine();
  project.master.cycle_time = 62'500;
  EXPECT_THAT(write_eni(compiled(project)), HasSubstr("<CycleTime>63</CycleTime>"));
}

/// A folder of its own, gone after the test.
class EniFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("syncline-eni-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  std::filesystem::path folder_;
};

TEST_F(EniFolder, SavesAndLoads) {
  const NetworkConfig config = compiled(full_machine());
  ASSERT_TRUE(save_eni(config, path("a.xml")));
  ASSERT_TRUE(save_eni(config, path("a.xml")));
  EXPECT_EQ(files(), 1U);
  const auto read = read_eni(path("a.xml"));
  ASSERT_TRUE(read);
  EXPECT_EQ(write_eni(*read), write_eni(config));
}

TEST_F(EniFolder, LeavesNothingBehindWhenItCannotWrite) {
  std::filesystem::create_directory(folder_ / "a.xml");
  const auto status = save_eni(compiled(full_machine()), path("a.xml"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(files(), 1U);
  EXPECT_EQ(save_eni(compiled(full_machine()), path("missing/a.xml")).error().code, ErrorCode::kFileNotWritable);
  EXPECT_EQ(read_eni(path("missing.xml")).error().code, ErrorCode::kFileNotFound);
  EXPECT_EQ(read_eni(folder_.string()).error().code, ErrorCode::kFileNotReadable);
}

struct BadFile {
  const char* name;
  const char* text;
  ErrorCode code;
  int line;
  const char* subject;
};

class BadEni : public testing::TestWithParam<BadFile> {};

TEST_P(BadEni, IsRefusedWithFileLineAndElement) {
  const auto read = parse_eni(GetParam().text, "x.xml");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, GetParam().code);
  EXPECT_EQ(read.error().file, "x.xml");
  EXPECT_EQ(read.error().line, GetParam().line);
  EXPECT_EQ(read.error().subject, GetParam().subject);
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadEni,
    testing::Values(
        BadFile{"NotXml", "hello", ErrorCode::kXmlMalformed, 1, ""},
        BadFile{"OtherRoot", "<Network/>", ErrorCode::kNotThatKindOfFile, 0, ""},
        BadFile{"NoConfig", "<EtherCATConfig>\n</EtherCATConfig>", ErrorCode::kXmlMissingElement, 1, "Config"},
        BadFile{"NoMaster", "<EtherCATConfig>\n<Config/></EtherCATConfig>", ErrorCode::kXmlMissingElement, 2, "Master"},
        BadFile{"NoInfo", "<EtherCATConfig><Config><Master/>\n<Slave/></Config></EtherCATConfig>",
                ErrorCode::kXmlMissingElement, 2, "Info"},
        BadFile{"BadNumber",
                "<EtherCATConfig><Config><Master/>\n<Slave><Info>\n<PhysAddr>many</PhysAddr></Info></Slave>"
                "</Config></EtherCATConfig>",
                ErrorCode::kXmlBadValue, 3, "PhysAddr"},
        BadFile{"NumberTooLarge",
                "<EtherCATConfig><Config><Master/><Slave><Info>\n\n<PhysAddr>65536</PhysAddr></Info></Slave>"
                "</Config></EtherCATConfig>",
                ErrorCode::kXmlBadValue, 3, "PhysAddr"},
        BadFile{"OddData",
                "<EtherCATConfig><Config><Master><InitCmds><InitCmd><Cmd>7</Cmd>\n<Data>123</Data></InitCmd></InitCmds>"
                "</Master></Config></EtherCATConfig>",
                ErrorCode::kXmlBadValue, 2, "Data"},
        BadFile{"UnknownCommand",
                "<EtherCATConfig><Config><Master><InitCmds><InitCmd>\n<Cmd>15</Cmd></InitCmd></InitCmds>"
                "</Master></Config></EtherCATConfig>",
                ErrorCode::kXmlBadValue, 2, "Cmd"},
        BadFile{"UnknownTransition",
                "<EtherCATConfig><Config><Master><InitCmds><InitCmd>\n<Transition>XY</Transition><Cmd>1</Cmd></InitCmd>"
                "</InitCmds></Master></Config></EtherCATConfig>",
                ErrorCode::kXmlBadValue, 2, "Transition"},
        BadFile{"ShortMac",
                "<EtherCATConfig><Config><Master><Info>\n<Destination>0102</Destination></Info></Master></Config>"
                "</EtherCATConfig>",
                ErrorCode::kXmlBadValue, 2, "Destination"},
        BadFile{"Encrypted",
                "<EncryptedEtherCATConfig EncryptionVersion=\"1\"><Manufacturer Signature=\"#x1\">A</Manufacturer>"
                "<Data>00ff</Data></EncryptedEtherCATConfig>",
                ErrorCode::kNotThatKindOfFile, 0, ""},
        BadFile{"OtherValidation",
                "<EtherCATConfig><Config><Master><InitCmds><InitCmd><Cmd>1</Cmd>\n<Validate Type=\"OFTEN\"/></InitCmd>"
                "</InitCmds></Master></Config></EtherCATConfig>",
                ErrorCode::kXmlBadValue, 2, "Validate"}),
    [](const auto& test) { return test.param.name; });

TEST(EniFile, ReadsLatin1AsToolsWriteIt) {
  const auto read = parse_eni(
      "<?xml version=\"1.0\" "
      "encoding=\"iso-8859-1\"?><EtherCATConfig><Config><Master><Info><Name>K\xFChler</Name></Info>"
      "</Master></Config></EtherCATConfig>",
      "memory");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->master.name, "K\xC3\xBChler");
}

TEST(EniFile, ReadsTheSync0CycleWhereAToolWritesNoCycleTime) {
  std::string text = write_eni(compiled(sample::small_machine()));
  text.replace(text.find("<CycleTime>1000</CycleTime>"), 27, "");
  for (std::size_t at; (at = text.find("<CycleTime0>1000000<")) != std::string::npos;)
    text.replace(at, 20, "<CycleTime0>4000000<");
  const auto read = parse_eni(text, "memory");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->cycle_time(), 4 * kMillisecond);
}

/// Stored files: ours, and exports of the field as far as the folder of samples is at hand.
class FieldEni : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(FieldEni, IsReadAndWrittenWithoutLoss) {
  const auto first = read_eni(GetParam().string());
  if (!first) {
    EXPECT_EQ(first.error().code, ErrorCode::kNotThatKindOfFile) << describe(first.error());
    return;
  }
  const auto second = parse_eni(write_eni(*first), "memory");
  ASSERT_TRUE(second) << describe(second.error());
  EXPECT_TRUE(compare_networks(*first, *second, {.image_offsets = true}).empty());
  EXPECT_TRUE(*second == *first);
}

INSTANTIATE_TEST_SUITE_P(Files, FieldEni, testing::ValuesIn(test::all_samples("eni", ".xml")), [](const auto& test) {
  std::string name = test.param.stem().string();
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
});

TEST(EniFile, SaysHowTheImageOfOurSamplesIsCounted) {
  const auto read = [](const char* name) { return read_eni((test::own_samples("eni") / name).string()); };
  EXPECT_EQ(read("row.eni.xml")->image.command_data_offset, 10U);
  EXPECT_EQ(read("drives.eni.xml")->image.command_data_offset, 0U);
  EXPECT_EQ(read("drives.eni.xml")->dc.dcm.mode, DcmMode::kBusShift);
  EXPECT_TRUE(read("drives.eni.xml")->dc.sync_window.enabled);
  EXPECT_EQ(read("one_line.eni.xml")->cycle_time(), 2 * kMillisecond);
}

struct ThreeExports {
  bool own = true;
  std::string twincat, acontis, late_reference;
};
void PrintTo(const ThreeExports& exports, std::ostream* out) { *out << exports.late_reference; }

class ImageOf : public testing::TestWithParam<ThreeExports> {};
INSTANTIATE_TEST_SUITE_P(Exports, ImageOf,
                         testing::ValuesIn(test::with_others<ThreeExports>(
                             {{true, "eni/terminals.eni.xml", "eni/axis.eni.xml", "eni/sensor_and_axes.eni.xml"}},
                             {{false, "eni/kj4tmp__pyecm__basic.xml", "eni/magnate3__rocos-ethercat__eni.xml",
                               "eni/kpierczy__ethercat-lib__test_eni.xml"}})));

TEST_P(ImageOf, ExportsIsCountedAsTheFileSays) {
  const auto read = [](const std::string& file) { return read_eni(test::sample_path(GetParam().own, file)); };
  EXPECT_EQ(read(GetParam().twincat)->image.command_data_offset, 10U);
  EXPECT_EQ(read(GetParam().acontis)->image.command_data_offset, 0U);
  EXPECT_EQ(read(GetParam().acontis)->dc.dcm.mode, DcmMode::kBusShift);
  const auto network = read(GetParam().late_reference);
  EXPECT_EQ(network->image.command_data_offset, 10U);
  EXPECT_EQ(network->dc.reference_clock, 1);
  EXPECT_EQ(network->dc.dcm.mode, DcmMode::kMasterShift);
  EXPECT_EQ(network->cycle_time(), 10 * kMillisecond);
}

TEST(EniFile, ADifferentFormatIsNamedAsSuch) {
  std::vector<std::string> files{(test::own_samples("eni") / "another_format.xml").string()};
  if (const auto theirs = test::sample_file("eni/robotcontrol-xyz__openethercat__beckhoff_demo.eni.xml")) {
    files.push_back(*theirs);
  }
  for (const auto& file : files) {
    const auto read = read_eni(file);
    ASSERT_FALSE(read) << file;
    EXPECT_EQ(read.error().code, ErrorCode::kNotThatKindOfFile) << file;
  }
}

}  // namespace
}  // namespace syncline::eni
