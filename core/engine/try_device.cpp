// SPDX-License-Identifier: Apache-2.0
#include "engine/try_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "channels/background_master.h"
#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "compare/network_compare.h"
#include "compile/compile.h"
#include "compile/effective_slave.h"
#include "config/project.h"
#include "config/sim_config.h"
#include "engine/background_master.h"
#include "engine/opened_link.h"
#include "engine/trial_files.h"
#include "families/device_family.h"
#include "families/families.h"
#include "findings/error_text.h"
#include "link/simulated_link.h"
#include "protocol/sdo_information.h"
#include "sim/sim_bus.h"
#include "support/clock.h"
#include "support/expected.h"

namespace syncline {
namespace {

constexpr Nanoseconds kLimit = 60 * kSecond;  // virtual time to reach OP
constexpr Nanoseconds kSlice = 20 * kMillisecond;
constexpr std::uint64_t kCycles = 50;  // in OP
constexpr const char* kExportedName = "exported.xml";

/// Where a try ended, and why.
struct Stop {
  TryOutcome outcome = TryOutcome::kFailed;
  TryStep step = TryStep::kCompile;
  std::string reason;
};
template <class T>
using Step = Expected<T, Stop>;

tl::unexpected<Stop> failed(TryStep step, std::string reason) {
  return tl::unexpected(Stop{TryOutcome::kFailed, step, std::move(reason)});
}

Project project_of(const DeviceDescription& device) {
  Project project;
  project.slaves.push_back(default_slave(device, 0));
  return project;
}

tl::unexpected<Stop> excepted(TryStep step, std::string reason) {
  return tl::unexpected(Stop{TryOutcome::kExcepted, step, std::move(reason)});
}

/// End caps, supplies and the like, which stand in ESI files for the drawing of cabinets.
std::string without_controller(const DeviceDescription& device) {
  const bool nothing = device.identity.product_code == 0 && device.sync_managers.empty() && device.fmmus.empty() &&
                       device.rx_pdos.empty() && device.tx_pdos.empty() && !device.mailbox && !device.dc;
  return nothing ? "it has no EtherCAT slave controller: on the bus there is nobody" : "";
}

/// Mailboxes without a size, or one in the other: impossible on any bus, whoever configures it.
std::string impossible_mailbox(const DeviceDescription& device) {
  struct Memory {
    std::uint32_t begin, end;
  };
  const auto has = [&](SyncManagerType type) {
    return std::ranges::find(device.sync_managers, type, &SyncManagerDescription::type) != device.sync_managers.end();
  };
  if (!has(SyncManagerType::kMailboxOut) || !has(SyncManagerType::kMailboxIn)) return {};
  std::vector<Memory> mailboxes;
  for (const auto& manager : device.sync_managers) {
    const bool mailbox = manager.type == SyncManagerType::kMailboxOut || manager.type == SyncManagerType::kMailboxIn;
    if (!mailbox) continue;
    const auto size = manager.default_size.value_or(manager.min_size.value_or(manager.max_size.value_or(0)));
    if (size == 0) return "the ESI gives the mailbox no size";
    const Memory memory{manager.start_address, manager.start_address + std::uint32_t{size}};
    for (const auto& other : mailboxes) {
      if (memory.begin >= other.end || other.begin >= memory.end) continue;
      return fmt::format("the ESI puts one mailbox (0x{:04x} to 0x{:04x}) into the other (0x{:04x} to 0x{:04x})",
                         memory.begin, memory.end - 1, other.begin, other.end - 1);
    }
    mailboxes.push_back(memory);
  }
  return {};
}

/// PDOs of the ESI's own assignment that do not fit into the SyncManager that the ESI gives them, alone or together;
/// whether a user could map less into them is no matter.
std::string oversize(const DeviceDescription& device) {
  for (std::size_t n = 0; n < device.sync_managers.size(); ++n) {
    const auto limit = device.sync_managers[n].max_size.value_or(0);
    for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
      const auto assigned = default_assignment(device, direction);
      std::uint32_t bits = 0;
      std::string pdos;
      for (const Pdo& pdo : device.pdos(direction)) {
        if (pdo.sync_manager != n || std::ranges::find(assigned, pdo.index) == assigned.end()) continue;
        bits += pdo.bit_length();
        pdos += fmt::format("{}0x{:04x}", pdos.empty() ? "" : ", ", pdo.index);
      }
      const auto bytes = (bits + 7) / 8;
      if (limit == 0 || bytes <= limit) continue;
      return fmt::format("the ESI assigns {} bytes (PDO {}) to SM{}, which takes {}", bytes, pdos, n, limit);
    }
  }
  return {};
}

/// Start-up commands of the ESI that empty the PDO assignment which the same ESI gives.
std::string emptied_assignment(const DeviceDescription& device) {
  if (!device.mailbox || !device.mailbox->coe) return {};
  for (const auto& command : device.mailbox->coe->init_commands) {
    const bool rx = command.index == 0x1C12, tx = command.index == 0x1C13;
    const bool empties = command.sub_index == 0 && !command.data.empty() && command.data[0] == 0;
    if (empties && (rx || tx) && !default_assignment(device, rx ? PdoDirection::kRx : PdoDirection::kTx).empty()) {
      return fmt::format("a start-up command of the ESI empties 0x{:04x}, to which the ESI assigns PDOs",
                         command.index);
    }
  }
  return {};
}

/// SyncManagers that are called inputs and written by the master, or the reverse: the ESC follows the control byte, the
/// master and the firmware follow the word, and no bus can serve both.
std::string turned_manager(const DeviceDescription& device) {
  constexpr std::uint8_t kDirection = 0x0C, kMasterWrites = 0x04;
  for (std::size_t n = 0; n < device.sync_managers.size(); ++n) {
    const auto& manager = device.sync_managers[n];
    const bool out = manager.type == SyncManagerType::kOutputs || manager.type == SyncManagerType::kMailboxOut;
    const bool in = manager.type == SyncManagerType::kInputs || manager.type == SyncManagerType::kMailboxIn;
    const bool written = (manager.control_byte & kDirection) == kMasterWrites;
    if (manager.is_virtual || (!out && !in) || written == out) continue;
    return fmt::format("the ESI calls SM{} {}, and its control byte 0x{:02x} makes it {}", n,
                       out ? "outputs" : "inputs", manager.control_byte, written ? "outputs" : "inputs");
  }
  return {};
}

Step<void> describable(const DeviceDescription& device) {
  for (const auto& check : {without_controller, impossible_mailbox, turned_manager, oversize, emptied_assignment}) {
    if (auto reason = check(device); !reason.empty()) return excepted(TryStep::kRead, std::move(reason));
  }
  return {};
}

Step<NetworkConfig> compiled(const Project& project) {
  auto result = compile(project);
  if (!result) return failed(TryStep::kCompile, describe(result.error()));
  const auto error = std::ranges::find(result->findings, Severity::kError, &Finding::severity);
  if (error != result->findings.end()) return failed(TryStep::kCompile, describe(*error));
  return std::move(result->config);
}

/// Structure and meaning of the exported file; notes and warnings are no failures.
Step<void> checked(const std::string& text, const TrialFiles& files) {
  const auto findings = files.check_eni(text, kExportedName);
  if (!findings) return failed(TryStep::kCheck, describe(findings.error()));
  const auto error = std::ranges::find(*findings, Severity::kError, &Finding::severity);
  if (error == findings->end()) return {};
  return failed(TryStep::kCheck, fmt::format("{}: {} (line {})", error->code, facts_text(*error), error->place.line));
}

/// The configuration as it stands in the exported file, which another master would get.
Step<NetworkConfig> exported(const NetworkConfig& config, const TrialFiles& files, const std::string& keep) {
  const auto text = files.eni_of(config);
  if (!keep.empty()) {
    if (auto saved = files.save_eni(config, keep); !saved) return failed(TryStep::kExport, describe(saved.error()));
  }
  auto again = files.read_eni(text, kExportedName);
  if (!again) return failed(TryStep::kExport, describe(again.error()));
  const auto differences = compare_networks(config, *again);
  if (!differences.empty()) return failed(TryStep::kExport, describe(differences.front()));
  if (auto fine = checked(text, files); !fine) return tl::unexpected(fine.error());
  return std::move(*again);
}

/// The device as its project configures it: with the modules in their slots.
SimConfig simulated(const SlaveSettings& slave) {
  SimConfig sim;
  auto& device = sim.slaves.emplace_back();
  device.name = slave.name;
  const auto effective = compiler::effective_slave(slave);
  device.device = effective ? effective->device : slave.device;
  device.behaviour = families::behaviour_of(device.device);
  device.oscillator.ppm = 3;
  if (slave.device.fmmu_count) device.fmmu_count = *slave.device.fmmu_count;
  if (slave.device.sync_manager_count) device.sync_manager_count = *slave.device.sync_manager_count;
  return sim;
}

/// What the samples of a run say.
struct Run {
  std::uint16_t wkc_expected = 0;
  std::uint64_t good = 0;  // cycles in OP one after the other
  std::optional<CycleSample> bad;

