// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// Bits of the ECAT event request (0x0210), the AL event request (0x0220) and the PDI control of a SyncManager.
namespace syncline::sim::esc_events {

inline constexpr std::uint16_t kEventLatch = 0x0001, kEventDlStatus = 0x0004, kEventAlStatus = 0x0008,
                               kEventSyncManager0 = 0x0010;

/// What the PDI side has to deal with.
inline constexpr std::uint32_t kAlEventControl = 0x01, kAlEventLatch = 0x02, kAlEventSync0 = 0x04,
                               kAlEventSyncManagerSet = 0x10, kAlEventWatchdog = 0x40, kAlEventSyncManager0 = 0x100;

inline constexpr std::uint8_t kPdiDeactivated = 0x01;  // of 0x0807
inline constexpr std::uint8_t kRepeatBit = 0x02;       // of 0x0806 and 0x0807

}  // namespace syncline::sim::esc_events
