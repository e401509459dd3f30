// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

/// ESC register addresses (Beckhoff ESC data sheet, section II; ETG.1000.4 clause 6).
namespace syncline::reg {

inline constexpr std::uint16_t kType = 0x0000;
inline constexpr std::uint16_t kRevision = 0x0001;
inline constexpr std::uint16_t kBuild = 0x0002;
inline constexpr std::uint16_t kFmmuCount = 0x0004;
inline constexpr std::uint16_t kSyncManagerCount = 0x0005;
inline constexpr std::uint16_t kRamSize = 0x0006;
inline constexpr std::uint16_t kPortDescriptor = 0x0007;
inline constexpr std::uint16_t kFeatures = 0x0008;
inline constexpr std::uint16_t kStationAddress = 0x0010;
inline constexpr std::uint16_t kStationAlias = 0x0012;
inline constexpr std::uint16_t kEscReset = 0x0040;
inline constexpr std::uint16_t kDlControl = 0x0100;
inline constexpr std::uint16_t kDlControlLoop = 0x0101;
inline constexpr std::uint16_t kDlControlAlias = 0x0103;
inline constexpr std::uint16_t kDlStatus = 0x0110;
inline constexpr std::uint16_t kAlControl = 0x0120;
inline constexpr std::uint16_t kAlStatus = 0x0130;
inline constexpr std::uint16_t kAlStatusCode = 0x0134;
inline constexpr std::uint16_t kPdiControl = 0x0140;
inline constexpr std::uint16_t kEscConfiguration = 0x0141;
inline constexpr std::uint16_t kPdiConfiguration = 0x0150;
inline constexpr std::uint16_t kSyncLatchConfiguration = 0x0151;
inline constexpr std::uint16_t kEcatEventMask = 0x0200;
inline constexpr std::uint16_t kAlEventMask = 0x0204;
inline constexpr std::uint16_t kEcatEventRequest = 0x0210;
inline constexpr std::uint16_t kAlEventRequest = 0x0220;
inline constexpr std::uint16_t kRxErrorCounter = 0x0300;
inline constexpr std::uint16_t kForwardedErrorCounter = 0x0308;
inline constexpr std::uint16_t kProcessingUnitErrorCounter = 0x030C;
inline constexpr std::uint16_t kPdiErrorCounter = 0x030D;
inline constexpr std::uint16_t kLostLinkCounter = 0x0310;
inline constexpr std::uint16_t kWatchdogDivider = 0x0400;
inline constexpr std::uint16_t kWatchdogPdi = 0x0410;
inline constexpr std::uint16_t kWatchdogProcessData = 0x0420;
inline constexpr std::uint16_t kWatchdogStatus = 0x0440;
inline constexpr std::uint16_t kWatchdogCounterProcessData = 0x0442;
inline constexpr std::uint16_t kWatchdogCounterPdi = 0x0443;
inline constexpr std::uint16_t kSiiConfiguration = 0x0500;
inline constexpr std::uint16_t kSiiPdiAccess = 0x0501;
inline constexpr std::uint16_t kSiiControl = 0x0502;
inline constexpr std::uint16_t kSiiAddress = 0x0504;
inline constexpr std::uint16_t kSiiData = 0x0508;
inline constexpr std::uint16_t kFmmu = 0x0600;         // + 16 * n
inline constexpr std::uint16_t kSyncManager = 0x0800;  // + 8 * n
inline constexpr std::uint16_t kSyncManagersSize = 0x80;
inline constexpr std::uint16_t kReceiveTimePort0 = 0x0900;
inline constexpr std::uint16_t kReceiveTimePort1 = 0x0904;
inline constexpr std::uint16_t kReceiveTimePort2 = 0x0908;
inline constexpr std::uint16_t kReceiveTimePort3 = 0x090C;
inline constexpr std::uint16_t kSystemTime = 0x0910;
inline constexpr std::uint16_t kReceiveTimeProcessingUnit = 0x0918;
inline constexpr std::uint16_t kSystemTimeOffset = 0x0920;
inline constexpr std::uint16_t kSystemTimeDelay = 0x0928;
inline constexpr std::uint16_t kSystemTimeDifference = 0x092C;
inline constexpr std::uint16_t kSpeedCounterStart = 0x0930;
inline constexpr std::uint16_t kSpeedCounterDiff = 0x0932;
inline constexpr std::uint16_t kFilterDepthDifference = 0x0934;
inline constexpr std::uint16_t kFilterDepthSpeedCounter = 0x0935;
inline constexpr std::uint16_t kReceiveTimeLatchMode = 0x0936;
inline constexpr std::uint16_t kCyclicUnitControl = 0x0980;
inline constexpr std::uint16_t kActivation = 0x0981;
inline constexpr std::uint16_t kPulseLength = 0x0982;
inline constexpr std::uint16_t kActivationStatus = 0x0984;
inline constexpr std::uint16_t kSync0Status = 0x098E;
inline constexpr std::uint16_t kSync1Status = 0x098F;
inline constexpr std::uint16_t kStartTimeCyclicOperation = 0x0990;
inline constexpr std::uint16_t kNextSync1Pulse = 0x0998;
inline constexpr std::uint16_t kSync0CycleTime = 0x09A0;
inline constexpr std::uint16_t kSync1CycleTime = 0x09A4;
inline constexpr std::uint16_t kLatch0Control = 0x09A8;
inline constexpr std::uint16_t kLatch1Control = 0x09A9;
inline constexpr std::uint16_t kLatch0Status = 0x09AE;
inline constexpr std::uint16_t kLatch1Status = 0x09AF;
inline constexpr std::uint16_t kLatch0PositiveEdge = 0x09B0;
inline constexpr std::uint16_t kLatch0NegativeEdge = 0x09B8;
inline constexpr std::uint16_t kLatch1PositiveEdge = 0x09C0;
inline constexpr std::uint16_t kLatch1NegativeEdge = 0x09C8;
inline constexpr std::uint16_t kEcatBufferChangeTime = 0x09F0;
inline constexpr std::uint16_t kDigitalOutputs = 0x0F00;
inline constexpr std::uint16_t kUserRam = 0x0F80;
inline constexpr std::uint16_t kProcessRam = 0x1000;

[[nodiscard]] constexpr std::uint16_t fmmu(unsigned n) { return static_cast<std::uint16_t>(kFmmu + 16 * n); }
[[nodiscard]] constexpr std::uint16_t sync_manager(unsigned n) {
  return static_cast<std::uint16_t>(kSyncManager + 8 * n);
}

/// Data sheet name of the register that holds `address`, "" where none is known.
[[nodiscard]] std::string_view name(std::uint16_t address);

}  // namespace syncline::reg
