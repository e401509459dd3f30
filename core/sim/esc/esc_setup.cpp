// SPDX-License-Identifier: Apache-2.0
#include "config/port_kind.h"
#include "protocol/dl_status.h"
#include "protocol/port_descriptor.h"
#include "protocol/registers.h"
#include "protocol/station_alias.h"
#include "sim/esc/esc.h"

/// What an ESC has after power-on: registers with their rights, features, configuration from the SII.
namespace syncline::sim {
namespace {

// Bits of 0x0008. 0x0100: 0x0981 bits 7..3 and 0x0984.
constexpr std::uint16_t kEnhancedSyncActivation = 0x0100, kNoLogicalReadWrite = 0x0200, kNoPhysicalReadWrite = 0x0400;

/// 0x0007. A device that does not say what its ports are has all four.
std::uint8_t port_descriptors(const DeviceDescription& device) {
  unsigned value = 0;
  for (std::uint8_t port = 0; port < kPortCount; ++port) {
    auto what = PortDescriptor::kMii;
    if (!device.physics.empty()) {
      const auto kind = port_kind(device, port);
      if (kind == PortKind::kEbus) what = PortDescriptor::kEbus;
      if (kind == PortKind::kNone) what = PortDescriptor::kNone;
    }
    value |= port_descriptor_bits(what, port);
  }
  return static_cast<std::uint8_t>(value);
}

}  // namespace

Esc::Esc(const SimSlaveConfig& config, std::vector<std::uint8_t> sii, const Options& options, Nanoseconds power_on,
         std::uint64_t seed)
    : options_(options),
      memory_(0x400U * options.ram_kbytes),
      ports_(memory_),
      dc_(config.oscillator, config.dc, power_on, seed, memory_),
      watchdog_(memory_),
      managers_(memory_, options.sync_manager_count),
      sii_(std::move(sii), config.sii, memory_),
      pdi_watchdog_(memory_),
      al_(memory_),
      planner_(memory_, managers_, fmmus_, protection_, addresses_, options.logical_read_write),
      fmmus_(memory_, managers_, protection_, dc_, options.fmmu_count),
      addresses_(memory_),
      requests_(memory_),
      protection_(memory_),
      reset_(memory_) {
  implement_registers();
  load_configuration();
  std::uint16_t features = 0;  // FMMUs map bits
  if (config.dc.receive_times) features |= 0x0004;
  if (config.dc.is_64bit) features |= 0x0008;
  if (config.dc.system_time) features |= kEnhancedSyncActivation;
  memory_.set<std::uint8_t>(reg::kType, config.esc_type);
  memory_.set<std::uint8_t>(reg::kFmmuCount, options.fmmu_count);
  memory_.set<std::uint8_t>(reg::kSyncManagerCount, options.sync_manager_count);
  memory_.set<std::uint8_t>(reg::kRamSize, options.ram_kbytes);
  memory_.set<std::uint8_t>(reg::kPortDescriptor, port_descriptors(config.device));
  if (!options.logical_read_write) features |= kNoLogicalReadWrite;
  if (!options.physical_read_write) features |= kNoPhysicalReadWrite;
  memory_.set<std::uint16_t>(reg::kFeatures, features);
  memory_.set<std::uint16_t>(reg::kWatchdogDivider, 2498);
  memory_.set<std::uint16_t>(reg::kWatchdogStatus, 1);
}

void Esc::implement_registers() {
  memory_.implement(reg::kType, 10, EscMemory::kRead);
  memory_.implement(reg::kPdiControl, 2, EscMemory::kRead);
  memory_.implement(reg::kPdiConfiguration, 4, EscMemory::kRead);
  memory_.implement(reg::kWatchdogDivider, 2, EscMemory::kReadWrite);  // of both watchdogs
  memory_.implement(reg::kWatchdogStatus, 2, EscMemory::kRead);
  memory_.implement(reg::kWatchdogCounterProcessData, 2, EscMemory::kReadWrite);
  memory_.implement(reg::kDigitalOutputs, 4, EscMemory::kReadWrite);
  memory_.implement(reg::kUserRam, 0x80, EscMemory::kReadWrite);
  addresses_.implement_registers();
  protection_.implement_registers();
  reset_.implement_registers();
  ports_.implement_registers();
  al_.implement_registers();
  requests_.implement_registers();
  watchdog_.implement_registers();
  pdi_watchdog_.implement_registers();
  sii_.implement_registers();
  fmmus_.implement_registers();
  managers_.implement_registers();
}

void Esc::load_configuration() {
  const auto& content = sii_.content();
  if (!sii_.checksum_ok()) return;
  memory_.set<std::uint8_t>(reg::kPdiControl, content[0]);
  memory_.set<std::uint8_t>(reg::kEscConfiguration, content[1]);
  memory_.set<std::uint16_t>(reg::kPdiConfiguration, load_le<std::uint16_t>(std::span(content).subspan(2)));
  memory_.set<std::uint16_t>(reg::kPulseLength, load_le<std::uint16_t>(std::span(content).subspan(4)));
  memory_.set<std::uint16_t>(reg::kStationAlias, load_le<std::uint16_t>(std::span(content).subspan(kSiiAliasByte)));
}

}  // namespace syncline::sim
