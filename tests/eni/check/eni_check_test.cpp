// SPDX-License-Identifier: Apache-2.0
#include "eni/check/eni_check.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "check/check_network.h"
#include "config/hot_connect.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "eni/check/check_bed.h"
#include "eni/check/rule_cases.h"
#include "eni/format/eni_element.h"
#include "eni/xml/xml_reader.h"
#include "findings/finding_list.h"
#include "protocol/command.h"
#include "support/sample_folder.h"
#include "tests/support/source_dir.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<RuleCase> all_cases() {
  std::vector<RuleCase> all;
  for (const auto& part : {slave_cases(), command_cases(), clock_cases(), image_cases(), device_cases()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

TEST(EniCheck, AMachineOfOursIsWithoutFinding) {
  EXPECT_THAT(codes(eni::write_eni(checked_machine())), IsEmpty());
  EXPECT_THAT(codes(eni::write_eni(checked_machine(EniDialect::kTwinCat))), testing::ElementsAre("ENI-DIA-02"));
}

/// All that a project can ask of a slave's identity: what we write for it is without finding.
TEST(EniCheck, AMachineOfOursWhoseDeviceIdsAndAliasesAreCheckedIsWithoutFinding) {
  Project project = sample::project({sample::coupler(), sample::servo(), sample::servo()});
  project.slaves[1].check.device_id = 5;
  project.slaves[2].alias = 6;
  project.slaves[2].check.alias = true;
  EXPECT_THAT(codes(eni::write_eni(compile(project)->config)), IsEmpty());
}

TEST(EniCheck, WhatIsWrongInAnExportIsItsErrorsWithTheirSettings) {
  NetworkConfig config = checked_machine();
  EXPECT_THAT(eni::errors_of_export(eni::write_eni(config)), IsEmpty());
  config.slaves[kDrive].dc->shift_time = 2'147'483'648;
  EXPECT_EQ(eni::errors_of_export(eni::write_eni(config)).front().code, "ENI-XML-05");
  config = checked_machine();
  config.slaves[kLastDrive].hot_connect = HotConnectConfig{"A", 9, {}};
  const auto others = eni::errors_of_export(eni::write_eni(config));
  ASSERT_FALSE(others.empty());
  for (const auto& error : others) EXPECT_EQ(error.severity, Severity::kError);
  const auto group = std::ranges::find(others, "ENI-HC-01", &Finding::code);
  ASSERT_NE(group, others.end());
  EXPECT_EQ(group->place.key, "slave.4.hot_connect");
}

TEST(EniCheck, EachRuleFindsWhatItIsForAndNothingElse) {
  for (const RuleCase& rule : all_cases()) {
    NetworkConfig config = checked_machine(rule.twincat ? EniDialect::kTwinCat : EniDialect::kEcEngineer);
    rule.break_it(config);
    auto expected = rule.companions;
    expected.insert(rule.code);
    EXPECT_EQ(codes(eni::write_eni(config)), expected) << rule.code;
  }
}

TEST(EniCheck, EachRuleOfTheStructureFindsWhatItIsForAndNothingElse) {
  const std::string good = eni::write_eni(checked_machine());
  for (const TextCase& rule : text_cases()) {
    EXPECT_EQ(codes(rule.break_it(good)), std::set<std::string>{rule.code}) << rule.code;
  }
}

/// One wrong digit in a command makes one that nobody can carry out, or that asks for something else.
TEST(EniCheck, CommandsWithoutSenseAreFound) {
  const auto code_of = [](auto&& change) {
    NetworkConfig config = checked_machine();
    change(config);
    return codes(eni::write_eni(config));
  };
  using testing::Contains;
  const auto al_status = [](NetworkConfig& c) -> InitCmd& {
    return command(c, kInput, Transition::kPS, reg::kAlStatus, false);
  };
  EXPECT_THAT(code_of([&](NetworkConfig& c) { al_status(c).command = Command::kFpwr; }), Contains("ENI-ORD-10"));
  EXPECT_THAT(code_of([&](NetworkConfig& c) {
                c.slaves[kInput].init_cmds.push_back(write(c.slaves[kInput], Transition::kIP, reg::kAlStatus, {1, 0}));
              }),
              Contains("ENI-ORD-10"));
  EXPECT_THAT(
      code_of([](NetworkConfig& c) { command(c, kInput, Transition::kPS, reg::kAlControl).command = Command::kLrd; }),
      Contains("ENI-ORD-10"));
  // 0x0108 instead of 0x0008.
  EXPECT_THAT(code_of([](NetworkConfig& c) {
                for (InitCmd& cmd : c.slaves[kInput].init_cmds) {
                  if (cmd.ado == reg::kSiiControl && cmd.data.size() > 3 && cmd.data[2] == 8) cmd.data[3] = 1;
                }
              }),
              Contains("ENI-REF-10"));
}

/// A million elements with the same mistake are one mistake; a finding each would take gigabytes.
TEST(EniCheck, OfTooManyFindingsTheRestIsCounted) {
  constexpr std::size_t kMore = 500;
  std::string many;
  for (std::size_t i = 0; i < FindingList::kMostOfRule + kMore; ++i) many += "<SerialNo>0</SerialNo>";
  const auto text = replaced(eni::write_eni(checked_machine()), "<SerialNo>0</SerialNo>", many);
  const auto check = eni::check_eni_text(text, "test.xml");
  ASSERT_TRUE(check);
  // The first of them is right.
  ASSERT_EQ(check->findings.size(), FindingList::kMostOfRule + 1);
  EXPECT_EQ(check->findings.back().code, FindingList::kRest);
  EXPECT_EQ(check->findings.back().severity, Severity::kError);
  EXPECT_EQ(facts_text(check->findings.back()), "499 findings more are not listed");
  EXPECT_EQ(check->not_listed[Severity::kError], kMore - 1);
  EXPECT_EQ(check->count(Severity::kError), FindingList::kMostOfRule + kMore - 1);
  EXPECT_EQ(check->count(Severity::kNote), 0U);
}

/// Kinds of extensions are listed once each, and there may be as many as there are elements.
TEST(EniCheck, OfTooManyKindsOfExtensionsTheRestIsCounted) {
  std::string many;
  for (std::size_t i = 0; i < FindingList::kMostOfRule + 7; ++i) many += fmt::format("<Own{}>0</Own{}>", i, i);
  const auto text =
      replaced(eni::write_eni(checked_machine()), "<VendorId>1516</VendorId>", "<VendorId>1516</VendorId>" + many);
  const auto check = eni::check_eni_text(text, "test.xml");
  ASSERT_TRUE(check);
  EXPECT_EQ(check->findings.size(), FindingList::kMostOfRule + 1);
  EXPECT_EQ(check->count(Severity::kNote), FindingList::kMostOfRule + 7);
  const auto imported = eni::import_eni_text(text, "test.xml");
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->unread.size(), FindingList::kMostOfRule + 1);
  EXPECT_EQ(facts_text(imported->unread.back()), "7 findings more are not listed");
}

TEST(EniCheck, AnImportSaysTooThatTheTextIsNotInItsEncoding) {
  const auto text = replaced(eni::write_eni(checked_machine()), "<EtherCATConfig ", "<!-- \x8D -->\n<EtherCATConfig ");
  const auto imported = eni::import_eni_text(text, "test.xml");
  ASSERT_TRUE(imported);
  ASSERT_EQ(imported->unread.size(), 1U);
  EXPECT_EQ(imported->unread[0].code, "ENI-XML-11");
  EXPECT_EQ(imported->unread[0].place.line, 1);
}

/// What was read behind a value that cannot be is thrown away: it would cost hundreds of bytes for each element.
TEST(EniCheck, BehindTheFirstErrorNothingIsRead) {
  eni::Reading reading("x.xml");
  const auto document = eni::parse_xml("<Frame><Cmd/><Cmd/><Cmd/></Frame>", "x.xml");
  ASSERT_TRUE(document);
  const eni::EniElement frame(eni::Node((*document)->RootElement(), reading));
  EXPECT_EQ(frame.children("Cmd").size(), 3U);
  std::size_t read = 0;
  for (const auto& cmd : frame.children("Cmd")) read += cmd.required("Cmd") ? 0 : 1;
  EXPECT_EQ(read, 1U);
}

TEST(EniCheck, EachRuleHasACaseAndTexts) {
  std::set<std::string> tested{std::string(FindingList::kRest)};  // OfTooManyFindingsTheRestIsCounted
  for (const RuleCase& rule : all_cases()) tested.insert(rule.code);
  for (const TextCase& rule : text_cases()) tested.insert(rule.code);
  std::set<std::string> rules;
  for (const FindingWords& rule : check_rules()) {
    EXPECT_TRUE(rules.emplace(rule.code).second) << rule.code;
    EXPECT_FALSE(rule.title.empty() || rule.why.empty() || rule.mend.empty()) << rule.code;
  }
  EXPECT_EQ(tested, rules);
}

TEST(EniCheck, TheManualHasEachRuleWithItsTexts) {
  std::ifstream in(test::source_dir() + "/docs/check.md");
  std::set<std::string> lines;
  std::size_t rows = 0;
  for (std::string line; std::getline(in, line);) {
    rows += line.starts_with("| ENI-") ? 1 : 0;
    lines.insert(line);
  }
  EXPECT_EQ(rows, check_rules().size());
  for (const FindingWords& rule : check_rules()) {
    const auto row = fmt::format("| {} | {} | {} | {} | {} |", rule.code, severity_name(rule.severity), rule.title,
                                 rule.why, rule.mend);
    EXPECT_TRUE(lines.contains(row)) << row;
  }
}

TEST(EniCheck, AFindingNamesLinePathAndSlave) {
  NetworkConfig config = checked_machine();
  command(config, kLastDrive, Transition::kPS, reg::sync_manager(2)).adp = 1001;
  const std::string text = eni::write_eni(config);
  const auto check = eni::check_eni_text(text, "test.xml");
  ASSERT_EQ(check->findings.size(), 1U);
  const Finding& finding = check->findings[0];
  EXPECT_EQ(finding.place.slave, 4);
  EXPECT_EQ(check->slave_name(finding), config.slaves[kLastDrive].name);
  const auto& commands = config.slaves[kLastDrive].init_cmds;
  const auto index = &command(config, kLastDrive, Transition::kPS, reg::sync_manager(2)) - commands.data() + 1;
  EXPECT_EQ(finding.place.path, "/EtherCATConfig/Config/Slave[5]/InitCmds/InitCmd[" + std::to_string(index) + "]");
  const auto lines = lines_of(text);
  ASSERT_GT(lines.size(), static_cast<std::size_t>(finding.place.line));
  EXPECT_THAT(lines[static_cast<std::size_t>(finding.place.line) - 1], HasSubstr("<InitCmd>"));
  // The command that begins on that line is the one with the wrong address.
  std::string command_text;
  for (auto i = static_cast<std::size_t>(finding.place.line); lines[i].find("</InitCmd>") == std::string::npos; ++i) {
    command_text += lines[i];
  }
  EXPECT_THAT(command_text, HasSubstr("<Adp>1001</Adp>"));
  EXPECT_THAT(command_text, HasSubstr("<Ado>2064</Ado>"));
}

/// Every kind of place: the line that it names begins the element that its path ends with.
TEST(EniCheck, LinesAndPathsAgree) {
  for (const RuleCase& rule : all_cases()) {
    NetworkConfig config = checked_machine(rule.twincat ? EniDialect::kTwinCat : EniDialect::kEcEngineer);
    rule.break_it(config);
    const std::string text = eni::write_eni(config);
    const auto lines = lines_of(text);
    const auto check = eni::check_eni_text(text, "test.xml");
    for (const auto& finding : check->findings) {
      ASSERT_GT(finding.place.line, 0) << finding.code;
      std::string element = finding.place.path.substr(finding.place.path.rfind('/') + 1);
      element = element.substr(0, element.find('['));
      EXPECT_THAT(lines[static_cast<std::size_t>(finding.place.line) - 1], HasSubstr("<" + element)) << finding.code;
    }
  }
}

/// Some tools write the end cap of a row of terminals as a Slave: nobody is there, and nobody is missed.
TEST(EniCheck, AnEndCapIsNoSlave) {
  const NetworkConfig config = checked_machine();
  const std::string cap =
      "<Slave><Info><Name>Term 6 "
      "(EL9011)</Name><VendorId>2</VendorId><ProductCode>0</ProductCode><RevisionNo>0</RevisionNo>"
      "<SerialNo>0</SerialNo></Info></Slave>";
  const std::string good = eni::write_eni(config);
  for (const std::string place : {"<Cyclic", "<Slave>"}) {  // behind all slaves, before the first
    const std::string text = replaced(good, place, cap + place);
    EXPECT_THAT(codes(text), IsEmpty()) << place;
    const auto read = eni::parse_eni(text, "cap.xml");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->slaves, config.slaves);
  }
  // Its place counts where a path is told.
  NetworkConfig bad = config;
  command(bad, kLastDrive, Transition::kPS, reg::sync_manager(2)).adp = 1001;
  const auto check = eni::check_eni_text(replaced(eni::write_eni(bad), "<Slave>", cap + "<Slave>"), "cap.xml");
  ASSERT_EQ(check->findings.size(), 1U);
  EXPECT_EQ(check->findings[0].place.slave, 4);
  EXPECT_THAT(check->findings[0].place.path, HasSubstr("/Slave[6]/"));
}

