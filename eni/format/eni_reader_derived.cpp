// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/cyclic_frame.h"
#include "config/dcm_settings.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "eni/format/eni_reader.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

/// An ENI has no element for these; its commands say them.
namespace syncline::eni {
namespace {

/// Time-out of the check of `state` on a transition, as compile() derives the checks from the ESI's time-outs.
void derive_timeout(const SlaveConfig& slave, Transition transition, AlState state, std::uint32_t& timeout) {
  for (const InitCmd& cmd : slave.init_cmds) {
    if (has_transition(cmd, transition) && cmd.ado == reg::kAlStatus && cmd.validate && !cmd.validate->data.empty() &&
        al_state_of(cmd.validate->data.front()) == state) {
      timeout = cmd.validate->timeout_ms;
      return;
    }
  }
}

void derive_op_only(SlaveConfig& slave) {
  for (auto& manager : slave.sync_managers) {
    manager.description.op_only = std::ranges::any_of(slave.init_cmds, [&](const InitCmd& cmd) {
      return has_transition(cmd, Transition::kSO) && cmd.ado == reg::sync_manager(manager.number);
    });
  }
}

void derive_assign_activate(SlaveConfig& slave) {
  if (!slave.dc) {
    return;
  }
  for (const InitCmd& cmd : slave.init_cmds) {
    if (has_transition(cmd, Transition::kPS) && cmd.ado == reg::kCyclicUnitControl && cmd.data.size() >= 2) {
      slave.dc->assign_activate = load_le<std::uint16_t>(cmd.data);
    }
  }
}

/// Frames whose offsets advance like datagram headers on the wire come from a tool that counts headers.
bool counts_headers(const NetworkConfig& config) {
  bool any = false;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      if (frame.commands.empty()) {
        continue;
      }
      const CyclicCmd* previous = nullptr;
      for (const CyclicCmd& cmd : frame.commands) {
        const bool follows = previous
                                 ? cmd.input_offset == previous->input_offset + kDatagramOverhead + previous->length()
                                 : cmd.input_offset >= kFrameOverhead;
        if (!follows) {
          return false;
        }
        previous = &cmd;
      }
      any = true;
    }
  }
  return any;
}

std::optional<std::uint16_t> position_of(const NetworkConfig& config, std::uint16_t station_address) {
  const auto slave = std::ranges::find(config.slaves, station_address, &SlaveConfig::station_address);
  return slave == config.slaves.end() ? std::nullopt
                                      : std::optional(static_cast<std::uint16_t>(slave - config.slaves.begin()));
}

/// Mode and monitoring from the cyclic commands; the numbers behind them keep their defaults.
void derive_dc(NetworkConfig& config) {
  config.dc.enabled = false;
  config.dc.dcm.mode = DcmMode::kOff;
  bool bus_shift = false;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      for (const CyclicCmd& cmd : frame.commands) {
        const bool system_time = cmd.ado == reg::kSystemTime && !is_logical(cmd.command);
        if (system_time && (cmd.command == Command::kArmw || cmd.command == Command::kFrmw)) {
          config.dc.enabled = true;
          config.dc.show_64bit_system_time = cmd.length() == 8;
          config.dc.reference_clock = cmd.command == Command::kFrmw
                                          ? position_of(config, cmd.adp)
                                          : std::optional(static_cast<std::uint16_t>(0U - cmd.adp));
        } else if (system_time && (cmd.command == Command::kApwr || cmd.command == Command::kFpwr)) {
          bus_shift = true;
        } else if (cmd.ado == reg::kReceiveTimePort0 && cmd.command == Command::kBwr) {
          config.dc.continuous_propagation_compensation = true;
        } else if (cmd.ado == reg::kSystemTimeDifference &&
                   (cmd.command == Command::kBrd || cmd.command == Command::kFprd)) {
          config.dc.sync_window.enabled = true;
        }
      }
    }
  }
  // A tool may leave the distribution of the time to its own master: the slaves' SYNC commands say that there is one.
  const bool by_slaves = std::ranges::any_of(
      config.slaves, [](const SlaveConfig& slave) { return slave.dc && slave.dc->assign_activate != 0; });
  if (!config.dc.enabled && by_slaves) {
    config.dc.enabled = true;
    config.dc.reference_clock = config.reference_clock();
  } else if (config.dc.enabled) {
    config.dc.dcm.mode = bus_shift ? DcmMode::kBusShift : DcmMode::kMasterShift;
  }
}

/// ET9000 writes no CycleTime: the SYNC0 cycle is the best witness then.
void derive_cycle_time(NetworkConfig& config) {
  Nanoseconds otherwise = kMillisecond;
  for (const auto& slave : config.slaves) {
    if (slave.dc && slave.dc->cycle_time0 > 0) {
      otherwise = slave.dc->cycle_time0;
      break;
    }
  }
  for (auto& task : config.cyclic) {
    if (task.cycle_time <= 0) {
      task.cycle_time = otherwise;
    }
  }
}

}  // namespace

void derive_slave(SlaveConfig& slave) {
  derive_timeout(slave, Transition::kIP, AlState::kPreop, slave.timeouts.preop);
  derive_timeout(slave, Transition::kPS, AlState::kSafeop, slave.timeouts.safeop_op);
  derive_timeout(slave, Transition::kPI, AlState::kInit, slave.timeouts.back_to_init);
  derive_timeout(slave, Transition::kOS, AlState::kSafeop, slave.timeouts.back_to_safeop);
  derive_op_only(slave);
  derive_assign_activate(slave);
}

void derive_network(NetworkConfig& config, const std::vector<std::uint16_t>& previous_addresses) {
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    auto& previous = config.slaves[i].previous;
    const auto position = previous ? position_of(config, previous_addresses[i]) : std::nullopt;
    if (position) {
      previous->position = *position;
    } else {
      previous.reset();
    }
  }
  derive_cycle_time(config);
  derive_dc(config);
  config.image.command_data_offset = counts_headers(config) ? 10 : 0;
}

}  // namespace syncline::eni
