// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/types.h"

namespace syncline {
struct DeviceDescription;
struct Identity;
struct SlaveConfig;
}  // namespace syncline

/// Look-ups in the table of device families. Pure, from any thread; nothing here allocates but what returns a string or
/// a list.
namespace syncline::families {

struct Alarm;
struct Family;
struct StatusObject;
struct SyncCounters;

/// All of them, the more special before the more general.
[[nodiscard]] std::span<const Family* const> all();

/// By vendor ID and product code, which is all that an ENI and a running slave tell. Null: nothing is known.
[[nodiscard]] const Family* find(const Identity& identity);
/// The same; also by the beginning of the type's name.
[[nodiscard]] const Family* find(const DeviceDescription& device);
/// The simulated device's own family with this behaviour ("servo-y", "drive-c", "can-gateway", "analog-input"); null
/// for any other word.
[[nodiscard]] const Family* of_behaviour(std::string_view behaviour);
/// What a simulated device of this kind behaves as, where nobody says it: as its family's, else "generic".
[[nodiscard]] std::string_view behaviour_of(const DeviceDescription& device);

/// The shortest cycle that the device's own dictionary names (default of 0x1C32:05 and 0x1C33:05), ns.
[[nodiscard]] std::optional<Nanoseconds> minimum_cycle(const DeviceDescription& device);

/// Where the counters of 0x1C32 and 0x1C33 stand. Empty: nobody knows, and the object's own words or both places must
/// be looked at (ETG.1020's places are SyncCounters{}).
[[nodiscard]] std::optional<SyncCounters> sync_counters(const Identity& identity);

/// The limit of the error counter that the slave will have in OP: what the start-up list writes to 0x10F1:02, else the
/// family's. Empty: not known. 0: the slave never gives up.
[[nodiscard]] std::optional<std::uint32_t> error_limit(const SlaveConfig& slave);

/// The vendor's alarm of a number in 0x603F or in an emergency; null when it is none that we know.
[[nodiscard]] const Alarm* find_alarm(const Identity& identity, std::uint16_t error_code);
/// The alarm that an emergency tells: its error code, or behind 0xFF00 (CiA 301, device specific) the vendor's own
/// number in the bytes behind the error register.
[[nodiscard]] const Alarm* find_alarm(const Identity& identity, std::uint16_t error_code,
                                      const std::array<std::uint8_t, 5>& data);
/// "A.A12 (0x0A12) EtherCAT Outputs Data Synchronization Error", or "0x0A12" when nothing is known.
[[nodiscard]] std::string alarm_text(const Identity& identity, std::uint16_t error_code);

/// One bit of a status object in words.
struct StatusLine {
  std::uint8_t bit = 0;
  bool as_wanted = false;   // as a synchronised device shows it
  std::string_view text{};  // empty: nothing to say
};
[[nodiscard]] std::vector<StatusLine> status_lines(const StatusObject& object, std::uint32_t value);

}  // namespace syncline::families
