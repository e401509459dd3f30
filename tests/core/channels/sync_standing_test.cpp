// SPDX-License-Identifier: Apache-2.0
#include "channels/sync_standing.h"

#include <gtest/gtest.h>

#include <set>

namespace syncline {
namespace {

DcStatus slaves(SyncState state) {
  DcStatus dc;
  dc.enabled = dc.monitored = true;
  dc.state = state;
  return dc;
}

DcmStatus master(SyncState state) {
  DcmStatus dcm;
  dcm.mode = DcmMode::kBusShift;
  dcm.state = state;
  return dcm;
}

TEST(SyncStanding, OnlyInSyncIsAYes) {
  for (const auto state : {SyncState::kNotReady, SyncState::kBusy, SyncState::kOutOfSync, SyncState::kUnknown}) {
    EXPECT_EQ(slaves_in_sync(slaves(state)), false);
    EXPECT_EQ(master_in_sync(master(state)), false);
    EXPECT_FALSE(is_synchronised(slaves(state), master(SyncState::kInSync)));
    EXPECT_FALSE(is_synchronised(slaves(SyncState::kInSync), master(state)));
  }
  EXPECT_EQ(slaves_in_sync(slaves(SyncState::kInSync)), true);
  EXPECT_TRUE(is_synchronised(slaves(SyncState::kInSync), master(SyncState::kInSync)));
}

TEST(SyncStanding, WhoIsNotAskedToComeIsNotMissing) {
  EXPECT_EQ(slaves_in_sync(slaves(SyncState::kNotMonitored)), std::nullopt);
  EXPECT_TRUE(is_synchronised(slaves(SyncState::kNotMonitored), master(SyncState::kInSync)));
  DcStatus no_clocks;
  EXPECT_EQ(slaves_in_sync(no_clocks), std::nullopt);
  EXPECT_TRUE(is_synchronised(no_clocks, master(SyncState::kOutOfSync)));
  auto off = master(SyncState::kOutOfSync);
  off.mode = DcmMode::kOff;
  EXPECT_EQ(master_in_sync(off), std::nullopt);
  EXPECT_TRUE(is_synchronised(slaves(SyncState::kInSync), off));
  auto left_alone = master(SyncState::kOutOfSync);
  left_alone.control_off = true;
  EXPECT_TRUE(is_synchronised(slaves(SyncState::kInSync), left_alone));
}

TEST(SyncStanding, EachStateHasAKeyAndWords) {
  std::set<std::string_view> keys, texts;
  for (std::uint8_t i = 0; i < kSyncStates; ++i) {
    keys.insert(sync_state_key(static_cast<SyncState>(i)));
    texts.insert(sync_state_text(static_cast<SyncState>(i)));
  }
  EXPECT_EQ(keys.size(), kSyncStates);
  EXPECT_EQ(texts.size(), kSyncStates);
  EXPECT_EQ(sync_state_key(SyncState::kInSync), "in_sync");
  EXPECT_EQ(sync_state_key(static_cast<SyncState>(99)), "unknown");
}

}  // namespace
}  // namespace syncline
