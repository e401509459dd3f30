// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "check/network_view.h"
#include "check/state_requests.h"
#include "config/command_text.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "protocol/assign_activate.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

bool in(std::uint16_t ado, std::uint16_t first, unsigned size) { return ado >= first && ado < first + size; }

constexpr std::uint32_t kLastWord = 0xFFFF;  // of any EEPROM in the field

bool reads_nothing(Command command) {
  return command == Command::kNop || command == Command::kApwr || command == Command::kFpwr ||
         command == Command::kBwr || command == Command::kLwr;
}

/// Registers that the data sheet names, those of the maker of the ESC, and memory.
bool is_register(std::uint16_t ado) {
  constexpr std::uint16_t kOfTheMaker = 0x0E00;  // ESC data sheet, section II: ESC specific registers
  return ado >= kOfTheMaker || !reg::name(ado).empty();
}

/// What the ESC or its PDI writes and a master only reads (ESC data sheet, section II).
bool is_read_only(std::uint16_t ado) {
  return ado < reg::kStationAddress || in(ado, reg::kDlStatus, 2) || in(ado, reg::kAlStatus, 6) ||
         in(ado, reg::kEcatEventRequest, 2) || in(ado, reg::kAlEventRequest, 4);
}

class OrderCheck {
 public:
  OrderCheck(const NetworkView& view, std::size_t slave, Findings& findings)
      : slave_(slave), config_(view.config.slaves[slave]), findings_(findings) {}

  void run() {
    for (const Transition transition : {Transition::kIP, Transition::kPS, Transition::kSO}) {
      check_before_request(transition);
    }
    check_address();
    check_eeprom();
    check_answers();
    for (std::size_t i = 0; i < config_.init_cmds.size(); ++i) check_sense(i, config_.init_cmds[i]);
  }

 private:
  template <FigureName... kNames>
  void add(Sentence<kNames...> code, std::size_t cmd, Named<kNames>... figures) {
    findings_.add<kNames...>(code, {PlaceKind::kSlaveInitCmd, slave_, cmd}, std::move(figures)...);
  }

  /// SyncManagers, FMMUs and SYNC0 are checked or used by the slave when it changes its state.
  void check_before_request(Transition transition) {
    const auto request = state_request(config_, transition);
    if (!request) return;
    for (std::size_t i = *request + 1; i < config_.init_cmds.size(); ++i) {
      const InitCmd& cmd = config_.init_cmds[i];
      if (!has_transition(cmd, transition) || !writes(cmd.command) || is_logical(cmd.command)) continue;
      const auto on = fig::text<"transition">(std::string(transition_name(transition)));
      const auto wanted = fig::text<"state">(std::string(al_state_name(target(transition))));
      if (in(cmd.ado, reg::kSyncManager, 0x80)) {
        add("ENI-ORD-01", i, on, wanted);
      } else if (in(cmd.ado, reg::kFmmu, 0x100)) {
        add("ENI-ORD-02", i, on, wanted);
      } else if (const auto assign = written_number(cmd, reg::kCyclicUnitControl, 2);
                 assign && AssignActivate{static_cast<std::uint16_t>(*assign)}.unit_on()) {
        add("ENI-ORD-03", i, on, wanted);
      }
    }
  }

  /// From INIT a slave is known by its place until it has its station address.
  void check_address() {
    bool has_address = false;
    for (std::size_t i = 0; i < config_.init_cmds.size(); ++i) {
      const InitCmd& cmd = config_.init_cmds[i];
      if (!has_transition(cmd, Transition::kIP)) continue;
      has_address = has_address || writes_register(cmd, reg::kStationAddress);
      if (is_fixed_address(cmd.command) && !has_address) {
        add("ENI-ORD-04", i, fig::text<"command">(address_text(cmd)));
        return;
      }
      if (const auto value = written_number(cmd, reg::kStationAddress, 2); value && *value != config_.station_address) {
        add("ENI-ORD-07", i, fig::number<"written">(*value), fig::number<"address">(config_.station_address));
      }
    }
  }

