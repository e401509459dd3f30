// SPDX-License-Identifier: Apache-2.0
#include "compile/slave_findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/coe_init_cmds.h"
#include "compile/family_findings.h"
#include "compile/finding_list.h"
#include "compile/fmmu_plan.h"
#include "compile/module_findings.h"
#include "compile/pdo_findings.h"
#include "compile/slave_plan.h"
#include "config/dc_description.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"
#include "config/startup_messages.h"
#include "config/startup_origin.h"
#include "config/sync0_cycle.h"
#include "protocol/assign_activate.h"
#include "protocol/frame.h"
#include "protocol/mailbox.h"
#include "settings/limits.h"
#include "settings/predicates.h"

namespace syncline::compiler {
namespace {

void check_memory(FindingList& findings, const SlavePlan& slave) {
  const auto fmmus = plan_fmmus(slave).size();
  const auto available = slave.device().fmmus.size();
  if (available > 0 && fmmus > available) {
    findings.add("fmmus-missing", fig::count<"fmmus">(fmmus), fig::count<"available">(available));
  }
  const std::uint32_t bytes =
      (std::max(slave.image_bits(PdoDirection::kRx), slave.image_bits(PdoDirection::kTx)) + 7) / 8;
  if (bytes > kMaxDatagramData) {
    findings.add("process-data-too-long/frame", fig::count<"bytes">(bytes));
  }
}

void check_hot_connect(FindingList& findings, const SlavePlan& slave) {
  const auto& settings = *slave.settings;
  if (settings.hot_connect.empty() && !settings.optional) return;
  const char* key = settings.hot_connect.empty() ? "optional" : "hot_connect";
  const char* who = settings.hot_connect.empty() ? "An optional slave" : "The first slave of a hot-connect group";
  if (settings.alias == 0 && !settings.check.device_id) {
    findings.add("alias-missing", fig::phrase<"who">(who));
  }
  if (slave.position == 0) {
    findings.add_at(key, "optional-first", fig::phrase<"who">(who));
  }
}

void check_device_id(FindingList& findings, const SlavePlan& slave) {
  const auto& device = slave.device();
  if (slave.settings->check.device_id && !device.identification_ado && !device.identification_reg134) {
    findings.add("device-id-unknown");
  }
}

/// 0 stands for any number (Identity), so that there would be nothing to compare.
void check_serial(FindingList& findings, const SlavePlan& slave) {
  if (slave.settings->check.serial && slave.device().identity.serial_no == 0) findings.add("serial-unknown");
}

void check_eoe(FindingList& findings, const SlavePlan& slave) {
  const auto& eoe = slave.settings->eoe;
  const bool wanted = eoe.mac || !eoe.ip.empty() || !eoe.subnet.empty() || !eoe.gateway.empty() || !eoe.dns.empty() ||
                      !eoe.host_name.empty();
  const bool able = slave.device().mailbox && slave.device().mailbox->eoe;
  if (wanted && !able) findings.add("eoe-missing");
  if (!slave.settings->ams_net_id.empty() && !(slave.device().mailbox && slave.device().mailbox->aoe)) {
    findings.add("aoe-missing");
  }
}

/// (divider + 2) * 40 ns times the watchdog's value: how long outputs may stay away.
void check_watchdog(FindingList& findings, const SlavePlan& slave) {
  constexpr std::uint32_t kUsualDivider = 2498;  // 100 us, after reset
  constexpr std::uint32_t kUsualTime = 1000;     // 100 ms
  const auto& device = slave.device();
  const bool triggered = std::ranges::any_of(slave.channels, [](const ProcessDataChannel& channel) {
    return channel.is_output() && channel.bit_length > 0 && (channel.description.control_byte & 0x40) != 0;
  });
  const std::uint32_t count = device.reg_0420 ? *device.reg_0420 : kUsualTime;
  if (!triggered || count == 0) return;
  const Nanoseconds unit = (Nanoseconds{device.reg_0400 ? *device.reg_0400 : kUsualDivider} + 2) * 40;
  if (const Nanoseconds time = unit * count; time <= slave.cycle_time * 2) {
    findings.add("watchdog-too-short", fig::time<"time">(time), fig::time<"cycle">(slave.cycle_time));
  }
}

/// What the user took away: devices whose makers left it out have reasons for it.
void check_outputs_guarded(FindingList& findings, const SlavePlan& slave) {
  const bool outputs = std::ranges::any_of(
      slave.channels, [](const ProcessDataChannel& channel) { return channel.is_output() && channel.bit_length > 0; });
  if (!outputs) return;
  const WatchdogSettings& user = slave.settings->watchdog;
  if (user.outputs == false) {
    findings.add_at("watchdog.outputs", "outputs-stay/trigger");
  } else if (user.process_data == 0U) {
    findings.add("outputs-stay");
  }
}

void check_mailbox(FindingList& findings, const SlavePlan& slave) {
  constexpr std::uint16_t kMailboxHeader = 6;
  if (slave.device().mailbox && !slave.mailbox) {
    findings.add("mailbox-without-sync-managers");
  } else if (slave.mailbox &&
             (slave.mailbox->out.length <= kMailboxHeader || slave.mailbox->in.length <= kMailboxHeader)) {
    findings.add("mailbox-without-size");
  }
}

/// A message goes in one piece: what is longer than the mailbox the slave never gets.
void check_messages(FindingList& findings, const SlavePlan& slave) {
  if (!slave.mailbox || slave.mailbox->out.length <= MailboxMessage::kHeaderSize) return;
  const std::size_t most = slave.mailbox->out.length - MailboxMessage::kHeaderSize;
  for (const auto& protocol : kMessageProtocols) {
    const auto& messages = slave.settings->*protocol.startup;
    for (std::size_t k = 0; k < messages.size(); ++k) {
      const auto size = messages[k].data.size();
      if (!messages[k].enabled || size <= most) continue;
      findings.add_at(fmt::format("{}.startup.{}", protocol.key, k), "startup-message-too-long",
                      fig::count<"bytes">(size), fig::count<"most">(most));
    }
  }
}

void check_sync_units(FindingList& findings, const DcOpMode& mode, const DcTimes& times, Nanoseconds bus_cycle) {
  if (!times.exact) {
    findings.add("sync-cycle-inexact");
  }
  const AssignActivate activate{mode.assign_activate};
  if (activate.sync0() && times.cycle_time0 <= 0) {
    findings.add("sync0-cycle-impossible", fig::text<"mode">(mode.name), fig::time<"cycle">(times.cycle_time0));
  } else if (activate.sync0() && !settings::keeps_step(times.cycle_time0, bus_cycle)) {
    findings.add("sync0-out-of-step", fig::time<"sync0">(times.cycle_time0), fig::time<"cycle">(bus_cycle));
  }
  if (times.cycle_time1 < 0) {
    findings.add("sync1-before-sync0", fig::time<"time">(-times.cycle_time1));
  }
  if (activate.sync0() && times.cycle_time0 > 0 && !settings::within_period(times.shift_time, times.cycle_time0)) {
    findings.add("sync0-shift-beyond-cycle", fig::time<"shift">(times.shift_time),
                 fig::time<"cycle">(times.cycle_time0));
  }
}

void check_sync_times(FindingList& findings, const DcTimes& times) {
  const auto most = fig::time<"most">(limits::kLargestSyncTime);
  if (!settings::is_sync_time(times.cycle_time0)) {
    findings.add("sync-time-too-long", fig::time<"time">(times.cycle_time0), most);
  }
  if (!settings::is_sync_time(times.cycle_time1)) {
    findings.add_at("dc.sync1.cycle_us", "sync-time-too-long/sync1", fig::time<"time">(times.cycle_time1), most);
  }
  if (!settings::is_sync_time(times.shift_time)) {
    findings.add_at("dc.sync0.shift_us", "sync-time-too-long/shift", fig::time<"time">(times.shift_time), most);
  }
}

/// The setting of a SYNC unit that is not auto, "" where all are.
std::string set_of_unit(const SyncUnitSettings& unit, const char* name) {
  const char* part = unit.cycle_factor ? "factor" : unit.user_cycle ? "cycle_us" : unit.shift ? "shift_us" : "";
  return *part == 0 ? std::string() : fmt::format("dc.{}.{}", name, part);
}

/// The ENI is the same with and without these settings.
void check_unused_units(FindingList& findings, const DcSlaveSettings& user, const DcOpMode* mode) {
  const auto sync0 = set_of_unit(user.sync0, "sync0"), sync1 = set_of_unit(user.sync1, "sync1");
  if (user.op_mode.empty()) {
    if (!sync0.empty()) findings.add_at(sync0, "sync-settings-unused/off", fig::text<"signal">("SYNC0"));
    if (!sync1.empty()) findings.add_at(sync1, "sync-settings-unused/off", fig::text<"signal">("SYNC1"));
  } else if (mode != nullptr && !sync1.empty() && !AssignActivate{mode->assign_activate}.sync1()) {
    findings.add_at(sync1, "sync-settings-unused", fig::text<"signal">("SYNC1"), fig::text<"mode">(mode->name));
  }
}

void check_dc(FindingList& findings, const SlavePlan& slave) {
  const DcSlaveSettings& user = slave.settings->dc;
  const DcOpMode* mode = selected_op_mode(*slave.settings);
  if (slave.device().dc) check_unused_units(findings, user, mode);
  if (user.op_mode.empty()) {
    return;
  }
  if (mode == nullptr) {
    findings.add("operation-mode-missing", fig::text<"mode">(user.op_mode));
  } else if (slave.dc_commands()) {
    DcTimes times = dc_times(*mode, user, slave.cycle_time);
    if (slave.dc) times.shift_time = slave.dc->shift_time;  // with the master's input shift where it counts
    check_sync_units(findings, *mode, times, slave.cycle_time);
    check_sync_times(findings, times);
  }
}

void check_interpolation_time(FindingList& findings, const SlavePlan& slave) {
  if (interpolation_time(slave.cycle_time)) {
    return;
  }
  const auto& startup = slave.settings->startup;
  for (std::size_t k = 0; k < startup.size(); ++k) {
    if (startup[k].index == kInterpolationTimePeriod && is_from_esi(startup[k], slave.device())) {
      findings.add_at(fmt::format("startup.{}", k), "interpolation-time-inexact", fig::time<"cycle">(slave.cycle_time));
    }
  }
}

void check_topology(FindingList& findings, const SlavePlan& slave) {
  // What the others must be known for: master_findings.
  if (!slave.settings->previous && slave.position > 0) {
    findings.add("wiring-unknown");
  }
}

}  // namespace

void find_slave_problems(std::vector<Finding>& out, const SlavePlan& slave, const SlaveConfig& config) {
  FindingList findings(out, slave.position);
  find_pdo_problems(findings, slave);
  check_memory(findings, slave);
  find_module_problems(findings, slave);
  check_hot_connect(findings, slave);
  check_device_id(findings, slave);
  check_serial(findings, slave);
  check_watchdog(findings, slave);
  check_outputs_guarded(findings, slave);
  check_eoe(findings, slave);
  check_mailbox(findings, slave);
  check_messages(findings, slave);
  check_dc(findings, slave);
  find_family_problems(findings, slave, config);
  check_interpolation_time(findings, slave);
  check_topology(findings, slave);
}

}  // namespace syncline::compiler
