// SPDX-License-Identifier: Apache-2.0
#include "compile/compilation.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/dc_plan.h"
#include "compile/effective_slave.h"
#include "compile/fmmu_plan.h"
#include "compile/hot_connect_plan.h"
#include "compile/mailbox_plan.h"
#include "compile/master_findings.h"
#include "compile/pdo_assignment.h"
#include "compile/slave_config.h"
#include "compile/slave_findings.h"
#include "compile/task_plan.h"
#include "compile/variables.h"
#include "config/project.h"
#include "config/sync_unit_cycle.h"
#include "config/task_settings.h"
#include "reasons/because.h"
#include "settings/setting.h"
#include "settings/settings_table.h"

namespace syncline::compiler {
namespace {

/// What the slave's own settings decide.
SlavePlan plan_slave(const SlaveSettings& settings, std::size_t position, bool bit_packing) {
  SlavePlan plan;
  plan.effective = effective_slave(settings);
  plan.settings = plan.effective ? plan.effective.get() : &settings;
  plan.position = static_cast<std::uint16_t>(position);
  plan.pdos = effective_pdos(*plan.settings);
  plan.channels = process_data_channels(*plan.settings);
  plan.bit_oriented = bit_packing && is_bit_oriented(*plan.settings);
  plan.mailbox = plan_mailbox(plan.device());
  if (plan.mailbox && !settings.mailbox.state_bit) plan.mailbox->uses_status_bit = false;
  return plan;
}

CyclicOptions cyclic_options(const DcMasterSettings& dc, const std::vector<SlavePlan>& plans,
                             const ImageOptions& image) {
  CyclicOptions options;
  options.dialect = image.dialect;
  options.logical_base = image.logical_base();
  options.slave_count = static_cast<std::uint16_t>(plans.size());
  if (dc.enabled && dc.reference_clock) {
    options.reference_clock = Position{*dc.reference_clock}.auto_increment_address();
  }
  options.bus_shift = steers_reference_clock(dc.dcm.mode);
  options.sync_window = dc.sync_window.enabled;
  options.system_time_64bit = dc.show_64bit_system_time;
  options.latch_receive_times = dc.continuous_propagation_compensation;
  options.mailbox_state_count = static_cast<std::uint16_t>(std::ranges::count_if(
      plans, [](const SlavePlan& plan) { return plan.mailbox && plan.mailbox->uses_status_bit; }));
  return options;
}

/// Image bit at which the data of a placement start.
std::uint32_t image_bit(const Placement& at, const ImageLayout& image, const CyclicLayout& cyclic) {
  if (at.bits == 0) return 0;
  const std::uint32_t byte =
      cyclic.data_offsets[at.datagram] + at.logical_address - image.datagrams[at.datagram].logical_address;
  return byte * 8 + at.start_bit;
}

std::optional<ImageRange> image_range(const Placement& at, std::uint32_t bit) {
  return at.bits == 0 ? std::nullopt : std::optional(ImageRange{bit, at.bits, 0});
}

}  // namespace

bool Compilation::Shared::operator==(const Shared& other) const {
  // The datagram's number moves the data in the image, not in the slave.
  const auto same = [](const Placement& a, const Placement& b) {
    return a.bits == b.bits && a.logical_address == b.logical_address && a.start_bit == b.start_bit;
  };
  return same(outputs, other.outputs) && same(inputs, other.inputs) && dc == other.dc &&
         status_bit == other.status_bit && cycle_time == other.cycle_time;
}

void Compilation::plan_slaves(const Project& project, const Changes& changes) {
  plans_.resize(project.slaves.size());
  std::uint32_t status_bit = 0;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    SlavePlan& plan = plans_[i];
    if (changes.master || changes.slave(i)) {
      plan = plan_slave(project.slaves[i], i, project.master.image.bit_packing);
    } else if (!plan.effective) {
      plan.settings = &project.slaves[i];
    }
    plan.outputs = plan.inputs = Placement{};
    plan.dc.reset();
    if (plan.mailbox && plan.mailbox->uses_status_bit) plan.mailbox->status_bit = status_bit++;
  }
}

