// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/device_dictionary_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "config/device_dictionary.h"
#include "findings/error_text.h"
#include "master/exchange/bus.h"
#include "master/exchange/frame_exchange.h"
#include "master/startup/slave_visit.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

/// What the drive maps, as its own objects say it: index, sub-index and bits of each entry.
TEST(DeviceDictionaryReader, HasTheMappingAndTheAssignmentOfTheDevice) {
  VirtualClock clock;
  test::SimulatedNetwork network;
  network.add(test::servo(), "servo-y");
  const auto link = network.link(clock);
  FrameExchange exchange(*link, clock);
  Bus bus(exchange, clock);
  SlaveVisit visit(bus, 0);
  ASSERT_TRUE(visit.look());
  ASSERT_TRUE(visit.open_mailbox());
  const auto device = test::servo();
  const auto read = read_device_dictionary(visit.mailbox(), device);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->assigned_rx, std::vector<std::uint16_t>{0x1600});
  EXPECT_EQ(read->assigned_tx, std::vector<std::uint16_t>{0x1A00});
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    const auto& found = direction == PdoDirection::kRx ? read->rx_pdos : read->tx_pdos;
    ASSERT_FALSE(found.empty());
    for (const auto& pdo : device.pdos(direction)) {
      SCOPED_TRACE(pdo.index);
      const auto same = std::ranges::find(found, pdo.index, &DictionaryPdo::index);
      ASSERT_NE(same, found.end());
      std::vector<std::uint32_t> mapped;
      for (const auto& entry : pdo.entries)
        mapped.push_back(std::uint32_t{entry.index} << 16 | std::uint32_t{entry.sub_index} << 8 | entry.bit_length);
      EXPECT_EQ(same->mapped, mapped);
    }
  }
  EXPECT_TRUE(std::ranges::any_of(read->objects, [](const auto& object) { return object.index == 0x1018; }));
  ASSERT_TRUE(visit.leave());
}

}  // namespace
}  // namespace syncline