/// A file that its maker has signed is plain all the same: each FMMU that is damaged in it is told.
TEST(EniCheck, EachScrambledFmmuOfASignedFileIsTold) {
  NetworkConfig config = checked_machine();
  std::size_t scrambled = 0;
  for (SlaveConfig& slave : config.slaves) {
    for (InitCmd& cmd : slave.init_cmds) {
      const bool fmmu = has(cmd, Transition::kPS) && cmd.ado >= reg::kFmmu && cmd.ado < reg::kFmmu + 0x100;
      if (!fmmu || cmd.data.size() != Fmmu::kSize) continue;
      std::uint8_t key = 0x5A;
      for (std::uint8_t& byte : cmd.data)
        byte = static_cast<std::uint8_t>(byte ^ (key = static_cast<std::uint8_t>(key * 5 + 3)));
      ++scrambled;
    }
  }
  ASSERT_GE(scrambled, 5U);
  const std::string text = replaced(replaced(eni::write_eni(config), "<EtherCATConfig ", "<EncryptedEtherCATConfig "),
                                    "</EtherCATConfig>", "</EncryptedEtherCATConfig>");
  std::set<std::string> places;
  const auto check = eni::check_eni_text(text, "signed.xml");
  for (const auto& finding : check->findings) {
    if (std::string_view(finding.code).starts_with("ENI-FMMU-0") &&
        finding.place.path.find("/InitCmds/") != std::string::npos) {
      places.insert(finding.place.path);
    }
  }
  EXPECT_EQ(places.size(), scrambled);
}

