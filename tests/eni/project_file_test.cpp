// SPDX-License-Identifier: Apache-2.0
#include "eni/project/project_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>
#include <regex>

#include "eni/esi/esi_reader.h"
#include "eni/esi/esi_writer.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "findings/finding.h"
#include "support/random_project.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

using ::testing::HasSubstr;

TEST(ProjectFile, ComesBackEqualAndWithTheSameBytes) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const Project project = test::RandomProject(seed).project();
    const auto text = write_project(project);
    const auto read = parse_project(text, "p.syncline");
    if (!read) RC_FAIL(describe(read.error()));
    RC_ASSERT(*read == project);
    RC_ASSERT(write_project(*read) == text);
  }));
}

TEST(ProjectFile, RandomDevicesComeBackFromEsi) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const auto device = test::RandomProject(seed).device();
    const auto read = parse_esi(write_esi(device), device.source);
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->warnings.empty());
    RC_ASSERT(read->devices.size() == 1U);
    // The vendor's name stands in an element that ESI readers trim.
    auto expected = device;
    expected.vendor_name = trim(device.vendor_name);
    RC_ASSERT(read->devices.front() == expected);
  }));
}

Project three_slaves() {
  Project project;
  test::RandomProject random(11);
  const auto one = random.device(), other = random.device();
  project.slaves = {default_slave(one, 0), default_slave(other, 1), default_slave(one, 2)};
  return project;
}