  void add(const CycleSample& sample) {
    if (sample.master_state != static_cast<std::uint8_t>(AlState::kOp)) return;
    wkc_expected = sample.wkc_expected;
    if (sample.wkc_received == sample.wkc_expected && (sample.flags & CycleSample::kFrameLost) == 0) {
      ++good;
    } else {
      bad = sample;
    }
  }
};

Step<Run> run(const NetworkConfig& config, const SimConfig& sim) {
  OpenedLink opened;
  opened.clock = std::make_unique<VirtualClock>();
  auto& clock = *opened.clock;
  auto bus = sim::SimBus::create(sim, clock.now());
  if (!bus) return failed(TryStep::kRun, describe(bus.error()));
  opened.link = make_simulated_link("sim", std::move(*bus), clock);
  const auto master = make_background_master(std::move(opened));
  auto& channels = master->channels();
  channels.commands.push(GoOnlineCommand{config, AlState::kOp});
  Run run;
  std::vector<CycleSample> samples;
  const auto end = clock.now() + kLimit;
  while (run.good < kCycles && clock.now() < end) {
    master->run_for(kSlice);
    for (const auto& event : channels.events.drain()) {
      if (const auto* failure = event.as<events::Failure>()) return failed(TryStep::kRun, describe(failure->error));
    }
    samples.clear();
    channels.samples.pop(samples);
    for (const auto& sample : samples) run.add(sample);
    if (run.bad) {
      return failed(TryStep::kRun, fmt::format("working counter {} instead of {} in OP", run.bad->wkc_received,
                                               run.bad->wkc_expected));
    }
  }
  if (run.good < kCycles) return failed(TryStep::kRun, "OP was not reached");
  return run;
}

Step<Run> all_steps(const DeviceDescription& device, const TrialFiles& files, const std::string& keep,
                    TriedDevice& tried) {
  if (auto sensible = describable(device); !sensible) return tl::unexpected(sensible.error());
  const auto project = project_of(device);
  tried.modules = static_cast<std::uint32_t>(project.slaves.front().modules.size());
  auto config = compiled(project);
  if (!config) return tl::unexpected(config.error());
  auto again = exported(*config, files, keep);
  if (!again) return tl::unexpected(again.error());
  return run(*again, simulated(project.slaves.front()));
}

}  // namespace

std::string_view outcome_name(TryOutcome outcome) {
  switch (outcome) {
    case TryOutcome::kPassed:
      return "passed";
    case TryOutcome::kExcepted:
      return "excepted";
    case TryOutcome::kFailed:
      return "failed";
  }
  return "";
}

std::string_view step_name(TryStep step) {
  switch (step) {
    case TryStep::kRead:
      return "read";
    case TryStep::kCompile:
      return "compile";
    case TryStep::kExport:
      return "export";
    case TryStep::kCheck:
      return "check";
    case TryStep::kRun:
      return "run";
    case TryStep::kDone:
      return "done";
  }
  return "";
}

TriedDevice try_device(const DeviceDescription& device, const TrialFiles& files, const std::string& keep) {
  TriedDevice tried{.file = device.source, .identity = device.identity, .type = device.type, .name = device.name};
  const auto run = all_steps(device, files, keep, tried);
  if (run) {
    tried.wkc_expected = run->wkc_expected;
    tried.cycles = run->good;
  } else {
    tried.outcome = run.error().outcome;
    tried.step = run.error().step;
    tried.reason = run.error().reason;
  }
  return tried;
}

}  // namespace syncline
