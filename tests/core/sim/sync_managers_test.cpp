// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/sync_managers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace syncline::sim {
namespace {

constexpr std::uint8_t kMailboxOut = 0x26, kMailboxIn = 0x22, kOutputs = 0x64, kInputs = 0x20;
constexpr std::uint16_t kFirst = 0x1000, kMailboxSize = 0x40, kSecond = 0x1080, kThird = 0x1100, kBufferSize = 8,
                        kFourth = 0x1180;

/// Two mailboxes, outputs, inputs.
class Managers : public testing::Test {
 protected:
  Managers() {
    managers_.implement_registers();
    set(0, {kFirst, kMailboxSize, kMailboxOut, 0, 1, 0});
    set(1, {kSecond, kMailboxSize, kMailboxIn, 0, 1, 0});
    set(2, {kThird, kBufferSize, kOutputs, 0, 1, 0});
    set(3, {kFourth, kBufferSize, kInputs, 0, 1, 0});
    managers_.reload();
  }
  void set(unsigned number, const SyncManager& manager) {
    std::ranges::copy(manager.encode(), memory_.at(reg::sync_manager(number), SyncManager::kSize).begin());
  }

  EscMemory memory_{0x1000};
  SyncManagers managers_{memory_, 4};
};

TEST_F(Managers, KnowTheirRegistersWhenTheyAreReadAgain) {
  EXPECT_FALSE(managers_.stale());
  EXPECT_EQ(managers_.begin(), kFirst);
  EXPECT_EQ(managers_.mailboxes(), 0b0011U);
  EXPECT_TRUE(std::ranges::equal(managers_.active(), std::array{0, 1, 2, 3}));
  set(0, {kFirst, kMailboxSize, kMailboxOut, 0, 0, 0});
  managers_.outdate();
  EXPECT_TRUE(managers_.stale());
  EXPECT_EQ(managers_.begin(), kFirst);
  managers_.reload();
  EXPECT_EQ(managers_.begin(), kSecond);
  EXPECT_TRUE(std::ranges::equal(managers_.active(), std::array{1, 2, 3}));
  EXPECT_EQ(managers_.mailboxes(), 0b0011U) << "on or not";
}

TEST_F(Managers, LetTheMasterAtWhatIsHis) {
  EXPECT_TRUE(managers_.allow(0x0800, 8, false)) << "registers";
  EXPECT_TRUE(managers_.allow(kThird, kBufferSize, true));
  EXPECT_FALSE(managers_.allow(kFourth, kBufferSize, true)) << "inputs are not written";
  EXPECT_FALSE(managers_.allow(kThird + kBufferSize, 1, false)) << "its other buffers are the ESC's";
  EXPECT_TRUE(managers_.allow(kThird, 1, false)) << "outputs may be looked at";
  managers_.deactivate(2, true);
  EXPECT_TRUE(managers_.stale());
  managers_.reload();
  EXPECT_FALSE(managers_.allow(kThird, kBufferSize, true));
  managers_.deactivate(2, false);
  managers_.reload();
  EXPECT_TRUE(managers_.allow(kThird, kBufferSize, true));
}

TEST_F(Managers, AMailboxIsWrittenWhenItIsEmptyAndReadWhenItIsFull) {
  EXPECT_TRUE(managers_.allow(kFirst, kMailboxSize, true));
  EXPECT_FALSE(managers_.allow(kSecond, kMailboxSize, false));
  managers_.set_mailbox_full(0, true);
  managers_.set_mailbox_full(1, true);
  EXPECT_EQ(memory_.u8(0x0805), SyncManager::kStatusMailboxFull);
  EXPECT_FALSE(managers_.allow(kFirst, kMailboxSize, true));
  EXPECT_TRUE(managers_.allow(kSecond, kMailboxSize, false));
  managers_.set_mailbox_full(1, false);
  EXPECT_EQ(memory_.u8(0x080D), 0);
  EXPECT_FALSE(managers_.allow(kSecond, kMailboxSize, false));
}

TEST_F(Managers, ATransferBeginsAtTheFirstByteAndEndsWithTheLast) {
  EXPECT_FALSE(managers_.allow(kThird + 4, 4, true)) << "not begun";
  managers_.note_access(kThird, 4, true);
  EXPECT_EQ(managers_.written(), 0U);
  EXPECT_TRUE(managers_.allow(kThird + 4, 4, true));
  managers_.note_access(kThird + 4, 4, true);
  EXPECT_EQ(managers_.written(), 0b0100U);
  EXPECT_FALSE(managers_.allow(kThird + 4, 4, true)) << "the next one begins at its first byte";
  managers_.note_access(kFourth, kBufferSize, false);
  EXPECT_EQ(managers_.read(), 0b1000U);
  managers_.set_transfers(0, 0);
  EXPECT_EQ(managers_.written() | managers_.read(), 0U);
}

TEST_F(Managers, ADamagedFrameTransfersNothing) {
  managers_.note_access(kFourth, 4, false);
  managers_.note_access(kThird, kBufferSize, true);
  managers_.forget_transfers();
  EXPECT_EQ(managers_.written(), 0U);
  EXPECT_FALSE(managers_.allow(kFourth + 4, 4, false));
}

TEST_F(Managers, ATransferUnderWayShowsTheBufferBefore) {
  const std::array<std::uint8_t, 8> first{1, 1, 1, 1, 1, 1, 1, 1}, second{2, 2, 2, 2, 2, 2, 2, 2};
  EXPECT_TRUE(managers_.put(3, first));
  managers_.note_access(kFourth, 4, false);
  EXPECT_FALSE(managers_.put(3, second));
  EXPECT_TRUE(managers_.any_pending());
  EXPECT_EQ(memory_.u8(kFourth + 7), 1);
  managers_.open(kFourth + 1, 4);
  EXPECT_EQ(memory_.u8(kFourth + 7), 1) << "not its first byte";
  managers_.open(kFourth, 4);
  EXPECT_EQ(memory_.u8(kFourth + 7), 2) << "read from the beginning: the newest";
}

TEST_F(Managers, WhatWasUnderWayIsOverWhenTheyAreSetUpAnew) {
  const std::array<std::uint8_t, 1> byte{7};
  managers_.note_access(kFourth, 4, false);
  (void)managers_.put(3, byte);
  managers_.set_up_anew();
  EXPECT_FALSE(managers_.any_pending());
  managers_.open(kFourth, 8);
  EXPECT_EQ(memory_.u8(kFourth), 0);
}

TEST_F(Managers, APutThatIsTooLongEndsWithTheArea) {
  std::array<std::uint8_t, kBufferSize + 2> bytes{};
  bytes.fill(9);
  (void)managers_.put(3, bytes);
  EXPECT_EQ(memory_.u8(kFourth + kBufferSize - 1), 9);
  EXPECT_EQ(memory_.u8(kFourth + kBufferSize), 0);
}

TEST_F(Managers, AnAreaBeyondTheMemoryIsCut) {
  set(3, {0xFFFE, 8, kInputs, 0, 1, 0});
  managers_.outdate();
  EXPECT_EQ(managers_.area(3).size(), 2U) << "by its registers";
  managers_.reload();
  EXPECT_EQ(managers_.area(3).size(), 2U);
}

TEST_F(Managers, LockTheirPlaceWhileTheyAreOn) {
  EXPECT_TRUE(managers_.locks_register(0x0800));
  EXPECT_TRUE(managers_.locks_register(0x0804));
  EXPECT_FALSE(managers_.locks_register(0x0806)) << "by which it is switched off";
  EXPECT_FALSE(managers_.locks_register(0x07FF));
  set(0, {kFirst, kMailboxSize, kMailboxOut, 0, 0, 0});
  EXPECT_FALSE(managers_.locks_register(0x0800));
}

TEST_F(Managers, AnswerARepeatRequestOnce) {
  EXPECT_FALSE(managers_.repeat_requested(1));
  memory_.set<std::uint8_t>(0x080E, 0x03);
  EXPECT_TRUE(managers_.repeat_requested(1));
  managers_.acknowledge_repeat(1);
  EXPECT_FALSE(managers_.repeat_requested(1));
  EXPECT_EQ(memory_.u8(0x080F), 0x02);
}

TEST_F(Managers, GiveTheMasterNoStatusToWrite) {
  EXPECT_EQ(memory_.rights(0x0804), EscMemory::kReadWrite);
  EXPECT_EQ(memory_.rights(0x0805), EscMemory::kRead);
  EXPECT_EQ(memory_.rights(0x0807), EscMemory::kRead);
  EXPECT_EQ(memory_.rights(0x0820), 0) << "there are four";
}

}  // namespace
}  // namespace syncline::sim
