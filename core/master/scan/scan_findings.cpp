// SPDX-License-Identifier: Apache-2.0
#include "master/scan/scan_findings.h"

#include <map>
#include <utility>

#include "channels/values/bus_scan.h"
#include "findings/scan_words.h"
#include "findings/sentence.h"
#include "master/scan/topology.h"

namespace syncline {
namespace {

class Findings {
 public:
  explicit Findings(BusScan& scan) : scan_(scan) {}

  template <FigureName... kNames>
  void add(std::type_identity_t<FindingSentence<words::kScan, FigureName("slave"), kNames...>> sentence,
           const ScannedSlave& slave, Named<kNames>... figures) {
    scan_.findings.push_back(make_finding<words::kScan>(sentence, Place(slave.position),
                                                        fig::slave<"slave">(slave.position), std::move(figures)...));
  }

  void wiring(const ScannedSlave& slave, const SlaveWiring& wiring) {
    if (wiring.entry_port != 0) add("scan-wiring-entry", slave, fig::port<"port">(wiring.entry_port));
    if (!wiring.previous && !wiring.root) add("scan-wiring-place", slave);
    for (unsigned port = 0; port < kPortCount; ++port) {
      if (((wiring.unexplained_ports >> port) & 1U) != 0) {
        add("scan-wiring-open", slave, fig::port<"port">(port));
      } else if (slave.dl_status.physical_link(port) && !slave.dl_status.communication(port)) {
        add("scan-wiring-blocked", slave, fig::port<"port">(port));
      }
    }
  }

  void identification(const ScannedSlave& slave) {
    if (slave.alias != 0) {
      const auto [first, fresh] = aliases_.emplace(slave.alias, slave.position);
      if (!fresh) add("scan-alias-twice", slave, fig::number<"alias">(slave.alias), fig::slave<"other">(first->second));
    }
    if (slave.device_id.value_or(0) != 0) {
      const auto [first, fresh] = ids_.emplace(*slave.device_id, slave.position);
      if (!fresh)
        add("scan-device-id-twice", slave, fig::number<"id">(*slave.device_id), fig::slave<"other">(first->second));
    }
    if (!slave.sii) return;
    if (!slave.sii->checksum_ok) add("scan-eeprom-checksum", slave);
    if (slave.sii->checksum_ok && slave.sii->alias != slave.alias) {
      add("scan-alias-not-taken", slave, fig::number<"written">(slave.sii->alias), fig::number<"taken">(slave.alias));
    }
  }

  /// What of a slave's device identification a look-only scan could not ask for.
  void scope(const ScannedSlave& slave) {
    const bool by_al_status = slave.sii && slave.sii->general && (slave.sii->general->flags & 0x08) != 0;
    if (!by_al_status || slave.device_id || (!scan_.look_only && scan_.running == 0)) return;
    add("scan-device-id-unread", slave);
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
