// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compare/difference_list.h"
#include "compare/network_compare.h"
#include "compare/slave_pairing.h"
#include "config/command_text.h"
#include "config/cyclic_frame.h"
#include "config/master_config.h"
#include "config/network_config.h"
#include "findings/finding.h"
#include "protocol/command.h"
#include "protocol/registers.h"

namespace syncline::comparison {
namespace {

using Group = DifferenceGroup;

bool is_clock(const CyclicCmd& cmd) {
  return !is_logical(cmd.command) && cmd.ado >= reg::kReceiveTimePort0 && cmd.ado < 0x0A00;
}

/// What a command to the clocks is there for.
std::string purpose(const CyclicCmd& cmd) {
  if (cmd.ado == reg::kReceiveTimePort0 && cmd.command == Command::kNop)
    return "room for the latch of receive times (NOP 0x0900)";
  if (cmd.ado == reg::kReceiveTimePort0)
    return fmt::format("latch of receive times ({} 0x0900)", command_name(cmd.command));
  if (cmd.ado == reg::kSystemTime && (cmd.command == Command::kArmw || cmd.command == Command::kFrmw)) {
    return fmt::format("drift compensation ({} 0x0910)", command_name(cmd.command));
  }
  if (cmd.ado == reg::kSystemTime) return fmt::format("bus shift ({} 0x0910)", command_name(cmd.command));
  if (cmd.ado == reg::kSystemTimeDifference) return fmt::format("sync window ({} 0x092C)", command_name(cmd.command));
  return fmt::format("{} 0x{:04x}", command_name(cmd.command), cmd.ado);
}

std::optional<std::size_t> position(const NetworkConfig& config, const CyclicCmd& cmd) {
  if (is_fixed_address(cmd.command)) {
    const auto slave = std::ranges::find(config.slaves, cmd.adp, &SlaveConfig::station_address);
    if (slave != config.slaves.end()) return static_cast<std::size_t>(slave - config.slaves.begin());
  }
  const std::size_t place = static_cast<std::uint16_t>(0U - cmd.adp);
  return is_auto_increment(cmd.command) && place < config.slaves.size() ? std::optional(place) : std::nullopt;
}

struct Line {
  std::string what;   // what it is for
  std::string value;  // what matters about it
  Group group = Group::kCyclic;
  bool operator==(const Line&) const = default;
};

std::string count_text(const CyclicCmd& cmd) {
  return cmd.expected_wkc ? fmt::format(", working counter {}", *cmd.expected_wkc) : "";
}

std::string data_text(const CyclicCmd& cmd) {
  const bool zeros = std::ranges::all_of(cmd.data, [](std::uint8_t byte) { return byte == 0; });
  return cmd.data_length || zeros ? "" : fmt::format(", {}", hex_text(cmd.data));
}

/// Slaves are named by their place in the left configuration, so that an inserted one moves nothing.
class Lines {
 public:
  Lines(const NetworkConfig& config, const SlavePairing* pairing) : config_(config), pairing_(pairing) {}

  [[nodiscard]] std::vector<Line> of(const CyclicTask& task) const {
    std::vector<Line> out;
    std::map<std::string, int> seen;
    for (const auto& frame : task.frames) {
      for (const auto& cmd : frame.commands) {
        Line line = of(cmd);
        if (const int n = ++seen[line.what]; n > 1) line.what += fmt::format(" no. {}", n);
        out.push_back(std::move(line));
      }
    }
    return out;
  }

 private:
  [[nodiscard]] Line of(const CyclicCmd& cmd) const {
    const std::string states = states_text(cmd.states);
    const std::string rest =
        fmt::format("{} bytes{}{} in {}{}", cmd.length(), data_text(cmd), count_text(cmd), states, copies(cmd));
    if (is_clock(cmd)) return {purpose(cmd), fmt::format("{}{}", rest, addressee(cmd)), Group::kClocks};
    if (is_logical(cmd.command))
      return {fmt::format("{}", command_name(cmd.command)), fmt::format("0x{:08x}, {}", cmd.logical_address, rest)};
    return {fmt::format("{} 0x{:04x}", command_name(cmd.command), cmd.ado), fmt::format("{}{}", rest, addressee(cmd))};
  }

