// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <random>
#include <vector>

#include "config/sync0_cycle.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/esi/esi_reader.h"
#include "eni/esi/esi_writer.h"
#include "eni/project/project_builder.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "protocol/assign_activate.h"
#include "support/sample_folder.h"
#include "tests/support/source_dir.h"

namespace syncline::eni {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> xml_files(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

fs::path own_folder() { return fs::path(test::source_dir()) / "resources/esi"; }

struct Counts {
  std::size_t files = 0, devices = 0, warnings = 0, refused = 0;
};

/// Reads every file; each refusal and each warning must lead the user to the place.
Counts read_all(const std::vector<fs::path>& files) {
  Counts counts;
  for (const auto& path : files) {
    ++counts.files;
    const auto file = read_esi(path.string());
    if (!file) {
      ++counts.refused;
      EXPECT_GT(file.error().line, 0) << path;
      EXPECT_FALSE(file.error().subject.empty()) << describe(file.error());
      std::cout << "refused: " << describe(file.error()) << '\n';
      continue;
    }
    counts.devices += file->devices.size();
    counts.warnings += file->warnings.size();
    for (const auto& warning : file->warnings) {
      EXPECT_GT(warning.line, 0) << path;
      EXPECT_FALSE(warning.element.empty() || warning.reason.empty()) << path << ":" << warning.line;
      std::cout << warning.file << ':' << warning.line << " <" << warning.element << "> " << warning.reason.text()
                << '\n';
    }
  }
  std::cout << counts.files << " files, " << counts.devices << " devices, " << counts.warnings << " warnings, "
            << counts.refused << " refused\n";
  return counts;
}

void expect_same_after_writing(const std::vector<fs::path>& files) {
  for (const auto& path : files) {
    const auto file = read_esi(path.string());
    if (!file) continue;
    for (const auto& device : file->devices) {
      const auto again = parse_esi(write_esi(device), device.source);
      ASSERT_TRUE(again) << path << ": " << describe(again.error());
      ASSERT_EQ(again->devices.size(), 1U) << path << ": " << device.type << ": "
                                           << (again->warnings.empty() ? "" : again->warnings.front().reason.text());
      EXPECT_TRUE(again->devices.front() == device) << path << ": " << device.type << " " << to_string(device.identity);
    }
  }
}

TEST(OwnEsiFiles, LoadWithoutWarningsAndComeBack) {
  const auto counts = read_all(xml_files(own_folder()));
  ASSERT_GT(counts.files, 0U);
  EXPECT_GE(counts.devices, counts.files);
  EXPECT_EQ(counts.warnings, 0U);
  EXPECT_EQ(counts.refused, 0U);
  expect_same_after_writing(xml_files(own_folder()));
}

class SampleEsiFiles : public testing::TestWithParam<test::SampleRoot> {
 protected:
  fs::path folder_ = GetParam().folder / "esi";
};
INSTANTIATE_TEST_SUITE_P(Roots, SampleEsiFiles, testing::ValuesIn(test::sample_roots()), test::SampleRootName());

TEST_P(SampleEsiFiles, EveryFileLoadsOrSaysWhereItIsWrong) {
  const auto counts = read_all(xml_files(folder_));
  EXPECT_GT(counts.files, 0U);
  EXPECT_GT(counts.devices, 10 * counts.refused);
  EXPECT_GT(counts.warnings, 0U) << "not all of them are written as they should be";
}

TEST_P(SampleEsiFiles, ReadingWhatWasWrittenGivesTheSame) { expect_same_after_writing(xml_files(folder_)); }

struct KnownDefaults {
  bool own = true;
  std::string esi;
  Identity identity;
  std::string name;  // of the slave
};
void PrintTo(const KnownDefaults& known, std::ostream* out) { *out << known.esi; }

class DriveOfAnEsi : public testing::TestWithParam<KnownDefaults> {};
INSTANTIATE_TEST_SUITE_P(Drives, DriveOfAnEsi,
                         testing::ValuesIn(test::with_others<KnownDefaults>(
                             {{true, "esi/axis.xml", {0xF10A11, 0x20, 0x20003, 0}, "Slave_1001 [HM-20 Axis ]"}},
                             {{false,
                               "esi/tormach__hw_device_mgr__Elmo_ECAT_00010420_V11.rev_10420_only.xml",
                               {0x9A, 0x30924, 0x10420, 0},
                               "Slave_1001 [Elmo Drive ]"}})));

TEST_P(DriveOfAnEsi, GetsTheDefaultsOfOtherConfigurators) {
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_file(test::sample_path(GetParam().own, GetParam().esi)));
  const auto project = project_from_devices({GetParam().identity}, catalogue);
  ASSERT_TRUE(project) << describe(project.error());
  const auto& slave = project->slaves.at(0);
  EXPECT_EQ(slave.name, GetParam().name);
  EXPECT_FALSE(slave.assigned_rx_pdos.empty() || slave.assigned_tx_pdos.empty());
  ASSERT_TRUE(slave.device.dc);
  EXPECT_EQ(slave.dc.op_mode, slave.device.dc->op_modes.front().name);
}

TEST(SpoiltEsiFiles, OneThatBreaksOffIsRefusedWithTheLine) {
  const auto file = read_esi((test::own_samples("spoilt_esi") / "breaks_off.xml").string());
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kXmlMalformed) << describe(file.error());
  EXPECT_EQ(file.error().line, 13);
}

