// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "channels/values/bus_scan.h"

namespace syncline {

class Bus;
class SlaveAddress;

struct ScanOptions {
  /// Writes nothing but read commands into EEPROM interfaces that belong to EtherCAT anyway (0x0502 to
  /// 0x050F): no station addresses, no latching of receive times, no EEPROM is taken from its PDI, no
  /// device identification is requested by AL control. Findings say what could therefore not be read.
  /// Reading DL and AL status acknowledges their event bits in 0x0210; nothing can be read without that.
  bool look_only = false;
  /// See SiiReadOptions.
  bool share_kinds = true;
};

/// Who wants to know how a scan goes. All may be empty.
struct ScanObserver {
  /// Slaves done and slaves found.
  std::function<void(std::size_t done, std::size_t found)> progress{};
  /// Called before anything is written, when `running` slaves are beyond INIT: states and station
  /// addresses stay, but `eeproms` EEPROMs are taken from their PDIs while they are read, and the receive
  /// times of all slaves are latched. Never called when only looking.
  std::function<void(std::size_t running, std::size_t eeproms)> touching{};
};

/// Number of slaves that process a broadcast; 0 when no frame comes back from any.
[[nodiscard]] Result<std::uint16_t> count_slaves(Bus& bus);

/// Finds every slave by its place, and reads who it is, where it hangs and what its clock can do. Slaves
/// of a bus that is all in INIT get station addresses (1001 onwards); a running bus keeps its own. States
/// are left as they are. kNoResponse on an empty or dead bus, kSlaveCount when slaves came or went
/// meanwhile, kCancelled.
[[nodiscard]] Result<BusScan> scan_slaves(Bus& bus, const ScanOptions& options = {}, const ScanObserver& observer = {});

/// What the clocks can do, by asking (feature bits lie): for each station address.
[[nodiscard]] Result<std::vector<DcCapability>> probe_dc(Bus& bus, std::span<const std::uint16_t> stations);
[[nodiscard]] Result<std::vector<DcCapability>> probe_dc(Bus& bus, std::span<const SlaveAddress> slaves);

}  // namespace syncline
