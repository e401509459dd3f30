// SPDX-License-Identifier: Apache-2.0
#include "protocol/registers.h"

#include <algorithm>
#include <array>

namespace syncline::reg {
namespace {

struct Row {
  std::uint16_t address;
  std::uint16_t length;
  std::string_view name;
};

constexpr auto kRows = std::to_array<Row>({
    {0x0000, 1, "Type"},
    {0x0001, 1, "Revision"},
    {0x0002, 2, "Build"},
    {0x0004, 1, "FMMUs supported"},
    {0x0005, 1, "SyncManagers supported"},
    {0x0006, 1, "RAM size"},
    {0x0007, 1, "Port descriptor"},
    {0x0008, 2, "ESC features supported"},
    {0x0010, 2, "Configured station address"},
    {0x0012, 2, "Configured station alias"},
    {0x0020, 1, "Register write enable"},
    {0x0021, 1, "Register write protection"},
    {0x0030, 1, "ESC write enable"},
    {0x0031, 1, "ESC write protection"},
    {0x0040, 1, "ESC reset ECAT"},
    {0x0041, 1, "ESC reset PDI"},
    {0x0100, 4, "ESC DL control"},
    {0x0108, 2, "Physical read/write offset"},
    {0x0110, 2, "ESC DL status"},
    {0x0120, 2, "AL control"},
    {0x0130, 2, "AL status"},
    {0x0134, 2, "AL status code"},
    {0x0138, 1, "RUN LED override"},
    {0x0139, 1, "ERR LED override"},
    {0x0140, 1, "PDI control"},
    {0x0141, 1, "ESC configuration"},
    {0x014E, 2, "PDI information"},
    {0x0150, 1, "PDI configuration"},
    {0x0151, 1, "SYNC/LATCH configuration"},
    {0x0152, 2, "Extended PDI configuration"},
    {0x0200, 2, "ECAT event mask"},
    {0x0204, 4, "AL event mask"},
    {0x0210, 2, "ECAT event request"},
    {0x0220, 4, "AL event request"},
    {0x0300, 8, "RX error counter"},
    {0x0308, 4, "Forwarded RX error counter"},
    {0x030C, 1, "ECAT processing unit error counter"},
    {0x030D, 1, "PDI error counter"},
    {0x030E, 2, "PDI error code"},
    {0x0310, 4, "Lost link counter"},
    {0x0400, 2, "Watchdog divider"},
    {0x0410, 2, "Watchdog time PDI"},
    {0x0420, 2, "Watchdog time process data"},
    {0x0440, 2, "Watchdog status process data"},
    {0x0442, 1, "Watchdog counter process data"},
    {0x0443, 1, "Watchdog counter PDI"},
    {0x0500, 1, "EEPROM configuration"},
    {0x0501, 1, "EEPROM PDI access state"},
    {0x0502, 2, "EEPROM control/status"},
    {0x0504, 4, "EEPROM address"},
    {0x0508, 8, "EEPROM data"},
    {0x0510, 2, "MII management control/status"},
    {0x0512, 1, "PHY address"},
    {0x0513, 1, "PHY register address"},
    {0x0514, 2, "PHY data"},
    {0x0516, 1, "MII management ECAT access state"},
    {0x0517, 1, "MII management PDI access state"},
    {0x0518, 4, "PHY port status"},
    {0x0900, 4, "Receive time port 0"},
    {0x0904, 4, "Receive time port 1"},
    {0x0908, 4, "Receive time port 2"},
    {0x090C, 4, "Receive time port 3"},
    {0x0910, 8, "System time"},
    {0x0918, 8, "Receive time ECAT processing unit"},
    {0x0920, 8, "System time offset"},
    {0x0928, 4, "System time delay"},
    {0x092C, 4, "System time difference"},
    {0x0930, 2, "Speed counter start"},
    {0x0932, 2, "Speed counter diff"},
    {0x0934, 1, "System time difference filter depth"},
    {0x0935, 1, "Speed counter filter depth"},
    {0x0936, 1, "Receive time latch mode"},
    {0x0980, 1, "Cyclic unit control"},
    {0x0981, 1, "Activation"},
    {0x0982, 2, "Pulse length of SYNC signals"},
    {0x0984, 1, "Activation status"},
    {0x098E, 1, "SYNC0 status"},
    {0x098F, 1, "SYNC1 status"},
    {0x0990, 8, "Start time cyclic operation"},
    {0x0998, 8, "Next SYNC1 pulse"},
    {0x09A0, 4, "SYNC0 cycle time"},
    {0x09A4, 4, "SYNC1 cycle time"},
    {0x09A8, 1, "Latch0 control"},
    {0x09A9, 1, "Latch1 control"},
    {0x09AE, 1, "Latch0 status"},
    {0x09AF, 1, "Latch1 status"},
    {0x09B0, 8, "Latch0 time positive edge"},
    {0x09B8, 8, "Latch0 time negative edge"},
    {0x09C0, 8, "Latch1 time positive edge"},
    {0x09C8, 8, "Latch1 time negative edge"},
    {0x09F0, 4, "ECAT buffer change event time"},
    {0x09F8, 4, "PDI buffer start event time"},
    {0x09FC, 4, "PDI buffer change event time"},
});

constexpr std::array<std::string_view, 16> kFmmuNames{"FMMU 0",  "FMMU 1",  "FMMU 2",  "FMMU 3", "FMMU 4",  "FMMU 5",
                                                      "FMMU 6",  "FMMU 7",  "FMMU 8",  "FMMU 9", "FMMU 10", "FMMU 11",
                                                      "FMMU 12", "FMMU 13", "FMMU 14", "FMMU 15"};
constexpr std::array<std::string_view, 16> kSyncManagerNames{
    "SyncManager 0",  "SyncManager 1",  "SyncManager 2",  "SyncManager 3", "SyncManager 4",  "SyncManager 5",
    "SyncManager 6",  "SyncManager 7",  "SyncManager 8",  "SyncManager 9", "SyncManager 10", "SyncManager 11",
    "SyncManager 12", "SyncManager 13", "SyncManager 14", "SyncManager 15"};

}  // namespace

std::string_view name(std::uint16_t address) {
  if (address >= kFmmu && address < kFmmu + 16 * 16) return kFmmuNames[(address - kFmmu) / 16U];
  if (address >= kSyncManager && address < kSyncManager + 16 * 8) {
    return kSyncManagerNames[(address - kSyncManager) / 8U];
  }
  if (address >= kProcessRam) return "Process data RAM";
  const auto after = std::upper_bound(kRows.begin(), kRows.end(), address,
                                      [](std::uint16_t value, const Row& row) { return value < row.address; });
  if (after == kRows.begin()) return {};
  const Row& row = *(after - 1);
  return address - row.address < row.length ? row.name : std::string_view{};
}

}  // namespace syncline::reg