  /// The EEPROM belongs to the master while it reads it, and to the slave when it goes to PREOP.
  void check_eeprom() {
    enum class Owner { kUnknown, kMaster, kSlave } owner = Owner::kUnknown;
    const auto request = state_request(config_, Transition::kIP);
    for (std::size_t i = 0; i < config_.init_cmds.size(); ++i) {
      const InitCmd& cmd = config_.init_cmds[i];
      if (!has_transition(cmd, Transition::kIP)) continue;
      if (const auto value = written_number(cmd, reg::kSiiConfiguration, 1)) {
        owner = (*value & 1) != 0 ? Owner::kSlave : Owner::kMaster;
      }
      if (writes_register(cmd, reg::kSiiControl) && owner != Owner::kMaster) {
        add("ENI-ORD-05", i);
        return;
      }
      if (request == i && owner == Owner::kMaster && config_.mailbox) {
        add("ENI-ORD-06", i);
      }
    }
  }

  /// Each request to read the EEPROM (0x0100 in 0x0502, a word's address in 0x0504) has its answer read from 0x0508,
  /// and no answer is compared that nobody asked for.
  void check_answers() {
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::size_t asked = kNone;
    const auto unread = [&] {
      if (asked != kNone) add("ENI-ORD-09", asked);
    };
    bool valid = false;  // an answer is there, perhaps read already
    for (std::size_t i = 0; i < config_.init_cmds.size(); ++i) {
      const InitCmd& cmd = config_.init_cmds[i];
      if (!has_transition(cmd, Transition::kIP) || is_logical(cmd.command)) continue;
      if (const auto control = written_number(cmd, reg::kSiiControl, 2)) {
        unread();
        valid = *control == kSiiRead && written_number(cmd, reg::kSiiAddress, 4).value_or(0) <= kLastWord;
        asked = valid ? i : kNone;
      } else if (!writes(cmd.command) && cmd.ado == reg::kSiiData) {
        if (!valid && cmd.validate) add("ENI-ORD-09/unasked", i);
        asked = kNone;
      }
    }
    unread();
  }

  /// What no slave can answer as it is meant, whatever is in it.
  void check_sense(std::size_t i, const InitCmd& cmd) {
    const auto command = fig::text<"command">(address_text(cmd));
    if (cmd.validate && cmd.validate->type != ValidateType::kNone && reads_nothing(cmd.command))
      add("ENI-ORD-10/check", i, command);
    if (is_logical(cmd.command)) {
      add("ENI-ORD-10/logical", i, command);
    } else if (!is_register(cmd.ado)) {
      add("ENI-ORD-10", i, command);
    } else if (writes(cmd.command) && is_read_only(cmd.ado)) {
      add("ENI-ORD-10/read-only", i, command, fig::text<"register">(std::string(reg::name(cmd.ado))));
    }
  }

  std::size_t slave_;
  const SlaveConfig& config_;
  Findings& findings_;
};

/// What may be left of an earlier run is cleared before the slaves are addressed.
void check_master(const NetworkView& view, Findings& findings) {
  struct Cleared {
    std::uint16_t ado;
    const char* what;
  };
  if (view.config.slaves.empty()) return;
  for (const Cleared& cleared_area :
       {Cleared{reg::kStationAddress, "station addresses (0x0010)"}, Cleared{reg::kFmmu, "FMMUs (0x0600)"},
        Cleared{reg::kSyncManager, "SyncManagers (0x0800)"}}) {
    const bool cleared = std::ranges::any_of(view.config.master.init_cmds, [&](const InitCmd& cmd) {
      return cmd.command == Command::kBwr && has_transition(cmd, Transition::kIP) &&
             writes_register(cmd, cleared_area.ado);
    });
    if (!cleared) {
      findings.add("ENI-ORD-08", {PlaceKind::kMaster}, fig::phrase<"registers">(cleared_area.what));
    }
  }
}

}  // namespace

void check_command_order(const NetworkView& view, Findings& findings) {
  check_master(view, findings);
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    OrderCheck(view, i, findings).run();
  }
}

}  // namespace syncline::checker
