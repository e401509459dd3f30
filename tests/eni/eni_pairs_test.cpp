// SPDX-License-Identifier: Apache-2.0
// Stored exports, ours and those of other tools, whose slaves an ESI of the samples covers: the project with that ESI
// and the settings that the export shows compiles to the same commands, or the difference stands here with its reason.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "eni/catalogue/esi_catalogue.h"
#include "eni/esi/esi_reader.h"
#include "eni/format/eni_file.h"
#include "findings/error_text.h"
#include "recover/recover_project.h"
#include "support/sample_folder.h"

namespace syncline::eni {
namespace {

struct Reason {
  const char* file;        // whose differences it explains, "" = of every file
  const char* difference;  // regular expression of the whole text
  const char* why;
};

constexpr const char* kTimeOut =
    R"(slave \d+, init command \d+ \([AF]PWR .*:0x0120, .*\): time-out is \d+ in the first file, none in the second)";
constexpr const char* kTwinCat3 =
    "TwinCAT 3 gives the AL control writes a time-out, which the check behind them has anyway; ET9000, which the "
    "dialect "
    "follows, does not";

constexpr Reason kReasons[] = {
    {"jasper-node__jn-ec-master__mega_master_eni.xml", kTimeOut, kTwinCat3},
    {"kpierczy__ethercat-lib__test_eni.xml", kTimeOut, kTwinCat3},
    {"kpierczy__ethercat-lib__test_eni.xml",
     R"(cyclic task 1, frame 1, command [45]: only in the (first|second) file: LR[DW] .*)",
     "TwinCAT 3 orders its areas by sync units: here the input that has one of its own comes before the drives"},
    {"kpierczy__ethercat-lib__test_eni.xml",
     R"(slave [1-4], init command 3[12] \(FPWR 100[2-5]:0x06[01]0, PS\): data is .*)",
     "the logical addresses of these areas"},
    {"kpierczy__ethercat-lib__test_eni.xml", R"(slave 0, init command 2[2-8].* FPWR 1001:0x06[012]0, .*)",
     "TwinCAT 3 gives an output SyncManager without data a switched-off FMMU, so that the numbers of the others move"},
    {"kpierczy__ethercat-lib__test_eni.xml", R"(slave 0, init command 22 \(FPWR 1001:0x0600, PS\): data is .*)",
     "the same"},
    {"magnate3__rocos-ethercat__eni1.xml", ".*",
     "Elmo Application Studio has a list of commands of its own (order, transitions, no working counters, one by one), "
     "a "
     "master that distributes the time without commands in the frames, and no PDOs in its files"},
};

/// ESI files of the slaves of each ENI.
std::map<std::string, std::set<std::string>> pairs(const std::string& table) {
  std::map<std::string, std::set<std::string>> found;
  std::ifstream in(table);
  std::string row;
  std::getline(in, row);
  while (std::getline(in, row)) {
    std::vector<std::string> fields;
    std::istringstream cells(row);
    for (std::string field; std::getline(cells, field, '\t');) fields.push_back(field);
    if (fields.size() >= 8 && fields[6] == "EXACT") found[fields[0]].insert(fields[7]);
  }
  return found;
}

std::vector<DeviceDescription> devices_of(const std::filesystem::path& folder, const std::set<std::string>& files) {
  std::vector<DeviceDescription> devices;
  for (const auto& file : files) {
    if (auto esi = read_esi((folder / file).string())) {
      for (auto& device : esi->devices) devices.push_back(std::move(device));
    }
  }
  return devices;
}

bool is_explained(const std::string& file, const std::string& difference) {
  return std::ranges::any_of(kReasons, [&](const Reason& reason) {
    return (*reason.file == 0 || file == reason.file) && std::regex_match(difference, std::regex(reason.difference));
  });
}

class EniPairsOf : public testing::TestWithParam<test::SampleRoot> {};
INSTANTIATE_TEST_SUITE_P(Roots, EniPairsOf, testing::ValuesIn(test::sample_roots()), test::SampleRootName());

TEST_P(EniPairsOf, SamplesCompileToTheSameCommands) {
  const auto& folder = GetParam().folder;
  std::size_t files = 0, slaves = 0, with_esi = 0, explained = 0;
  for (const auto& [file, esi_files] : pairs((folder / "eni/ESI_PAIRS.tsv").string())) {
    SCOPED_TRACE(file);
    const auto config = read_eni((folder / "eni" / file).string());
    ASSERT_TRUE(config) << describe(config.error());
    const auto devices = devices_of(folder / "esi", esi_files);
    const auto recovered = recover_project(*config, [&](const Identity& identity) -> const DeviceDescription* {
      for (const auto& device : devices) {
        const auto& of = device.identity;
        if (of.vendor_id == identity.vendor_id && of.product_code == identity.product_code &&
            of.revision_no == identity.revision_no) {
          return &device;
        }
      }
      return nullptr;
    });
    for (const auto& slave : recovered.project.slaves) with_esi += slave.device.source != "ENI" ? 1 : 0;
    for (const auto& difference : recovered.differences) {
      const auto words = describe(difference);
      EXPECT_TRUE(is_explained(file, words)) << words;
      ++explained;
    }
    ++files;
    slaves += config->slaves.size();
  }
  EXPECT_EQ(with_esi, GetParam().own ? 15U : 21U) << "ESI files of the table that were not taken";
  fmt::print("{} files, {} slaves, {} of them with their ESI, {} differences explained\n", files, slaves, with_esi,
             explained);
}

/// The same with the simulated devices: each stored export and their ESI files give a project that gives the export's
/// commands.
TEST(EniPairs, OurExportsCompileToTheSameCommands) {
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
  for (const char* file : {"row.eni.xml", "drives.eni.xml", "one_line.eni.xml"}) {
    SCOPED_TRACE(file);
    const auto config = read_eni((test::own_samples("eni") / file).string());
    ASSERT_TRUE(config) << describe(config.error());
    const auto recovered = recover_project(*config, [&](const Identity& identity) -> const DeviceDescription* {
      const auto match = catalogue.find(identity);
      return match && match->exact_revision ? match->device : nullptr;
    });
    for (const auto& slave : recovered.project.slaves) EXPECT_NE(slave.device.source, "ENI") << slave.name;
    for (const auto& difference : recovered.differences) ADD_FAILURE() << describe(difference);
  }
}

}  // namespace
}  // namespace syncline::eni
