// SPDX-License-Identifier: Apache-2.0
#include "config/sync_manager_type.h"

#include <gtest/gtest.h>

#include "protocol/sync_manager.h"

namespace syncline {
namespace {

TEST(SyncManagerType, HasTheWordsOfEsiAndEni) {
  constexpr std::pair<SyncManagerType, std::string_view> kAll[] = {{SyncManagerType::kMailboxOut, "MBoxOut"},
                                                                   {SyncManagerType::kMailboxIn, "MBoxIn"},
                                                                   {SyncManagerType::kOutputs, "Outputs"},
                                                                   {SyncManagerType::kInputs, "Inputs"}};
  for (const auto& [type, word] : kAll) {
    EXPECT_EQ(sync_manager_word(type), word);
    EXPECT_EQ(sync_manager_type(word), type) << word;
  }
  EXPECT_EQ(sync_manager_word(SyncManagerType::kUnused), "");
  for (const char* word : {"", "outputs", "Output", "MBox"}) EXPECT_FALSE(sync_manager_type(word)) << word;
}

/// ETG.1000.4, table 58: bits 1..0 mode, 3..2 direction.
TEST(SyncManagerType, IsInTheControlByteToo) {
  const auto of = [](std::uint8_t control) { return sync_manager_type(SyncManager{.control = control}); };
  EXPECT_EQ(of(0x26), SyncManagerType::kMailboxOut);
  EXPECT_EQ(of(0x22), SyncManagerType::kMailboxIn);
  EXPECT_EQ(of(0x64), SyncManagerType::kOutputs);
  EXPECT_EQ(of(0x20), SyncManagerType::kInputs);
}

}  // namespace
}  // namespace syncline
