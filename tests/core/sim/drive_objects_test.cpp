// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/core/sim/drive_bed.h"

/// What a drive answers of its objects before anybody has written one.
namespace syncline::test {
namespace {

struct PowerOn {
  std::uint16_t index;
  std::uint8_t sub_index;
  std::uint32_t value;
  std::size_t written;  // bytes; 0: read only
};

constexpr PowerOn kObjects[] = {
    {0x603F, 0, 0, 0},       {0x6040, 0, 0, 2},         {0x6060, 0, 8, 1}, {0x6061, 0, 0, 0}, {0x6062, 0, 0, 0},
    {0x6064, 0, 0, 0},       {0x606C, 0, 0, 0},         {0x607A, 0, 0, 4}, {0x60FF, 0, 0, 4}, {0x60F4, 0, 0, 0},
    {0x6081, 0, 100'000, 4}, {0x6083, 0, 1'000'000, 4}, {0x60C1, 0, 1, 0}, {0x60C1, 1, 0, 4}, {0x60C2, 0, 2, 0},
    {0x60C2, 1, 1, 1},       {0x60C2, 2, 0xFD, 1},      {0x10F1, 0, 2, 0}, {0x10F1, 1, 1, 4}, {0x10F1, 2, 9, 2}};

TEST(SimDriveObjects, AreAtPowerOnWhatTheProfileSays) {
  DriveBed drive("SL-SV7");
  for (const auto& object : kObjects) {
    EXPECT_EQ(drive.read(object.index, object.sub_index), object.value) << std::hex << object.index;
  }
  EXPECT_EQ(drive.read(0x6041, 0) & 0x6F, 0x40U) << "switch on disabled";
}

TEST(SimDriveObjects, TakeWhatIsWrittenToThemAndRefuseWhereTheyAreReadOnly) {
  constexpr std::uint32_t kReadOnly = 0x0601'0002;
  DriveBed drive("SL-SV7");
  for (const auto& object : kObjects) {
    const std::vector<std::uint8_t> same(object.written == 0 ? 4 : object.written, 3);
    const auto refused = drive.write(object.index, object.sub_index, same);
    EXPECT_EQ(refused, object.written == 0                               ? kReadOnly
                       : object.index == 0x10F1 && object.sub_index == 2 ? 0x0609'0030
                                                                         : 0)
        << std::hex << object.index << ':' << int{object.sub_index};
    if (refused == 0) {
      EXPECT_EQ(drive.read(object.index, object.sub_index) & 0xFF, 3U) << std::hex << object.index;
    }
  }
}

/// 0 to 15 (docs/device-families.md).
TEST(SimDriveObjects, TheLimitOfErrorsHasARange) {
  DriveBed drive("SL-SV7");
  EXPECT_EQ(drive.write(0x10F1, 2, {15, 0}), 0U);
  EXPECT_EQ(drive.write(0x10F1, 2, {16, 0}), 0x0609'0030U);
  EXPECT_EQ(drive.read(0x10F1, 2), 15U);
}

/// A master that begins anew knows nothing of what the one before has had repeated.
TEST(Mailbox, AnswersAtOnceAfterItIsSetUpAnewWithTheOtherToggle) {
  DriveBed drive("SL-SV7");
  const auto vendor = drive.read(0x1018, 1);
  const auto activate = static_cast<std::uint16_t>(reg::sync_manager(1) + 6);
  drive.probe.write(0, activate, {0x03});  // enabled, and the answer once more
  drive.probe.pass(kMillisecond);
  EXPECT_EQ(drive.probe.read(0, static_cast<std::uint16_t>(activate + 1), 1).data[0] & 0x02, 0x02) << "acknowledged";
  EXPECT_EQ(drive.probe.request(0, 1), 1);
  for (unsigned i = 0; i < 2; ++i) {
    const auto& sm = drive.device.sync_managers[i];
    drive.probe.set_sync_manager(0, i, sm.start_address, 128, sm.control_byte);
  }
  drive.probe.pass(kMillisecond);
  EXPECT_EQ(drive.probe.request(0, 2), 2);
  EXPECT_EQ(drive.read(0x1018, 1), vendor);
}

}  // namespace
}  // namespace syncline::test
