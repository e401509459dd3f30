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
