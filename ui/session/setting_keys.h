// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

/// The settings keys that the pages edit (core/config/settings_keys.h explains each).
namespace syncline::ui::keys {

inline constexpr char kMasterName[] = "master.name";
inline constexpr char kCycleTime[] = "master.cycle_time_us";
inline constexpr char kOverlap[] = "master.overlap_process_data";
inline constexpr char kRecoverAutomatic[] = "master.recovery.automatic";
inline constexpr char kErrorTries[] = "master.recovery.error_tries";
inline constexpr char kStartIncomplete[] = "master.recovery.start_incomplete";
inline constexpr char kDcEnabled[] = "master.dc.enabled";
inline constexpr char kReferenceClock[] = "master.dc.reference_clock";
inline constexpr char kDcmMode[] = "master.dc.mode";
inline constexpr char kSetValue[] = "master.dc.set_value_us";
inline constexpr char kDcmLimit[] = "master.dc.in_sync_limit_ns";
inline constexpr char kDcmSettle[] = "master.dc.in_sync_settle_ms";
inline constexpr char k64Bit[] = "master.dc.show_64bit_system_time";
inline constexpr char kSyncWindow[] = "master.dc.sync_window";
inline constexpr char kSyncWindowExponent[] = "master.dc.sync_window_exponent";
inline constexpr char kSyncWindowSettle[] = "master.dc.sync_window_settle_ms";

inline constexpr char kName[] = "name";
inline constexpr char kStationAddress[] = "station_address";
inline constexpr char kAlias[] = "alias";
inline constexpr char kCheckVendor[] = "check.vendor";
inline constexpr char kCheckProduct[] = "check.product";
inline constexpr char kCheckRevision[] = "check.revision";
inline constexpr char kCheckSerial[] = "check.serial";
inline constexpr char kOpMode[] = "dc.op_mode";
inline constexpr char kPotentialReference[] = "dc.potential_reference_clock";
inline constexpr char kErrorLimit[] = "sync.error_limit";
inline constexpr char kSyncType[] = "sync.type";
inline constexpr char kRxPdos[] = "pdo.rx";
inline constexpr char kTxPdos[] = "pdo.tx";

inline constexpr char kFactor[] = "factor";
inline constexpr char kUserCycle[] = "cycle_us";
inline constexpr char kShift[] = "shift_us";

/// Value that puts an optional setting back to what the operation mode or the master decides.
inline QString unset() { return QStringLiteral("auto"); }

inline QString master(const char* key) { return QLatin1String(key); }
inline QString slave(int position, const char* key) {
  return QStringLiteral("slave.%1.").arg(position) + QLatin1String(key);
}
inline QString sync(int position, int unit, const char* key) {
  return QStringLiteral("slave.%1.dc.sync%2.").arg(position).arg(unit) + QLatin1String(key);
}

}  // namespace syncline::ui::keys
