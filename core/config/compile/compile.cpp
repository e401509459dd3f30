// SPDX-License-Identifier: Apache-2.0
#include "config/compile/compile.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/compile/coe_init_cmds.h"
#include "config/compile/cyclic_frames.h"
#include "config/compile/dc_plan.h"
#include "config/compile/findings.h"
#include "config/compile/fmmu_plan.h"
#include "config/compile/hot_connect_plan.h"
#include "config/compile/mailbox_plan.h"
#include "config/compile/master_init_cmds.h"
#include "config/compile/pdo_assignment.h"
#include "config/compile/process_image.h"
#include "config/compile/slave_init_cmds.h"
#include "config/compile/variables.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

using namespace compiler;

constexpr Nanoseconds kMinCycle = 31'250;
constexpr Nanoseconds kMaxCycle = 100 * kMillisecond;
constexpr std::uint32_t kEcEngineerPollTimeMs = 10;
constexpr std::uint32_t kTwinCatPollTimeMs = 50;

std::vector<SlavePlan> plan_slaves(const Project& project) {
  std::vector<SlavePlan> plans;
  std::uint32_t status_bit = 0;
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    const SlaveSettings& settings = project.slaves[i];
    SlavePlan& plan = plans.emplace_back();
    plan.settings = &settings;
    plan.position = static_cast<std::uint16_t>(i);
    plan.pdos = effective_pdos(settings);
    plan.channels = process_data_channels(settings);
    plan.bit_oriented = is_bit_oriented(settings);
    plan.mailbox = plan_mailbox(settings.device);
    if (plan.mailbox && plan.mailbox->uses_status_bit) {
      plan.mailbox->status_bit = status_bit++;
    }
  }
  plan_dc(project, plans);
  return plans;
}

CyclicOptions cyclic_options(const DcMasterSettings& dc, const std::vector<SlavePlan>& plans, EniDialect dialect) {
  CyclicOptions options;
  options.dialect = dialect;
  options.slave_count = static_cast<std::uint16_t>(plans.size());
  if (dc.enabled && dc.reference_clock) {
    options.reference_clock = Position{*dc.reference_clock}.auto_increment_address();
  }
  options.bus_shift = steers_reference_clock(dc.dcm.mode);
  options.sync_window = dc.sync_window.enabled;
  options.system_time_64bit = dc.show_64bit_system_time;
  options.mailbox_state_count = static_cast<std::uint16_t>(std::ranges::count_if(
      plans, [](const SlavePlan& plan) { return plan.mailbox && plan.mailbox->uses_status_bit; }));
  return options;
}

/// Image bit at which the data of a placement start.
std::uint32_t image_bit(const Placement& at, const ImageLayout& image, const CyclicLayout& cyclic) {
  if (at.bits == 0) {
    return 0;
  }
  const std::uint32_t byte =
      cyclic.data_offsets[at.datagram] + at.logical_address - image.datagrams[at.datagram].logical_address;
  return byte * 8 + at.start_bit;
}

std::optional<ImageRange> image_range(const Placement& at, const ImageLayout& image, const CyclicLayout& cyclic) {
  return at.bits == 0 ? std::nullopt : std::optional(ImageRange{image_bit(at, image, cyclic), at.bits});
}

SlaveConfig slave_config(const SlavePlan& plan, Nanoseconds cycle, EniDialect dialect) {
  const SlaveSettings& settings = *plan.settings;
  SlaveConfig config;
  config.name = settings.name;
  config.station_address = settings.station_address;
  config.auto_increment_address = Position{plan.position}.auto_increment_address();
  config.alias = settings.alias;
  config.physics = settings.device.physics;
  config.identity = settings.device.identity;
  if (!settings.check.serial) {
    config.identity.serial_no = 0;
  }
  for (const auto& channel : plan.channels) {
    config.sync_managers.push_back({channel.number, channel.description, channel.pdos, {}});
  }
  config.pdos = plan.pdos;
  if (plan.mailbox) {
    config.mailbox =
        mailbox_config(plan, dialect == EniDialect::kEcEngineer ? kEcEngineerPollTimeMs : kTwinCatPollTimeMs);
    config.mailbox->coe_commands = coe_init_cmds(plan, cycle, dialect);
  }
  config.init_cmds = slave_init_cmds(plan, dialect);
  config.previous = settings.previous;
  config.dc = plan.dc;
  config.timeouts = settings.device.timeouts;
  return config;
}

