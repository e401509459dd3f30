// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/sync_object_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/mailbox/mailbox_server.h"
#include "tests/core/master/mailbox_bed.h"

namespace syncline::test {
namespace {

using testing::HasSubstr;

/// A slave with a dictionary of its own, with or without SDO information.
class SyncObjects : public testing::Test {
 protected:
  void add(std::uint16_t index, std::uint8_t sub_index, const char* name, std::uint32_t value, unsigned bytes) {
    auto data = le_bytes(value);
    data.resize(bytes);
    dictionary.add(index, sub_index, name, std::move(data));
  }
  void identify(std::uint32_t vendor, std::uint32_t product) {
    add(0x1018, 0, "Identity", 4, 1);
    add(0x1018, 1, "Vendor ID", vendor, 4);
    add(0x1018, 2, "Product code", product, 4);
    add(0x1018, 3, "Revision", 1, 4);
  }
  Result<std::vector<SyncParameters>> read(bool names) {
    MailboxDescription description;
    description.coe.emplace();
    description.coe->sdo_info = names;
    server.emplace(dictionary, description, 0);
    bed.slave->handler = [this](const MailboxMessage& request) {
      server->receive(request.encode(128), 128, true);
      std::vector<MailboxMessage> answers;
      while (const auto bytes = server->next(128)) {
        auto message = MailboxMessage::decode(*bytes);
        if (message) answers.push_back(std::move(*message));
      }
      return answers;
    };
    return read_sync_objects(*bed.client);
  }

  sim::ObjectDictionary dictionary;
  std::optional<sim::MailboxServer> server;
  MailboxBed bed;
};

TEST_F(SyncObjects, NamesOfTheSlaveDecideWhichCounterIsWhich) {
  identify(0x539, 0x0220'0001);  // a vendor of the old layout, but this device speaks for itself
  dictionary.set_object_name(0x1C32, "Output sync");
  add(0x1C32, 0, "Entries", 12, 1);
  add(0x1C32, 1, "Sync type", 2, 2);
  add(0x1C32, 2, "Cycle", 250'000, 4);
  add(0x1C32, 0x0B, "SM-Event Missed", 7, 4);
  add(0x1C32, 0x0C, "Cycle Time Too Small", 3, 2);
  const auto objects = read(true);
  ASSERT_TRUE(objects);
  ASSERT_EQ(objects->size(), 1U) << "no inputs";
  const auto& outputs = objects->front();
  EXPECT_EQ(outputs.name, "Output sync");
  EXPECT_EQ(outputs.counter_source, CounterSource::kObjectName);
  EXPECT_EQ(outputs.value(SyncValue::kMissed), 7U);
  EXPECT_EQ(outputs.value(SyncValue::kCycleExceeded), 3U);
  EXPECT_EQ(outputs.value(SyncValue::kType), 2U);
  EXPECT_EQ(outputs.value(SyncValue::kCycleTime), 250'000U);
  EXPECT_FALSE(outputs.value(SyncValue::kShiftTime)) << "not there";
  EXPECT_EQ(outputs.entries.size(), 4U);
  EXPECT_EQ(outputs.entries[2].name, "SM-Event Missed");
}

TEST_F(SyncObjects, WithoutNamesTheDeviceDecides) {
  identify(0x539, 0x0220'0001);
  add(0x1C33, 0, "", 0x20, 1);
  add(0x1C33, 0x0B, "", 7, 2);
  add(0x1C33, 0x0C, "", 3, 2);
  add(0x1C33, 0x20, "", 1, 1);
  const auto objects = read(false);
  ASSERT_TRUE(objects);
  const auto& inputs = objects->front();
  EXPECT_EQ(inputs.index, 0x1C33);
  EXPECT_EQ(inputs.counter_source, CounterSource::kDeviceProfile);
  EXPECT_EQ(inputs.value(SyncValue::kMissed), 3U);
  EXPECT_EQ(inputs.value(SyncValue::kCycleExceeded), 7U);
  EXPECT_EQ(inputs.value(SyncValue::kSyncError), 1U);
  EXPECT_EQ(inputs.entries[0].name, "Cycle exceeded counter");
}

TEST_F(SyncObjects, OfAnUnknownDeviceBothAreShown) {
  identify(0x9999, 1);
  add(0x1C32, 0, "", 0x0C, 1);
  add(0x1C32, 0x0B, "Counter 1", 7, 2);
  add(0x1C32, 0x0C, "Counter 2", 3, 2);
  for (const bool names : {false, true}) {
    const auto objects = read(names);
    ASSERT_TRUE(objects);
    const auto& outputs = objects->front();
    EXPECT_EQ(outputs.counter_source, CounterSource::kUnknown);
    EXPECT_FALSE(outputs.value(SyncValue::kMissed));
    ASSERT_EQ(outputs.entries.size(), 2U);
    for (const auto& entry : outputs.entries) {
      EXPECT_EQ(entry.meaning, SyncValue::kMissedOrExceeded);
      EXPECT_THAT(entry.name, HasSubstr(names ? "Counter" : "old layout"));
    }
  }
}

TEST_F(SyncObjects, ADeviceWithoutThemHasNone) {
  identify(1, 1);
  const auto objects = read(true);
  ASSERT_TRUE(objects);
  EXPECT_TRUE(objects->empty());
}

TEST(SyncText, NamesTypesAndWhatIsSupported) {
  EXPECT_EQ(sync_type_text(2), "DC, SYNC0");
  EXPECT_EQ(sync_type_text(0x22), "synchronous with the SM2 event");
  EXPECT_EQ(supported_types_text(0x4005), "free run, SYNC0, measures its times");
  EXPECT_EQ(supported_types_text(0x0100), "0x0100");
}

}  // namespace
}  // namespace syncline::test
