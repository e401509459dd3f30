// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "check/network_view.h"
#include "config/init_cmd.h"
#include "config/mailbox_config.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "support/le_number.h"

namespace syncline::checker {
namespace {

constexpr std::uint16_t kFirstAssign = 0x1C10;  // + SyncManager
constexpr std::uint16_t kLastAssign = 0x1C2F;
constexpr std::uint16_t kInterpolation = 0x60C2;  // + 0x800 for each further axis of a drive

bool is_assignment(std::uint16_t index) { return index >= kFirstAssign && index <= kLastAssign; }
bool is_mapping(std::uint16_t index) {
  return (index >= 0x1600 && index <= 0x17FF) || (index >= 0x1A00 && index <= 0x1BFF);
}

/// A list object (count in sub-index 0) as the start-up commands leave it.
struct WrittenList {
  std::map<unsigned, std::uint64_t> entries;
  std::optional<unsigned> count;  // of the last write to sub-index 0
  bool open = false;              // entries may be written: the count is 0
  std::size_t last_cmd = 0;
  bool bad_order = false;  // already reported
};

class CoeCheck {
 public:
  CoeCheck(const NetworkView& view, std::size_t slave, Findings& findings)
      : view_(view), slave_(slave), config_(view.config.slaves[slave]), findings_(findings) {}

  void run() {
    const auto& commands = config_.mailbox->coe_commands;
    for (std::size_t i = 0; i < commands.size(); ++i) {
      check_command(i, commands[i]);
      if (commands[i].command.enabled && writes_list(commands[i])) take(i, commands[i].command);
    }
    for (const auto& [index, list] : lists_) {
      if (list.entries.size() > list.count.value_or(0) && !list.bad_order) {
        add("ENI-COE-04/count-stays", list.last_cmd, fig::hex<"object">(index),
            fig::count<"entries">(list.entries.size()), fig::count<"count">(list.count.value_or(0)));
      } else if (!list.entries.empty() && list.entries.rbegin()->first < list.count.value_or(0) && !list.bad_order) {
        add("ENI-COE-04/count-beyond", list.last_cmd, fig::hex<"object">(index), fig::count<"count">(*list.count),
            fig::number<"last">(list.entries.rbegin()->first));
      } else {
        compare(index, list);
      }
    }
  }

 private:
  template <FigureName... kNames>
  void add(Sentence<kNames...> code, std::size_t cmd, Named<kNames>... figures) {
    findings_.add<kNames...>(code, {PlaceKind::kCoeCmd, slave_, cmd}, std::move(figures)...);
  }

  static bool writes_list(const CoeInitCmd& cmd) {
    return has_transition(cmd.command, Transition::kPS) &&
           (is_assignment(cmd.command.index) || is_mapping(cmd.command.index));
  }
  void check_command(std::size_t i, const CoeInitCmd& cmd) {
    const StartupCommand& command = cmd.command;
    const auto object = fmt::format("0x{:04x}:{}", command.index, command.sub_index);
    if (cmd.ccs != 1) {
      add("ENI-COE-02", i, fig::text<"object">(object), fig::number<"ccs">(cmd.ccs));
    }
    if (command.data.empty() && command.enabled) {
      add("ENI-COE-05", i, fig::text<"object">(object));
    }
    constexpr std::uint32_t kLeastMs = 20;
    if (command.enabled && command.timeout_ms != 0 && command.timeout_ms < kLeastMs) {
      add("ENI-TIME-07", i, fig::text<"object">(object), fig::count<"timeout">(command.timeout_ms));
    }
    if (command.complete_access && command.sub_index > 1) {
      add("ENI-COE-06", i, fig::text<"object">(object));
    }
    for (const Transition transition : {Transition::kII, Transition::kIB, Transition::kBI}) {
      if (has_transition(command, transition)) {
        add("ENI-COE-07", i, fig::text<"object">(object),
            fig::text<"transition">(std::string(transition_name(transition))));
      }
    }
    if (command.index >= kInterpolation && (command.index - kInterpolation) % 0x800 == 0 && command.index < 0xA000 &&
        command.sub_index == 1 && command.enabled && !command.complete_access && !command.data.empty()) {
      check_interpolation(i, command);
    }
  }