  [[nodiscard]] std::string addressee(const CyclicCmd& cmd) const {
    if (is_broadcast(cmd.command) || cmd.command == Command::kNop) return "";
    auto slave = position(config_, cmd);
    if (slave && pairing_ != nullptr && *slave < pairing_->left_of.size())
      slave = pairing_->left_of[*slave].value_or(*slave);
    return slave ? fmt::format(", slave {}", *slave) : fmt::format(", address {}", cmd.adp);
  }

  static std::string copies(const CyclicCmd& cmd) {
    std::string out;
    for (const CopyInfo& copy : cmd.copy_infos) {
      out += fmt::format(", copies {} bits from {} to {}", copy.bit_size, copy.source_bit, copy.destination_bit);
    }
    return out;
  }

  const NetworkConfig& config_;
  const SlavePairing* pairing_;
};

/// Of a task by its number from 1, 0 where there is one only.
Finding command_of(std::size_t task, const std::string& command) {
  return task == 0 ? what("difference-cyclic-command", fig::text<"command">(command))
                   : what("difference-cyclic-command/task", fig::number<"task">(task), fig::text<"command">(command));
}

void compare_task(std::size_t task, const std::vector<Line>& left, const std::vector<Line>& right,
                  DifferenceList& out) {
  if (left == right) return;
  std::map<std::string, const Line*> others;
  for (const Line& line : right) others.emplace(line.what, &line);
  std::map<std::string, const Line*> ours;
  std::vector<const Line*> order;
  for (const Line& line : left) {
    ours.emplace(line.what, &line);
    const auto other = others.find(line.what);
    if (other == others.end()) {
      out.add(line.group, command_of(task, line.what), line.value, "");
      continue;
    }
    order.push_back(other->second);
    if (other->second->value != line.value)
      out.add(line.group, command_of(task, line.what), line.value, other->second->value);
  }
  for (const Line& line : right) {
    if (!ours.contains(line.what)) out.add(line.group, command_of(task, line.what), "", line.value);
  }
  if (!std::ranges::is_sorted(order)) {
    out.add(
        Group::kCyclic,
        task == 0 ? what("difference-cyclic-order") : what("difference-cyclic-order/task", fig::number<"task">(task)),
        "", "");
  }
}

std::string cycle_time_text(const CyclicTask& task) {
  return task.cycle_time_given ? exact_time_text(task.cycle_time) : "not told";
}

std::string frame_sizes(const CyclicTask& task) {
  std::string out;
  for (const auto& frame : task.frames) out += fmt::format("{}{}", out.empty() ? "" : "+", frame.commands.size());
  return out + " commands";
}

}  // namespace

void compare_cyclic(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing,
                    DifferenceList& out) {
  if (left.cyclic.size() != right.cyclic.size()) {
    out.number(Group::kCyclic, "difference-cyclic-tasks", static_cast<std::int64_t>(left.cyclic.size()),
               static_cast<std::int64_t>(right.cyclic.size()));
  }
  for (std::size_t t = 0; t < std::min(left.cyclic.size(), right.cyclic.size()); ++t) {
    const CyclicTask& l = left.cyclic[t];
    const CyclicTask& r = right.cyclic[t];
    const std::size_t task = left.cyclic.size() > 1 ? t + 1 : 0;
    if (l.cycle_time != r.cycle_time || l.cycle_time_given != r.cycle_time_given) {
      out.add(Group::kCyclic,
              task == 0 ? what("difference-cycle-time") : what("difference-cycle-time/task", fig::number<"task">(task)),
              cycle_time_text(l), cycle_time_text(r));
    }
    if (l.frames == r.frames && left.slaves.size() == right.slaves.size()) continue;
    const auto one = Lines(left, nullptr).of(l);
    const auto other = Lines(right, &pairing).of(r);
    compare_task(task, one, other, out);
    const bool same_split = std::ranges::equal(
        l.frames, r.frames, {}, [](const CyclicFrame& f) { return f.commands.size(); },
        [](const CyclicFrame& f) { return f.commands.size(); });
    if (one.size() == other.size() && !same_split) {
      out.add(Group::kCyclic,
              task == 0 ? what("difference-frames") : what("difference-frames/task", fig::number<"task">(task)),
              frame_sizes(l), frame_sizes(r));
    }
  }
}

void compare_master(const NetworkConfig& left, const NetworkConfig& right, DifferenceList& out) {
  const MasterConfig& l = left.master;
  const MasterConfig& r = right.master;
  out.field(Group::kMaster, "difference-destination-address", hex_text(l.destination_mac), hex_text(r.destination_mac));
  out.field(Group::kMaster, "difference-source-address", hex_text(l.source_mac), hex_text(r.source_mac));
  out.number(Group::kMaster, "difference-ethertype", l.ether_type, r.ether_type);
  out.number(Group::kMaster, "difference-mailbox-state-bits", l.mailbox_state_count.value_or(0),
             r.mailbox_state_count.value_or(0));
  out.number(Group::kMaster, "difference-logical-address-of-the-mailbox-state-bits", l.mailbox_state_start,
             r.mailbox_state_start);
  out.flag(Group::kMaster, "difference-ethernet-over-ethercat", l.eoe, r.eoe);
  if (l.eoe && r.eoe && !(l.eoe_settings == r.eoe_settings)) {
    const auto words = [](const EoeSwitchSettings& eoe) {
      return fmt::format("{} ports, {} frames, {} addresses", eoe.max_ports, eoe.max_frames, eoe.max_macs);
    };
    out.add(Group::kMaster, "difference-eoe-switch", words(l.eoe_settings), words(r.eoe_settings));
  }
  if (l.init_cmds == r.init_cmds) return;
  SlaveConfig one, other;
  one.init_cmds = l.init_cmds;
  other.init_cmds = r.init_cmds;
  for (const NetworkDifference& difference : compare_slaves(one, other, "")) {
    out.add(Group::kMaster,
            what("difference-master-command", fig::text<"command">(difference.where),
                 fig::phrase<"field">(difference.field)),
            difference.left, difference.right);
  }
}

/// Data of the slaves in the image and in the logical address space: where they begin, as far as sizes do not explain
/// it.
void compare_image(const NetworkConfig& left, const NetworkConfig& right, const SlavePairing& pairing,
                   DifferenceList& out) {
  std::size_t outputs = 0;
  std::size_t inputs = 0;
  std::size_t state_bits = 0;
  for (std::size_t i = 0; i < left.slaves.size(); ++i) {
    if (!pairing.right_of[i]) continue;
    const SlaveConfig& l = left.slaves[i];
    const SlaveConfig& r = right.slaves[*pairing.right_of[i]];
    if (l.send && r.send && l.send->bit_start != r.send->bit_start) ++outputs;
    if (l.receive && r.receive && l.receive->bit_start != r.receive->bit_start) ++inputs;
    // With other slaves in front it is another bit.
    if (*pairing.right_of[i] == i && l.mailbox && r.mailbox && l.mailbox->status_bit_address &&
        r.mailbox->status_bit_address && l.mailbox->status_bit_address != r.mailbox->status_bit_address) {
      ++state_bits;
    }
  }
  if (outputs > 0) out.add(Group::kImage, what("difference-data-moved/outputs", fig::count<"slaves">(outputs)), "", "");
  if (inputs > 0) out.add(Group::kImage, what("difference-data-moved", fig::count<"slaves">(inputs)), "", "");
  if (state_bits > 0) {
    out.add(Group::kImage, what("difference-data-moved/mailbox-states", fig::count<"slaves">(state_bits)), "", "");
  }
  // Other commands in the frames need another image.
  if (out.has(Group::kCyclic) || out.has(Group::kClocks)) return;
  out.number(Group::kImage, "difference-size-of-the-inputs", left.image.input_bytes, right.image.input_bytes, " bytes");
  out.number(Group::kImage, "difference-size-of-the-outputs", left.image.output_bytes, right.image.output_bytes,
             " bytes");
}

}  // namespace syncline::comparison
