// SPDX-License-Identifier: Apache-2.0
#include "sim/device/process_data.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "sim/esc/esc.h"
#include "support/clock.h"
#include "tests/support/machine_devices.h"

/// Outputs on their way from a SyncManager into the objects.
namespace syncline::test {
namespace {

constexpr std::uint16_t kOutputs = 0x1000, kAreaSize = 4;

/// A terminal with four bytes of outputs in one object.
struct Bed {
  Bed() : slave(make_slave()), esc(slave, {}, {}, VirtualClock::kDefaultStart, 1) {
    dictionary.add<std::uint32_t>(0x7000, 1, "Out", 0, true);
    auto& memory = esc.memory();
    memory.set<std::uint16_t>(reg::sync_manager(0), kOutputs);
    memory.set<std::uint16_t>(static_cast<std::uint16_t>(reg::sync_manager(0) + 2), kAreaSize);
    data.emplace(slave.device, dictionary, esc, 64);
    data->map();
  }
  static SimSlaveConfig make_slave() {
    SimSlaveConfig config;
    config.device = io8();
    return config;
  }
  void receive(std::uint32_t value) {
    esc.memory().set<std::uint32_t>(kOutputs, value);
    data->take_outputs(0, true);
  }
  [[nodiscard]] std::uint32_t object() { return load_le<std::uint32_t>(dictionary.find(0x7000, 1)->value); }

  SimSlaveConfig slave;
  sim::Esc esc;
  sim::ObjectDictionary dictionary;
  std::optional<sim::ProcessData> data;
};

TEST(SimProcessData, OutputsComeAgainWhenSomebodyElseHasWrittenTheObject) {
  Bed bed;
  bed.receive(17);
  bed.dictionary.find(0x7000, 1)->value = {99, 0, 0, 0};
  bed.data->forget_objects();
  bed.receive(17);
  EXPECT_EQ(bed.object(), 17U);
  bed.data->clear_outputs();
  EXPECT_EQ(bed.object(), 0U);
  bed.receive(17);
  EXPECT_EQ(bed.object(), 17U);
}

TEST(SimProcessData, OutputsOfAStateThatHasNoneAreNotTaken) {
  Bed bed;
  bed.receive(17);
  bed.esc.memory().set<std::uint32_t>(kOutputs, 18);
  bed.data->take_outputs(0, false);
  EXPECT_EQ(bed.object(), 17U);
  bed.data->take_outputs(0, true);
  EXPECT_EQ(bed.object(), 18U);
}

/// A master that makes the area shorter than the PDOs gets what is in it.
TEST(SimProcessData, OfAShortAreaWhatIsWholeIsTaken) {
  Bed bed;
  auto& entries = bed.slave.device.rx_pdos[0].entries;
  entries.resize(2, entries[0]);
  for (std::uint8_t i = 0; i < 2; ++i) {
    entries[i].sub_index = static_cast<std::uint8_t>(i + 1);
    entries[i].bit_length = 16;
  }
  bed.dictionary.add<std::uint16_t>(0x7000, 2, "Second", 0, true);
  bed.data.emplace(bed.slave.device, bed.dictionary, bed.esc, 64);
  bed.data->map();
  const auto second = [&] { return load_le<std::uint16_t>(bed.dictionary.find(0x7000, 2)->value); };
  bed.receive(0x0002'0001);
  EXPECT_EQ(bed.object() & 0xFFFF, 1U);
  EXPECT_EQ(second(), 2U);
  bed.esc.memory().set<std::uint16_t>(static_cast<std::uint16_t>(reg::sync_manager(0) + 2), 2);
  bed.data->forget_objects();
  bed.receive(0x0004'0003);
  EXPECT_EQ(bed.object() & 0xFFFF, 3U);
  EXPECT_EQ(second(), 2U);
}

RC_GTEST_PROP(SimProcessData, ObjectsAreWhatTheMasterWroteLast, ()) {
  Bed bed;
  const auto moves = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 6));
  for (const int move : moves) {
    const auto before = bed.data->outputs_taken();
    const auto shown = bed.object();
    if (move == 0) {
      bed.data->clear_outputs();
      RC_ASSERT(bed.object() == 0U);
    } else if (move == 1) {
      bed.dictionary.find(0x7000, 1)->value = {7, 7, 7, 7};
      bed.data->forget_objects();
    } else {
      bed.receive(static_cast<std::uint32_t>(move));
      RC_ASSERT(bed.object() == static_cast<std::uint32_t>(move));
    }
    // Whoever goes by the number misses nothing.
    if (bed.object() != shown) RC_ASSERT(bed.data->outputs_taken() != before);
  }
}

}  // namespace
}  // namespace syncline::test