  /// 0x60C2:01 is a number, :02 the power of ten of its unit in seconds (-3 unless written).
  void check_interpolation(std::size_t i, const StartupCommand& command) {
    int exponent = -3;
    for (const CoeInitCmd& other : config_.mailbox->coe_commands) {
      if (other.command.index == command.index && other.command.sub_index == 2 && !other.command.data.empty()) {
        exponent = static_cast<std::int8_t>(other.command.data.front());
      }
    }
    if (exponent < -9 || exponent > 0 || view_.config.cyclic.empty()) return;
    Nanoseconds time = static_cast<Nanoseconds>(command.data.front());
    for (int e = -9; e < exponent; ++e) time *= 10;
    const Nanoseconds sync0 = config_.dc ? config_.dc->cycle_time0 : 0;
    const bool is_task =
        std::ranges::any_of(view_.config.cyclic, [&](const CyclicTask& task) { return task.cycle_time == time; });
    const bool known = sync0 > 0 || view_.config.cyclic.front().cycle_time_given;
    if (known && !is_task && time != sync0) {
      add("ENI-COE-08", i, fig::hex<"object">(command.index), fig::time<"written">(time),
          fig::time<"cycle">(sync0 > 0 ? sync0 : view_.config.cycle_time()));
    }
  }

  void take(std::size_t i, const StartupCommand& command) {
    WrittenList& list = lists_[command.index];
    list.last_cmd = i;
    const std::size_t width = is_assignment(command.index) ? 2 : 4;
    if (command.complete_access) {
      if (command.data.empty()) return;
      const std::span<const std::uint8_t> bytes(command.data);
      list.entries.clear();
      for (std::size_t at = 2; at + width <= bytes.size(); at += width) {
        list.entries[static_cast<unsigned>((at - 2) / width + 1)] = le_number(bytes.subspan(at, width));
      }
      list.count = bytes[0];
      list.open = list.count == 0U;
    } else if (command.sub_index == 0) {
      list.count = static_cast<unsigned>(le_number(command.data));
      list.open = list.count == 0U;
      if (list.open) list.entries.clear();
    } else {
      if (!list.open && !list.bad_order) {
        list.bad_order = true;
        add("ENI-COE-04", i, fig::hex<"object">(command.index), fig::number<"sub_index">(command.sub_index));
      }
      list.entries[command.sub_index] = le_number(command.data);
    }
  }

  void compare(std::uint16_t index, const WrittenList& list) {
    if (list.bad_order) return;
    std::vector<std::uint64_t> written;
    for (const auto& [sub_index, value] : list.entries) {
      if (sub_index <= list.count.value_or(0)) written.push_back(value);
    }
    if (is_assignment(index)) {
      compare_assignment(index, list, written);
    } else {
      compare_mapping(index, list, written);
    }
  }

  void compare_assignment(std::uint16_t index, const WrittenList& list, const std::vector<std::uint64_t>& written) {
    if (config_.sync_managers.empty()) return;  // a file without process data
    const auto manager = std::ranges::find(config_.sync_managers, index - kFirstAssign, &ConfiguredSyncManager::number);
    const std::vector<std::uint64_t> said =
        manager == config_.sync_managers.end() ? std::vector<std::uint64_t>{}
                                               : std::vector<std::uint64_t>(manager->pdos.begin(), manager->pdos.end());
    if (list.count.value_or(0) != said.size() || written != said) {
      add("ENI-COE-01", list.last_cmd, fig::hex<"object">(index), hex_list<"written">(written, 4),
          fig::number<"manager">(index - kFirstAssign), hex_list<"listed">(said, 4));
    }
  }

  void compare_mapping(std::uint16_t index, const WrittenList& list, const std::vector<std::uint64_t>& written) {
    const auto pdo = std::ranges::find_if(config_.pdos, [&](const ConfiguredPdo& p) { return p.pdo.index == index; });
    if (pdo == config_.pdos.end()) return;
    std::vector<std::uint64_t> said;
    for (const PdoEntry& entry : pdo->pdo.entries) {
      said.push_back(mapping_of(entry).word());
    }
    if (written != said) {
      add("ENI-COE-03", list.last_cmd, fig::hex<"object">(index), hex_list<"written">(written, 8),
          hex_list<"listed">(said, 8));
    }
  }

  template <FigureName kName>
  static Named<kName> hex_list(const std::vector<std::uint64_t>& values, int digits) {
    if (values.empty()) return fig::phrase<kName>("nothing");
    std::string out;
    for (const std::uint64_t value : values) out += fmt::format("{}0x{:0{}x}", out.empty() ? "" : ", ", value, digits);
    return fig::text<kName>(std::move(out));
  }

  const NetworkView& view_;
  std::size_t slave_;
  const SlaveConfig& config_;
  Findings& findings_;
  std::map<std::uint16_t, WrittenList> lists_;
};

}  // namespace

void check_coe(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    if (view.config.slaves[i].mailbox) CoeCheck(view, i, findings).run();
  }
}

}  // namespace syncline::checker
