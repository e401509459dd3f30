// SPDX-License-Identifier: Apache-2.0
#include "eni/project/project_builder.h"

#include <fmt/format.h>

#include "channels/values/bus_scan.h"
#include "config/device_from_sii.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/project/line_wiring.h"
#include "eni/xml/file_warning.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "findings/scan_words.h"
#include "findings/sentence.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

/// About a slave and its identity.
template <FigureName... kNames>
Finding finding_at(
    std::type_identity_t<FindingSentence<words::kScan, FigureName("slave"), FigureName("identity"), kNames...>>
        sentence,
    const ScannedSlave& slave, Named<kNames>... figures) {
  return make_finding<words::kScan>(sentence, Place(slave.position), fig::slave<"slave">(slave.position),
                                    fig::text<"identity">(to_string(slave.identity)), std::move(figures)...);
}

/// Strings of an EEPROM are whatever somebody burnt into it; the project file must be able to carry them.
void clean(std::string& text) { text = std::string(trim(printable_text(text))); }

void clean_texts(DeviceDescription& device) {
  for (auto* text : {&device.vendor_name, &device.group_type, &device.type, &device.name}) clean(*text);
  for (auto* pdos : {&device.rx_pdos, &device.tx_pdos}) {
    for (Pdo& pdo : *pdos) {
      clean(pdo.name);
      for (PdoEntry& entry : pdo.entries) clean(entry.name);
    }
  }
  if (!device.dc) return;
  for (DcOpMode& mode : device.dc->op_modes) {
    clean(mode.name);
    clean(mode.description);
  }
}

DeviceDescription device_without_esi(const ScannedSlave& slave) {
  DeviceDescription device;
  if (slave.sii) {
    device = device_from_sii(*slave.sii);
    clean_texts(device);
    // The EEPROM says that the firmware knows complete access, nobody that a master may configure it in that way. Entry
    // by entry works with every slave.
    if (device.mailbox && device.mailbox->coe) device.mailbox->coe->complete_access = false;
  } else {
    device.type = "unknown";
    device.source = "SII";
  }
  device.identity = slave.identity;
  device.identity.serial_no = 0;
  return device;
}

DeviceDescription device_of(const ScannedSlave& slave, const EsiCatalogue& catalogue, std::vector<Finding>& warnings) {
  const auto match = catalogue.device_for(slave.identity);
  if (match) {
    if (match->kind != MatchKind::kExact) {
      warnings.push_back(finding_at("scan-other-revision", slave, fig::text<"match">(std::string(match->words)),
                                    fig::text<"file">(match->device->source)));
    }
    return *match->device;
  }
  if (match.error().code == ErrorCode::kUnknownDevice) {
    warnings.push_back(finding_at("scan-no-esi", slave));
  } else {
    warnings.push_back(finding_of(match.error()));  // there is one, and it cannot be read
  }
  if (slave.sii_error) warnings.push_back(finding_of(*slave.sii_error));
  return device_without_esi(slave);
}

/// The ESI says what the type can do, the scan what this one does.
void follow_hardware(SlaveSettings& slave, const ScannedSlave& scanned, std::vector<Finding>& warnings) {
  constexpr std::uint16_t kNoLogicalReadWrite = 0x0200;  // 0x0008 bit 9 (ESC data sheet II, ESC features supported)
  if ((scanned.features & kNoLogicalReadWrite) != 0) slave.device.use_lrd_lwr = true;
  const bool has_clock = scanned.dc == DcCapability::kSystemTime32 || scanned.dc == DcCapability::kSystemTime64;
  if (has_clock || slave.dc.op_mode.empty()) return;
  slave.dc.op_mode.clear();
  warnings.push_back(finding_at("scan-no-clock", scanned));
}

}  // namespace

BuiltProject project_from_scan(const BusScan& scan, const EsiCatalogue& catalogue) {
  BuiltProject built;
  built.warnings = scan.findings;
  for (const ScannedSlave& scanned : scan.slaves) {
    auto slave = default_slave(device_of(scanned, catalogue, built.warnings), scanned.position);
    slave.alias = scanned.alias;
    slave.previous = scanned.previous;
    follow_hardware(slave, scanned, built.warnings);
    built.project.slaves.push_back(std::move(slave));
  }
  return built;
}

Result<BuiltProject> project_from_scan(const BusScan& scan, const EsiCatalogue& catalogue,
                                       const SlaveDescriber& describe) {
  auto built = project_from_scan(scan, catalogue);
  if (!describe) return built;
  const auto unread = describe(built.project);
  if (!unread) return tl::unexpected(unread.error());
  for (const Error& error : *unread) built.warnings.push_back(finding_of(error));
  return built;
}

Result<Project> project_from_devices(const std::vector<Identity>& devices, const EsiCatalogue& catalogue) {
  Project project;
  for (const Identity& identity : devices) {
    const auto match = catalogue.device_for(identity);
    if (!match) return tl::unexpected(match.error());
    if (!match->exact_revision) {
      return fail(ErrorCode::kUnknownDevice, to_string(identity),
                  because("the ESI files have revision 0x{revision}",
                          fmt::format("{:08x}", match->device->identity.revision_no)));
    }
    project.slaves.push_back(default_slave(*match->device, static_cast<std::uint16_t>(project.slaves.size())));
  }
  wire_in_order(project.slaves);
  return project;
}

}  // namespace syncline::eni
