// SPDX-License-Identifier: Apache-2.0
#include "compile/coe_init_cmds.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/slave_plan.h"
#include "compile/sync_init_cmds.h"
#include "config/dc_description.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"
#include "config/startup_origin.h"
#include "config/sync0_cycle.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

constexpr std::uint16_t kSyncManagerPdoAssign = 0x1C10;  // + SyncManager
constexpr std::uint16_t kSyncManagerParameter = 0x1C30;  // + SyncManager
constexpr std::uint16_t kModuleIdentList = 0xF030;

using Bytes = std::vector<std::uint8_t>;

CoeInitCmd generated(std::uint16_t index, std::uint8_t sub_index, Bytes data, std::string comment) {
  CoeInitCmd cmd;
  cmd.command.index = index;
  cmd.command.sub_index = sub_index;
  cmd.command.data = std::move(data);
  cmd.command.fixed = true;
  cmd.command.comment = std::move(comment);
  return cmd;
}

class CoeList {
 public:
  CoeList(const SlavePlan& slave, const CoeDescription& coe, EniDialect dialect)
      : slave_(slave), coe_(coe), dialect_(dialect) {}

  /// Configured module ident list: the device compares it with what is plugged, or takes its shape from it.
  void add_module_idents() {
    const auto& device = slave_.device();
    if (!device.slots || !(device.slots->download_ident_list || device.download_module_list)) return;
    std::vector<std::uint32_t> idents;
    for (const PluggedModule& module : slave_.settings->modules) {
      idents.resize(std::max<std::size_t>(idents.size(), module.slot + 1U));
      idents[module.slot] = module.ident;
    }
    const std::size_t first = out_.size();
    if (coe_.complete_access) {
      Bytes data;
      ByteWriter writer(data);
      writer.u16(static_cast<std::uint16_t>(idents.size()));
      for (const std::uint32_t ident : idents) writer.u32(ident);
      out_.push_back(generated(kModuleIdentList, 0, std::move(data), "list of modules"));
      out_.back().command.complete_access = true;
    } else {
      out_.push_back(generated(kModuleIdentList, 0, {0}, "clear list of modules"));
      for (std::size_t i = 0; i < std::min<std::size_t>(idents.size(), 254); ++i) {
        out_.push_back(generated(kModuleIdentList, static_cast<std::uint8_t>(i + 1), le_bytes(idents[i]),
                                 fmt::format("module in place {}", i)));
      }
      out_.push_back(generated(kModuleIdentList, 0,
                               {static_cast<std::uint8_t>(std::min<std::size_t>(idents.size(), 254))},
                               "number of modules"));
    }
    const auto when = transition_from_name(device.slots->download_transition).value_or(Transition::kPS);
    for (std::size_t i = first; i < out_.size(); ++i) out_[i].command.transitions = {when};
  }

  void add_clear_assignment() {
    // One complete access replaces the whole object, so ET9000 leaves the clear out; EC-Engineer keeps it.
    if (!coe_.pdo_assign || (coe_.complete_access && dialect_ == EniDialect::kTwinCat)) {
      return;
    }
    for (const auto& channel : slave_.channels) {
      if (channel.is_virtual()) continue;  // has no object
      const auto index = assign_object(channel);
      out_.push_back(generated(index, 0, {0}, fmt::format("clear PDO assignment 0x{:04X}", index)));
    }
  }

  void add_mappings() {
    if (!coe_.pdo_config) {
      return;
    }
    for (const auto& [direction, pdo] : slave_.pdos) {
      if (!pdo.fixed) {
        coe_.complete_access ? add_mapping_at_once(pdo) : add_mapping(pdo);
      }
    }
  }

  void add_assignment() {
    if (!coe_.pdo_assign) {
      return;
    }
    for (const auto& channel : slave_.channels) {
      if (!channel.pdos.empty() && !channel.is_virtual()) {
        coe_.complete_access ? add_assignment_at_once(channel) : add_assignment_of(channel);
      }
    }
  }