void Compilation::plan_together(const Project& project, const CompileOptions& options) {
  plan_tasks(project, plans_);
  plan_dc(project, plans_);
  NetworkConfig& config = result_.config;
  config.dc = run_time_dc(project, plans_);
  const ProcessImageSettings& wanted = project.master.image;
  ImageOptions image_options{
      options.dialect,           0, project.master.overlap_process_data, wanted.alignment, wanted.logical_start,
      unit_tasks(project.master)};
  cyclic_options_ = cyclic_options(config.dc, plans_, image_options);
  image_options.max_length = max_process_data_length(cyclic_options_);
  image_ = layout_process_image(plans_, image_options);
  cyclic_ = cyclic_frames(image_, cyclic_options_);
}

void Compilation::configure(const Project& project, const CompileOptions& options, const Changes& changes) {
  const std::size_t known = shared_.size();
  auto& configs = result_.config.slaves;
  configs.resize(plans_.size());
  shared_.resize(plans_.size());
  slave_findings_.resize(plans_.size());
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    SlavePlan& plan = plans_[i];
    const bool has_bit = plan.mailbox && plan.mailbox->uses_status_bit;
    Shared shared{plan.outputs, plan.inputs, plan.dc, has_bit ? std::optional(plan.mailbox->status_bit) : std::nullopt,
                  plan.cycle_time};
    if (changes.master || changes.slave(i) || i >= known || !(shared == shared_[i])) {
      plan.fmmus = plan_fmmus(plan);
      configs[i] = slave_config(plan, options.dialect);
      slave_findings_[i].clear();
      find_slave_problems(slave_findings_[i], plan, configs[i]);
    }
    configs[i].hot_connect = plan_hot_connect(project, i);
    shared_[i] = shared;
  }
}

void Compilation::fill_image() {
  NetworkConfig& config = result_.config;
  std::vector<std::uint32_t> output_bits, input_bits;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    output_bits.push_back(image_bit(plans_[i].outputs, image_, cyclic_));
    input_bits.push_back(image_bit(plans_[i].inputs, image_, cyclic_));
    config.slaves[i].send = image_range(plans_[i].outputs, output_bits.back());
    config.slaves[i].receive = image_range(plans_[i].inputs, input_bits.back());
  }
  config.image.input_bytes = config.image.output_bytes = cyclic_.image_bytes;
  config.image.command_data_offset = cyclic_.command_data_offset;
  config.image.inputs = image_variables(plans_, PdoDirection::kTx, input_bits);
  config.image.outputs = image_variables(plans_, PdoDirection::kRx, output_bits);
}

void Compilation::collect_findings(const Project& project) {
  result_.findings.clear();
  find_master_problems(result_.findings, project, plans_, result_.config);
  for (const auto& findings : slave_findings_) {
    result_.findings.insert(result_.findings.end(), findings.begin(), findings.end());
  }
}

void Compilation::run(const Project& project, const CompileOptions& options, const Changes& changes) {
  plan_slaves(project, changes);
  plan_together(project, options);
  configure(project, options, changes);
  NetworkConfig& config = result_.config;
  config.recovery = project.master.recovery;
  config.real_time = project.master.real_time;
  config.frmw_unknown = std::ranges::any_of(
      project.slaves, [](const SlaveSettings& slave) { return slave.device.dc && slave.device.dc->unknown_frmw; });
  config.master = master_config(project.master, plans_, config.dc, cyclic_options_.mailbox_state_count);
  config.cyclic = cyclic_tasks(project.master, cyclic_);
  fill_image();
  collect_findings(project);
}

Status check_buildable(const Project& project) {
  if (project.slaves.empty()) {
    return fail(ErrorCode::kConfiguration, "project", because("it has no slaves"));
  }
  constexpr std::size_t kMaxSlaves = 65'535;
  if (project.slaves.size() > kMaxSlaves) {
    return fail(ErrorCode::kConfiguration, "project", because("more slaves than addresses"));
  }
  return settings::check_number(settings::row("master.cycle_time_us"), project, {});
}

}  // namespace syncline::compiler