MasterConfig master_config(const MasterSettings& settings, const std::vector<SlavePlan>& plans,
                           std::uint16_t mailbox_states) {
  MasterConfig config;
  config.name = settings.name;
  config.destination_mac = settings.destination_mac;
  config.source_mac = settings.source_mac;
  config.eoe = std::ranges::any_of(plans, [](const SlavePlan& plan) {
    return plan.mailbox && plan.device().mailbox && plan.device().mailbox->eoe;
  });
  if (mailbox_states > 0) {
    config.mailbox_state_count = mailbox_states;
  }
  config.init_cmds = master_init_cmds();
  return config;
}

void fill_image(NetworkConfig& config, const std::vector<SlavePlan>& plans, const ImageLayout& image,
                const CyclicLayout& cyclic) {
  std::vector<std::uint32_t> output_bits, input_bits;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    config.slaves[i].send = image_range(plans[i].outputs, image, cyclic);
    config.slaves[i].receive = image_range(plans[i].inputs, image, cyclic);
    output_bits.push_back(image_bit(plans[i].outputs, image, cyclic));
    input_bits.push_back(image_bit(plans[i].inputs, image, cyclic));
  }
  config.image.input_bytes = config.image.output_bytes = cyclic.image_bytes;
  config.image.command_data_offset = cyclic.command_data_offset;
  config.image.inputs = image_variables(plans, PdoDirection::kTx, input_bits);
  config.image.outputs = image_variables(plans, PdoDirection::kRx, output_bits);
}

Status check_buildable(const Project& project) {
  if (project.slaves.empty()) {
    return fail(ErrorCode::kConfiguration, "project", "it has no slaves");
  }
  constexpr std::size_t kMaxSlaves = 65'535;
  if (project.slaves.size() > kMaxSlaves) {
    return fail(ErrorCode::kConfiguration, "project", "more slaves than addresses");
  }
  const Nanoseconds cycle = project.master.cycle_time;
  if (cycle < kMinCycle || cycle > kMaxCycle) {
    return fail(ErrorCode::kBadValue, "master.cycle_time_us",
                fmt::format("{} ns is outside 31.25 us to 100 ms", cycle));
  }
  return {};
}

}  // namespace

Result<CompileResult> compile(const Project& project, const CompileOptions& options) {
  if (const auto buildable = check_buildable(project); !buildable) {
    return tl::unexpected(buildable.error());
  }
  std::vector<SlavePlan> plans = plan_slaves(project);
  CompileResult result;
  NetworkConfig& config = result.config;
  config.dc = run_time_dc(project, plans);
  config.recovery = project.master.recovery;
  config.real_time = project.master.real_time;
  const CyclicOptions cyclic_settings = cyclic_options(config.dc, plans, options.dialect);
  const ImageLayout image =
      layout_process_image(plans, {options.dialect, max_process_data_length(cyclic_settings),
                                   project.master.overlap_process_data});
  const CyclicLayout cyclic = cyclic_frames(image, cyclic_settings);

  for (SlavePlan& plan : plans) {
    plan.fmmus = plan_fmmus(plan);
    config.slaves.push_back(slave_config(plan, project.master.cycle_time, options.dialect));
    config.slaves.back().hot_connect = plan_hot_connect(project, plan.position);
  }
  config.master = master_config(project.master, plans, cyclic_settings.mailbox_state_count);
  if (config.dc.dcm.standard_loop_values) {
    std::erase_if(config.master.init_cmds, [](const InitCmd& command) {
      return command.ado == reg::kSpeedCounterStart || command.ado == reg::kFilterDepthDifference;
    });
  }
  config.cyclic.push_back({project.master.cycle_time, cyclic.frames, {}, {}, {}});
  fill_image(config, plans, image, cyclic);
  result.findings = find_problems(project, plans, config);
  return result;
}

}  // namespace syncline