  /// The op mode's SyncType, unless the object dictionary says that the slave sets it itself.
  void add_sync_types() {
    const DcOpMode* mode = slave_.dc_commands() ? selected_op_mode(*slave_.settings) : nullptr;
    if (mode == nullptr) {
      return;
    }
    for (const auto& manager : mode->sync_managers) {
      const auto index = static_cast<std::uint16_t>(kSyncManagerParameter + manager.number);
      if (manager.sync_type && !slave_.settings->sync.type && !is_read_only(index, 1)) {
        out_.push_back(generated(index, 1, le_bytes(*manager.sync_type),
                                 fmt::format("set synchronisation type of SM {}", manager.number)));
      }
      add_time(index, 2, manager.cycle_time, "cycle time", manager.number);
      add_time(index, 3, manager.shift_time, "shift time", manager.number);
    }
  }

  /// Sm/CycleTime and Sm/ShiftTime of the op mode: a value, else a factor of the cycle (below 0 divides).
  void add_time(std::uint16_t index, std::uint8_t sub_index, const std::optional<OpModeTime>& time, const char* what,
                std::uint8_t manager) {
    if (!time || is_read_only(index, sub_index)) return;
    constexpr std::int64_t kLargestFactor = 1'000'000;  // a file may say any number
    const auto factor = std::clamp<std::int64_t>(time->factor.value_or(0), -kLargestFactor, kLargestFactor);
    const Nanoseconds scaled = factor >= 0 ? factor * slave_.cycle_time : slave_.cycle_time / -factor;
    const Nanoseconds value = time->value_ns != 0 ? time->value_ns : scaled;
    if (value <= 0 || value > 0xFFFF'FFFF) return;
    out_.push_back(generated(index, sub_index, le_bytes(static_cast<std::uint32_t>(value)),
                             fmt::format("set {} of SM {}", what, manager)));
  }

  void add_startup(Nanoseconds bus_cycle) {
    const auto& startup = slave_.settings->startup;
    const auto period = interpolation_time(bus_cycle);
    const bool has_exponent = std::ranges::any_of(
        startup, [](const StartupCommand& c) { return c.index == kInterpolationTimePeriod && c.sub_index == 2; });
    for (const StartupCommand& command : startup) {
      CoeInitCmd cmd;
      cmd.command = command;
      const bool adapt = command.index == kInterpolationTimePeriod && command.data.size() == 1 && period &&
                         is_from_esi(command, slave_.device());
      if (adapt && command.sub_index == 1) {
        cmd.command.data = {period->value};
      } else if (adapt && command.sub_index == 2) {
        cmd.command.data = {static_cast<std::uint8_t>(period->exponent)};
      } else if (is_cycle_time(command) && bus_cycle <= 0xFFFF'FFFF) {
        cmd.command.data = le_bytes(static_cast<std::uint32_t>(bus_cycle));
      }
      out_.push_back(cmd);
      if (adapt && command.sub_index == 1 && !has_exponent && period->exponent != InterpolationTime{}.exponent) {
        cmd.command.sub_index = 2;
        cmd.command.data = {static_cast<std::uint8_t>(period->exponent)};
        cmd.command.comment = "exponent of the interpolation time";
        out_.push_back(cmd);
      }
    }
  }

  /// Last, so that a setting counts more than what the ESI writes.
  void add_sync_settings() {
    for (StartupCommand& command : sync_commands(slave_)) out_.emplace_back().command = std::move(command);
  }

  [[nodiscard]] std::vector<CoeInitCmd> take() { return std::move(out_); }

 private:
  /// 0x1C32:02 or 0x1C33:02, which the ESI leaves to the configurator (Data@AdaptAutomatically).
  static bool is_cycle_time(const StartupCommand& command) {
    const bool parameter = command.index == kSyncManagerParameter + 2 || command.index == kSyncManagerParameter + 3;
    return command.adapt_automatically && parameter && command.sub_index == 2 && command.data.size() == 4;
  }
  static std::uint16_t assign_object(const ProcessDataChannel& channel) {
    return static_cast<std::uint16_t>(kSyncManagerPdoAssign + channel.number);
  }

  void add_mapping(const Pdo& pdo) {
    out_.push_back(generated(pdo.index, 0, {0}, fmt::format("clear mapping of PDO 0x{:04X}", pdo.index)));
    // In the mapping, from 0. It is not counted on among the arguments: a compiler makes those in any order.
    std::uint8_t place = 0;
    for (const PdoEntry& entry : pdo.entries) {
      const auto sub_index = static_cast<std::uint8_t>(place + 1);
      out_.push_back(generated(pdo.index, sub_index, le_bytes(mapping_of(entry).word()),
                               fmt::format("map entry {} of PDO 0x{:04X}", place, pdo.index)));
      place = sub_index;
    }
    if (!pdo.entries.empty()) {
      out_.push_back(generated(pdo.index, 0, {place}, fmt::format("entry count of PDO 0x{:04X}", pdo.index)));
    }
  }

  void add_mapping_at_once(const Pdo& pdo) {
    Bytes data;
    ByteWriter writer(data);
    writer.u16(static_cast<std::uint16_t>(pdo.entries.size()));
    for (const PdoEntry& entry : pdo.entries) {
      writer.u32(mapping_of(entry).word());
    }
    out_.push_back(generated(pdo.index, 0, std::move(data), fmt::format("mapping of PDO 0x{:04X}", pdo.index)));
    out_.back().command.complete_access = true;
  }

  void add_assignment_of(const ProcessDataChannel& channel) {
    const auto index = assign_object(channel);
    std::uint8_t sub_index = 0;
    for (const std::uint16_t pdo : channel.pdos) {
      out_.push_back(generated(index, ++sub_index, le_bytes(pdo), fmt::format("assign PDO 0x{:04X}", pdo)));
    }
    out_.push_back(generated(index, 0, {sub_index}, fmt::format("PDO count of 0x{:04X}", index)));
  }

  void add_assignment_at_once(const ProcessDataChannel& channel) {
    const auto index = assign_object(channel);
    Bytes data;
    ByteWriter writer(data);
    writer.u16(static_cast<std::uint16_t>(channel.pdos.size()));
    for (const std::uint16_t pdo : channel.pdos) {
      writer.u16(pdo);
    }
    out_.push_back(generated(index, 0, std::move(data), fmt::format("PDO assignment 0x{:04X}", index)));
    out_.back().command.complete_access = true;
  }

  [[nodiscard]] bool is_read_only(std::uint16_t index, std::uint8_t sub_index) const {
    for (const auto& object : slave_.device().dictionary) {
      if (object.index == index) {
        return std::ranges::any_of(
            object.entries, [sub_index](const ObjectEntry& e) { return e.sub_index == sub_index && !e.writable; });
      }
    }
    return false;
  }

  const SlavePlan& slave_;
  const CoeDescription& coe_;
  EniDialect dialect_;
  std::vector<CoeInitCmd> out_;
};

}  // namespace

std::optional<InterpolationTime> interpolation_time(Nanoseconds cycle) {
  Nanoseconds unit = kMillisecond;
  for (int exponent = -3; exponent >= -9; --exponent, unit /= 10) {
    if (cycle % unit == 0 && cycle / unit >= 1 && cycle / unit <= 255) {
      return InterpolationTime{static_cast<std::uint8_t>(cycle / unit), static_cast<std::int8_t>(exponent)};
    }
  }
  return std::nullopt;
}

std::vector<CoeInitCmd> coe_init_cmds(const SlavePlan& slave, EniDialect dialect) {
  const auto& mailbox = slave.device().mailbox;
  if (!slave.mailbox || !mailbox || !mailbox->coe) {
    return {};
  }
  CoeList list(slave, *mailbox->coe, dialect);
  list.add_module_idents();
  list.add_clear_assignment();
  list.add_mappings();
  list.add_assignment();
  list.add_sync_types();
  list.add_startup(slave.cycle_time);
  list.add_sync_settings();
  return list.take();
}

}  // namespace syncline::compiler