TEST(EniCheck, BrokenXmlIsAFindingAndNoEniIsAnError) {
  const auto broken = eni::check_eni_text("<EtherCATConfig>\n<Config>", "broken.xml");
  ASSERT_TRUE(broken);
  EXPECT_FALSE(broken->understood);
  ASSERT_EQ(broken->findings.size(), 1U);
  EXPECT_EQ(broken->findings[0].code, "ENI-XML-01");
  EXPECT_EQ(eni::check_eni_text("<EtherCATInfo/>", "esi.xml").error().code, ErrorCode::kNotThatKindOfFile);
  EXPECT_EQ(eni::check_eni("there-is-no-such-file.xml").error().code, ErrorCode::kFileNotFound);
}

TEST(EniCheck, HostileNumbersAreFindingsToo) {
  NetworkConfig config = checked_machine();
  for (auto& variable : config.image.inputs) variable.bit_offset = variable.bit_size = UINT32_MAX;
  for (auto& slave : config.slaves) {
    slave.send = slave.receive = ImageRange{0x7FFF'FFFF, 0x7FFF'FFFF};
    if (slave.dc) *slave.dc = {true, true, INT32_MAX, INT32_MIN, INT32_MIN, 0};
    for (auto& cmd : slave.init_cmds) {
      if (cmd.ado >= reg::kFmmu && cmd.ado < 0x0900) std::ranges::fill(cmd.data, 0xFF);
    }
  }
  for (auto& cmd : frame(config)) {
    cmd.input_offset = cmd.output_offset = UINT32_MAX;
    cmd.logical_address = UINT32_MAX;
    cmd.copy_infos = {{UINT32_MAX, UINT32_MAX, UINT32_MAX}};
    cmd.data.clear();
    cmd.data_length = 0xFFFF;
  }
  config.cyclic.front().cycle_time = Nanoseconds{INT32_MAX} * kMicrosecond;
  const auto found = codes(eni::write_eni(config));
  for (const char* code : {"ENI-IMG-01", "ENI-IMG-04", "ENI-FMMU-01", "ENI-FRM-01", "ENI-TIME-05", "ENI-IMG-11"}) {
    EXPECT_TRUE(found.contains(code)) << code;
  }
}

