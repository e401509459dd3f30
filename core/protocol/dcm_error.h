// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace syncline::dc {

/// Error codes of the master synchronisation, with EC-Master's numbers.
inline constexpr std::uint32_t kDcmErrorUnspecific = 0x981201C0;
inline constexpr std::uint32_t kDcmErrorNotInitialised = 0x981201C1;
inline constexpr std::uint32_t kDcmErrorOutOfLimit = 0x981201C2;
inline constexpr std::uint32_t kDcmErrorNoMemory = 0x981201C3;
inline constexpr std::uint32_t kDcmErrorInvalidHardwareLayer = 0x981201C4;
inline constexpr std::uint32_t kDcmErrorTimerModify = 0x981201C5;
inline constexpr std::uint32_t kDcmErrorTimerNotRunning = 0x981201C6;
inline constexpr std::uint32_t kDcmErrorWrongCpu = 0x981201C7;
inline constexpr std::uint32_t kDcmErrorInvalidSyncPeriod = 0x981201C8;
inline constexpr std::uint32_t kDcmErrorInvalidSetValue = 0x981201C9;
inline constexpr std::uint32_t kDcmErrorDriftTooHigh = 0x981201CA;  // more than kMostDriftPpm
inline constexpr std::uint32_t kDcmErrorBusCycleWrong = 0x981201CB;
inline constexpr std::uint32_t kDcxErrorNoExternalClock = 0x981201CC;
inline constexpr std::uint32_t kDcmErrorInvalidData = 0x981201CD;

/// Drift between host and reference clock that no controller is to balance, ppm: an ESC's loop reaches 763 ppm, and
/// needs some of it itself.
inline constexpr double kMostDriftPpm = 600;

/// What EC-Master calls it, "DCM_E_INVALID_SETVAL"; empty when it is none of these.
[[nodiscard]] std::string_view dcm_error_name(std::uint32_t code);
/// English words: what is wrong and what to do about it. Empty when it is none of these.
[[nodiscard]] std::string_view dcm_error_text(std::uint32_t code);

}  // namespace syncline::dc
