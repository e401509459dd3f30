// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "master/scan/bus_scanner.h"
#include "tests/support/sample_folder.h"
#include "tests/support/scan_bed.h"

namespace syncline {
namespace {

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return {text.begin(), text.end()};
}

/// A bus of the EEPROMs of real devices: the scan says of each what its words say.
TEST(ScanSamples, ReportsTheIdentitiesOfRealEeproms) {
  auto files = test::all_samples("sii", ".bin");
  std::erase_if(files, [](const auto& path) { return std::filesystem::file_size(path) < 128; });
  ASSERT_FALSE(files.empty());
  test::SimulatedNetwork network;
  std::vector<std::vector<std::uint8_t>> images;
  for (const auto& file : files) {
    images.push_back(bytes_of(file));
    network.add(test::io8());
    network.sim.slaves.back().sii_image = images.back();
  }
  VirtualClock clock;
  const auto link = network.link(clock);
  ASSERT_TRUE(link);
  FrameExchange exchange(*link, clock);
  Bus bus(exchange, clock);
  const auto scan = scan_slaves(bus);
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->slaves.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto& slave = scan->slaves[i];
    const auto word = [&](std::size_t at) { return load_le<std::uint32_t>(std::span(images[i]).subspan(2 * at)); };
    ASSERT_TRUE(slave.sii) << files[i] << ": " << (slave.sii_error ? slave.sii_error->detail.text() : "");
    EXPECT_EQ(slave.identity, (Identity{word(8), word(10), word(12), word(14)})) << files[i];
    const auto whole = sii::decode(images[i]);
    ASSERT_TRUE(whole) << files[i];
    EXPECT_EQ(slave.sii->sync_managers, whole->sync_managers) << files[i];
    EXPECT_EQ(slave.sii->tx_pdos, whole->tx_pdos) << files[i];
    EXPECT_EQ(slave.sii->rx_pdos, whole->rx_pdos) << files[i];
  }
}

}  // namespace
}  // namespace syncline
