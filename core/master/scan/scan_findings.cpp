// SPDX-License-Identifier: Apache-2.0
#include "master/scan/scan_findings.h"

#include <fmt/format.h>

#include <map>

namespace syncline {
namespace {

char port_letter(std::size_t port) { return static_cast<char>('A' + port); }

class Findings {
 public:
  explicit Findings(BusScan& scan) : scan_(scan) {}

  void add(ErrorCode code, const ScannedSlave& slave, std::string detail) {
    scan_.findings.push_back(
        {.code = code, .subject = fmt::format("slave {}", slave.position), .detail = std::move(detail)});
  }

  void wiring(const ScannedSlave& slave, const SlaveWiring& wiring) {
    if (wiring.entry_port != 0) {
      add(ErrorCode::kWiring, slave,
          fmt::format(
              "frames enter it by port {} instead of port A; swap its cables IN and OUT, or what hangs at its port A "
              "stands in front of it",
              port_letter(wiring.entry_port)));
    }
    if (!wiring.previous && !wiring.root) {
      add(ErrorCode::kWiring, slave,
          "the open ports of the slaves before it do not explain its place; see that at it and its neighbours the "
          "cable from the "
          "master is in IN (port A) and not in OUT");
    }
    for (unsigned port = 0; port < kPortCount; ++port) {
      if (((wiring.unexplained_ports >> port) & 1U) != 0) {
        add(ErrorCode::kWiring, slave,
            fmt::format("port {} is open, but no slave answers behind it: a cable back to the master, or a device "
                        "that is no slave",
                        port_letter(port)));
      } else if (slave.dl_status.physical_link(port) && !slave.dl_status.communication(port)) {
        add(ErrorCode::kWiring, slave, fmt::format("port {} has a link, but frames do not pass it", port_letter(port)));
      }
    }
  }

  void identification(const ScannedSlave& slave) {
    if (slave.alias != 0) {
      const auto [first, fresh] = aliases_.emplace(slave.alias, slave.position);
      if (!fresh) {
        add(ErrorCode::kIdentification, slave,
            fmt::format("slave {} has the alias {} as well", first->second, slave.alias));
      }
    }
    if (slave.device_id.value_or(0) != 0) {
      const auto [first, fresh] = ids_.emplace(*slave.device_id, slave.position);
      if (!fresh) {
        add(ErrorCode::kIdentification, slave,
            fmt::format("slave {} has the device ID {} as well", first->second, *slave.device_id));
      }
    }
    if (!slave.sii) return;
    if (!slave.sii->checksum_ok) add(ErrorCode::kSii, slave, "the checksum of the configuration area is wrong");
    if (slave.sii->checksum_ok && slave.sii->alias != slave.alias) {
      add(ErrorCode::kIdentification, slave,
          fmt::format("its EEPROM has the alias {}, the ESC has {} until the next power-on", slave.sii->alias,
                      slave.alias));
    }
  }

  /// What of a slave's device identification a look-only scan could not ask for.
  void scope(const ScannedSlave& slave) {
    const bool by_al_status = slave.sii && slave.sii->general && (slave.sii->general->flags & 0x08) != 0;
    if (!by_al_status || slave.device_id || (!scan_.look_only && scan_.running == 0)) return;
    add(ErrorCode::kScanScope, slave, "its device ID was not requested, which would write AL control");
  }

 private:
  BusScan& scan_;
  std::map<std::uint16_t, std::uint16_t> aliases_, ids_;
};

}  // namespace

void add_scan_findings(std::span<const SlaveWiring> wiring, BusScan& scan) {
  Findings findings(scan);
  for (std::size_t i = 0; i < scan.slaves.size(); ++i) {
    findings.wiring(scan.slaves[i], wiring[i]);
    findings.identification(scan.slaves[i]);
    findings.scope(scan.slaves[i]);
  }
}

}  // namespace syncline