/// Cut and spoilt files end in a result or an error, never in a crash; run it under the sanitizers.
void spoil(const std::string& text, unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](std::size_t limit) { return std::uniform_int_distribution<std::size_t>(0, limit)(random); };
  for (int round = 0; round < 60; ++round) {
    auto spoilt = text.substr(0, round % 3 == 0 ? any(text.size()) : text.size());
    for (std::size_t n = any(8); n > 0 && !spoilt.empty(); --n) {
      const auto place = any(spoilt.size() - 1);
      switch (any(2)) {
        case 0:
          spoilt[place] = static_cast<char>(any(255));
          break;
        case 1:
          spoilt.erase(place, any(40));
          break;
        default:
          spoilt.insert(place, text, any(text.size() - 1), any(60));
          break;
      }
    }
    const auto file = parse_esi(spoilt, "spoilt.xml");
    if (file) continue;
    EXPECT_GT(file.error().line, 0) << describe(file.error());
    EXPECT_EQ(file.error().file, "spoilt.xml");
  }
}

TEST(SpoiltEsiFiles, NeverCrash) {
  unsigned seed = 1;
  for (const auto& path : xml_files(own_folder())) spoil(read_file(path.string()).value(), seed++);
  EXPECT_GT(seed, 1U);
}

/// ETG.2000 leaves CycleTimeSync0 out where SYNC0 comes with the bus cycle.
TEST_P(SampleEsiFiles, ModesThatSwitchSync0OnWithoutACycleTimeFollowTheBus) {
  std::size_t without = 0;
  for (const auto& path : xml_files(folder_)) {
    const auto file = read_esi(path.string());
    if (!file) continue;
    for (const auto& device : file->devices) {
      if (!device.dc) continue;
      for (const auto& mode : device.dc->op_modes) {
        if (!AssignActivate{mode.assign_activate}.sync0()) continue;
        const auto times = compiler::dc_times(mode, {}, kMillisecond);
        const bool says_nothing = mode.cycle_time_sync0.value_ns == 0 && !mode.cycle_time_sync0.factor;
        if (!says_nothing) continue;
        ++without;
        EXPECT_EQ(times.cycle_time0, kMillisecond) << path << ' ' << device.type << ' ' << mode.name;
      }
    }
  }
  EXPECT_EQ(without, GetParam().own ? 2U : 18U);
}

}  // namespace
}  // namespace syncline::eni