TEST(EniCheck, RealExportsAreWithoutErrorAndWarning) {
  for (const char* name : {"row.eni.xml", "drives.eni.xml", "one_line.eni.xml"}) {
    const auto check = eni::check_eni((own_samples("eni") / name).string());
    ASSERT_TRUE(check) << name;
    for (const auto& finding : check->findings) {
      EXPECT_EQ(finding.severity, Severity::kNote) << name << ':' << finding.place.line << ' ' << facts_text(finding);
    }
  }
  const auto folder = sample_folder();
  if (!folder) return;  // those of other tools
  int checked = 0;
  for (const char* name :
       {"jasper-node__jn-ec-master__mega_master_eni.xml", "kj4tmp__pyecm__basic.xml", "kj4tmp__pyecm__empty.xml",
        "kpierczy__ethercat-lib__test_eni.xml", "magnate3__rocos-ethercat__bcr_eni.xml",
        "magnate3__rocos-ethercat__eni.xml", "magnate3__rocos-ethercat__eni4.xml"}) {
    const auto check = eni::check_eni((*folder / "eni" / name).string());
    if (!check) continue;
    ++checked;
    for (const auto& finding : check->findings) {
      EXPECT_EQ(finding.severity, Severity::kNote)
          << name << ':' << finding.place.line << ' ' << finding.code << ' ' << facts_text(finding);
    }
  }
  EXPECT_GE(checked, 7);
}

