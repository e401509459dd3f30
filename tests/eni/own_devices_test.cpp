// SPDX-License-Identifier: Apache-2.0
#include "tests/support/own_devices.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "eni/esi/esi_reader.h"
#include "tests/support/source_dir.h"

namespace syncline::eni {
namespace {

/// Tests of rooms that know no XML use these devices: they are those of the files, all of them and in everything.
TEST(OwnDevices, AreWhatTheirEsiFilesSay) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() + "/resources/esi")) {
    SCOPED_TRACE(entry.path().filename().string());
    const auto file = read_esi(entry.path().string());
    ASSERT_TRUE(file);
    ASSERT_EQ(file->devices.size(), 1U);
    const auto& read = file->devices.front();
    auto made = sample::own(read.type);
    made.source = read.source;
    EXPECT_EQ(made.identity, read.identity);
    EXPECT_EQ(made.vendor_name, read.vendor_name);
    EXPECT_EQ(made.name, read.name);
    EXPECT_EQ(made.names, read.names);
    EXPECT_EQ(made.group_name, read.group_name);
    EXPECT_EQ(made.sync_managers, read.sync_managers);
    EXPECT_EQ(made.rx_pdos, read.rx_pdos);
    EXPECT_EQ(made.tx_pdos, read.tx_pdos);
    EXPECT_EQ(made.mailbox, read.mailbox);
    EXPECT_EQ(made.dc, read.dc);
    EXPECT_EQ(made.eeprom, read.eeprom);
    EXPECT_EQ(made.timeouts, read.timeouts);
    EXPECT_EQ(made.profiles, read.profiles);
    EXPECT_TRUE(made == read);
    ++files;
  }
  EXPECT_EQ(files, sample::own_devices().size());
}

}  // namespace
}  // namespace syncline::eni