/// Files from before these lists existed say nothing of them: what the ESI sends is sent as it was.
TEST(ProjectFile, MessagesThatAFileDoesNotSpeakOfAreTheEsis) {
  Project project;
  auto device = sample::servo();
  device.mailbox->aoe = true;
  device.mailbox->aoe_options.init_commands = {{{Transition::kPS}, 0, {1, 2}, "of the ESI"}};
  project.slaves = {default_slave(device, 0)};
  ASSERT_EQ(project.slaves[0].aoe_startup.size(), 1U);
  const auto text = write_project(project);
  EXPECT_EQ(text.find("AoEStartup"), std::string::npos);
  EXPECT_EQ(parse_project(text, "p.syncline")->slaves[0].aoe_startup, project.slaves[0].aoe_startup);
  project.slaves[0].aoe_startup.clear();
  EXPECT_TRUE(parse_project(write_project(project), "p.syncline")->slaves[0].aoe_startup.empty());
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(ProjectFile, CarriesEachDeviceOnce) {
  const auto text = write_project(three_slaves());
  EXPECT_EQ(count(text, "<DeviceDescription "), 2U);
  EXPECT_EQ(count(text, "<Slave "), 3U);
}

TEST(ProjectFile, SavesAndLoads) {
  const auto path =
      (std::filesystem::temp_directory_path() / ("syncline-project-" + std::to_string(::getpid()))).string();
  const Project project = three_slaves();
  ASSERT_TRUE(save_project(project, path));
  const auto loaded = load_project(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(loaded) << describe(loaded.error());
  EXPECT_EQ(*loaded, project);
  EXPECT_EQ(load_project(path).error().code, ErrorCode::kFileNotFound);
}

/// Programs that know no views read such files as ever: they are elements beside Master and Slaves.
TEST(ProjectFile, KeepsViewsBesideTheMachine) {
  auto project = three_slaves();
  const auto without = write_project(project);
  project.views = {{"Cabinet 1",
                    {{"",
                      {{ViewSignal::Of::kSlave, "port1_lost_links", 1002, false, true, true}},
                      ValueScale::kSignedLog,
                      AxisLimits{-0.5, 2.25},
                      {},
                      true,
                      250}}}};
  const auto text = write_project(project);
  EXPECT_THAT(text, HasSubstr("Left=\"-0.5 2.25\"")) << "whatever the locale";
  const auto views = text.find("<Views>");
  ASSERT_NE(views, std::string::npos);
  const auto end = text.find("</Views>") + std::string_view("</Views>").size();
  auto rest = text.substr(0, text.find_last_not_of(" \n", views - 1) + 1) + text.substr(end);
  EXPECT_EQ(rest, without) << "nothing else changes";
  const auto read = parse_project(text, "p.syncline");
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->views, project.views);
}

TEST(ProjectFile, RefusesViewsThatSayNothing) {
  auto project = three_slaves();
  project.views = {{"V", {{"", {{ViewSignal::Of::kBus, "drift_ppm"}}, ValueScale::kLog, AxisLimits{1, 2}, {}}}}};
  const auto text = write_project(project);
  const auto refused = [&](const std::string& good, const std::string& bad) {
    const auto read = parse_project(std::regex_replace(text, std::regex(good), bad), "p.syncline");
    return read ? std::string() : describe(read.error());
  };
  EXPECT_THAT(refused("Scale=\"log\"", "Scale=\"cubic\""), HasSubstr("is no scale"));
  EXPECT_THAT(refused("Left=\"1 2\"", "Left=\"2 1\""), HasSubstr("is no pair of limits"));
  EXPECT_THAT(refused("Left=\"1 2\"", "Left=\"1 nan\""), HasSubstr("is no pair of limits"));
  EXPECT_THAT(refused("Left=\"1 2\"", "Left=\"1,5 2\""), HasSubstr("is no pair of limits"));
  EXPECT_THAT(refused("Of=\"bus\"", "Of=\"planet\""), HasSubstr("is nothing that has signals"));
  EXPECT_EQ(refused("Key=\"drift_ppm\"", "Key=\"tomorrow\""), "") << "a newer program's signal stays in its place";
}

TEST(ProjectFile, AbsentFieldsKeepTheirDefaults) {
  const auto project =
      parse_project("<SynclineProject Version=\"1\"><Master/><Slaves/></SynclineProject>", "p.syncline");
  ASSERT_TRUE(project);
  EXPECT_EQ(*project, Project{});
}

struct Spoilt {
  const char* from;
  const char* to;
  ErrorCode code;
  const char* element;
};

TEST(ProjectFile, DamageIsNamedWithLineAndElement) {
  const auto text = write_project(three_slaves());
  const Spoilt cases[] = {
      {"<Master ", "<Mister ", ErrorCode::kXmlMalformed, ""},
      {"CycleTimeNs=\"1000000\"", "CycleTimeNs=\"soon\"", ErrorCode::kXmlBadValue, "Master@CycleTimeNs"},
      {"Mode=\"bus-shift\"", "Mode=\"sideways\"", ErrorCode::kXmlBadValue, "Dcm"},
      {"DestinationMac=\"ff", "DestinationMac=\"f", ErrorCode::kXmlBadValue, "Master"},
      {"<Slave Device=\"2\"", "<Slave Device=\"9\"", ErrorCode::kXmlBadValue, "Slave"},
      {"<Slaves>", "<Slaves Version=\"1\"><Slave Device=\"1\"><RxPdos>what</RxPdos></Slave>", ErrorCode::kXmlBadValue,
       "RxPdos"},
      {"<ByteSize>", "<ByteSize>x", ErrorCode::kXmlBadValue, "ByteSize"},
      {"SynclineProject Version=\"1\"", "SynclineProject Version=\"3\"", ErrorCode::kNotThatKindOfFile,
       "SynclineProject"},
  };
  for (const auto& damage : cases) {
    auto spoilt = text;
    const auto at = spoilt.find(damage.from);
    ASSERT_NE(at, std::string::npos) << damage.from;
    spoilt.replace(at, std::string(damage.from).size(), damage.to);
    const auto project = parse_project(spoilt, "p.syncline");
    ASSERT_FALSE(project) << damage.to;
    EXPECT_EQ(project.error().code, damage.code) << damage.to << ": " << describe(project.error());
    EXPECT_EQ(project.error().file, "p.syncline");
    EXPECT_GT(project.error().line, 0) << damage.to;
    EXPECT_THAT(project.error().subject, HasSubstr(damage.element));
  }
  EXPECT_EQ(parse_project("<EtherCATInfo/>", "p").error().code, ErrorCode::kNotThatKindOfFile);
  EXPECT_EQ(parse_project("<SynclineProject><Slaves/></SynclineProject>", "p").error().subject, "Master");
}

TEST(ProjectFile, KeepsSynchronisationSettingsAndNamesThoseThatTheDeviceDoesNotTake) {
  auto drive = sample::servo();
  drive.identity.vendor_id = 0xAB;  // Copley
  auto gateway = sample::servo();
  gateway.identity.vendor_id = 0x2;
  gateway.identity.product_code = 0x1A5F'3052;  // EL6751
  Project project = sample::project({drive, gateway});
  project.slaves[0].sync = {12, SyncTypeChoice::kSync0, 62'500};
  project.slaves[0].output_pins = {{1, 11}, {3, 0x200}};
  project.slaves[1].can = {4 * kMillisecond, 10};
  const auto text = write_project(project);
  const auto read = parse_project(text, "p.syncline");
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(*read, project);
  const std::pair<std::string, std::string> cases[] = {
      {"Type=\"sync0\"", "Type=\"sync1\""},
      {"Number=\"3\"", "Number=\"9\""},
      {"TxDelayPercent=\"10\"", "TxDelayPercent=\"110\""},
  };
  const char* keys[] = {"slave.0.sync.type", "slave.0.output_pin.9", "slave.1.can.tx_delay_percent"};
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    auto spoilt = text;
    spoilt.replace(spoilt.find(cases[i].first), cases[i].first.size(), cases[i].second);
    const auto refused = parse_project(spoilt, "p.syncline");
    ASSERT_FALSE(refused) << keys[i];
    EXPECT_THAT(refused.error().detail.text(), HasSubstr(keys[i]));
    EXPECT_EQ(refused.error().file, "p.syncline");
    EXPECT_GT(refused.error().line, 1);
  }
}

}  // namespace
}  // namespace syncline::eni