/// Hand-written files and one maker's dialect: what is wrong with them is found, with the line.
TEST(EniCheck, OddSamplesAreFoundOut) {
  const std::map<std::string, std::set<std::string>> expected = {
      {"fragment.eni.xml", {"ENI-XML-06", "ENI-COE-02", "ENI-STATE-05", "ENI-ORD-08"}},
      {"OpenEtherCATsociety__SOEM__sample-eni.xml",
       {"ENI-XML-02", "ENI-XML-03", "ENI-XML-04", "ENI-XML-06", "ENI-COE-02"}},
      {"jasper-node__jn-ec-master__coe_slave.eni.xml", {"ENI-XML-02", "ENI-REF-05"}},
      {"magnate3__rocos-ethercat__eni1.xml", {"ENI-XML-03", "ENI-XML-04", "ENI-DC-01", "ENI-COE-08"}},
  };
  for (const auto& [name, wanted] : expected) {
    const auto own = own_samples("eni") / name;
    const auto path = std::filesystem::exists(own) ? std::optional(own.string()) : sample_file("eni/" + name);
    if (!path) continue;  // of others, and not here
    std::set<std::string> found;
    const auto check = eni::check_eni(*path);
    ASSERT_TRUE(check) << name;
    for (const auto& finding : check->findings) {
      found.emplace(finding.code);
      EXPECT_GT(finding.place.line, 0);
    }
    EXPECT_THAT(wanted, testing::Each(testing::Truly([&](const std::string& code) { return found.contains(code); })))
        << name;
  }
}

TEST(EniCheck, GoldenExportsAreWithoutErrorAndWarning) {
  for (const char* name : {"small_machine.eni.xml", "small_machine_twincat.eni.xml"}) {
    const auto check = eni::check_eni(test::source_dir() + "/tests/golden/" + name);
    ASSERT_TRUE(check);
    for (const auto& finding : check->findings) {
      EXPECT_EQ(finding.severity, Severity::kNote) << name << ':' << finding.place.line << ' ' << facts_text(finding);
    }
  }
}

}  // namespace
}  // namespace syncline::test
