// SPDX-License-Identifier: Apache-2.0
// What we write against the published schema, with xmllint, and against a file that was reviewed by hand.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "eni/format/eni_style.h"
#include "eni/schema_check.h"
#include "tests/support/sample_devices.h"
#include "tests/support/source_dir.h"

namespace syncline::eni {
namespace {

class EniSchema : public testing::TestWithParam<Schema> {};
INSTANTIATE_TEST_SUITE_P(Schemas, EniSchema, testing::ValuesIn(eni_schemas()), SchemaName());

TEST_P(EniSchema, AcceptsWhatWeWrite) {
  const auto& schema = GetParam().path;
  if (!have_xmllint()) GTEST_SKIP() << "xmllint is not installed";
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    Project project = sample::small_machine();
    expect_valid(write_eni(compile(project, {dialect}).value().config, style_of(dialect)), schema);
    project.master.dc.sync_window.enabled = true;
    project.slaves.push_back(sample::slave(sample::servo(), 4));
    auto& servo = project.slaves[4];
    servo.alias = 5;
    servo.device.identity = {0x80000000, 0xFFFFFFFF, 0x90000000, 0xFFFFFFFE};
    servo.device.fmmus.push_back(FmmuUse::kMailboxState);
    servo.device.mailbox->data_link_layer = servo.device.mailbox->eoe = true;
    servo.previous = PreviousPort{0, 3};
    servo.name = "<&>\"'";
    servo.startup[0].enabled = false;
    servo.startup[0].data.clear();
    expect_valid(write_eni(compile(project, {dialect}).value().config, style_of(dialect)), schema);
  }
}

TEST_P(EniSchema, AcceptsStoredFilesAsWeWriteThemBack) {
  if (!have_xmllint()) GTEST_SKIP() << "xmllint is not installed";
  int files = 0;
  for (const auto& root : test::sample_roots()) {
    // What only others write, the published schema alone knows.
    if (GetParam().own && !root.own) continue;
    for (const auto& entry : std::filesystem::directory_iterator(root.folder / "eni")) {
      const auto config =
          entry.path().extension() == ".xml" ? read_eni(entry.path().string()) : Result<NetworkConfig>{};
      // Fragments lack what the schema demands, and stay fragments.
      if (!config || config->cyclic.empty()) continue;
      SCOPED_TRACE(entry.path());
      for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
        expect_valid(write_eni(*config, style_of(dialect)), GetParam().path);
      }
      ++files;
    }
  }
  EXPECT_GE(files, GetParam().own ? 7 : 14) << "of the samples that are at hand";
}

/// A schema that takes everything would prove nothing.
TEST_P(EniSchema, RefusesWhatIsMissingMisplacedOrNoNumber) {
  if (!have_xmllint()) GTEST_SKIP() << "xmllint is not installed";
  const auto good = write_eni(compile(sample::small_machine()).value().config);
  ASSERT_EQ(schema_says(good, GetParam().path), "");
  const std::pair<const char*, const char*> damages[] = {
      {"<Cmd>7</Cmd>", ""},
      {"<Retries>0</Retries>", "<Retries>none</Retries>"},
      {"<EtherType>a488</EtherType>", "<EtherType>a488</EtherType><Name/>"},
      {"<Transition>IP</Transition>", "<Transition>IO</Transition>"},
      {"<Type>Outputs</Type>", "<Type>Mailbox</Type>"}};
  for (const auto& [from, to] : damages) {
    auto damaged = good;
    const auto at = damaged.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    damaged.replace(at, std::string_view(from).size(), to);
    EXPECT_NE(schema_says(damaged, GetParam().path), "") << from;
  }
}

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// SYNCLINE_WRITE_GOLDEN=1 writes the files anew, for review.
void expect_golden(const NetworkConfig& config, const std::string& name, const EniStyle& style = {}) {
  const auto path = std::filesystem::path(test::source_dir()) / "tests/golden" / name;
  const std::string text = write_eni(config, style);
  if (std::getenv("SYNCLINE_WRITE_GOLDEN") != nullptr) {
    std::ofstream(path, std::ios::binary) << text;
  }
  EXPECT_EQ(content(path), text);
}

TEST(GoldenFile, SmallMachineAsEcEngineer) {
  Project project = sample::small_machine();
  project.master.dc.sync_window.enabled = true;
  expect_golden(compile(project).value().config, "small_machine.eni.xml");
}

TEST(GoldenFile, SmallMachineAsTwinCat) {
  Project project = sample::small_machine();
  project.master.dc.dcm.mode = DcmMode::kMasterShift;
  expect_golden(compile(project, {EniDialect::kTwinCat}).value().config, "small_machine_twincat.eni.xml",
                style_of(EniDialect::kTwinCat));
}

}  // namespace
}  // namespace syncline::eni
