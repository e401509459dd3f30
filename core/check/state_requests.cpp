// SPDX-License-Identifier: Apache-2.0
#include "check/state_requests.h"

#include <fmt/format.h>

#include "check/network_view.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

constexpr Transition kTransitions[] = {Transition::kIP, Transition::kPS, Transition::kSO, Transition::kOS,
                                       Transition::kSP, Transition::kOP, Transition::kPI, Transition::kSI,
                                       Transition::kOI, Transition::kIB, Transition::kBI};

/// The ways up to OP must ask for each state; on the way down masters may do it themselves.
bool is_needed(Transition transition) {
  return transition == Transition::kIP || transition == Transition::kPS || transition == Transition::kSO;
}

AlState state_of_letter(char letter) {
  switch (letter) {
    case 'P':
      return AlState::kPreop;
    case 'B':
      return AlState::kBoot;
    case 'S':
      return AlState::kSafeop;
    case 'O':
      return AlState::kOp;
    default:
      return AlState::kInit;
  }
}

AlState origin(Transition transition) { return state_of_letter(transition_name(transition).front()); }

/// Bits of the low byte that are compared.
std::uint8_t compared_bits(const InitCmdValidate& expected) {
  return expected.mask.empty() ? 0xFF : expected.mask.front();
}

/// State that a command waits for, if it reads AL status and compares the state there. One that waits for another bit
/// only, as for the device ID to be loaded, waits for no state.
std::optional<AlState> awaited_state(const InitCmd& cmd) {
  constexpr std::uint8_t kState = 0x0F;
  if (cmd.ado != reg::kAlStatus || is_logical(cmd.command) || !cmd.validate || cmd.validate->data.empty() ||
      (compared_bits(*cmd.validate) & kState) == 0) {
    return std::nullopt;
  }
  return al_state_of(cmd.validate->data.front());
}

/// The error bit of AL status is compared, and has to be set.
bool expects_error(const InitCmd& cmd) {
  constexpr std::uint8_t kError = 0x10;
  const InitCmdValidate& expected = *cmd.validate;
  return expected.type == ValidateType::kEqual && (expected.data.front() & compared_bits(expected) & kError) != 0;
}

class StateCheck {
 public:
  StateCheck(const NetworkView& view, std::size_t slave, Findings& findings)
      : slave_(slave), config_(view.config.slaves[slave]), findings_(findings) {}

  void run() {
    if (config_.init_cmds.empty()) {
      return findings_.add("ENI-STATE-05", {PlaceKind::kSlave, slave_});
    }
    for (const Transition transition : kTransitions) {
      if (const auto request = state_request(config_, transition)) {
        check_request(transition, *request);
      } else if (is_needed(transition)) {
        findings_.add("ENI-STATE-01", {PlaceKind::kSlave, slave_},
                      fig::text<"transition">(std::string(transition_name(transition))),
                      fig::text<"state">(std::string(al_state_name(target(transition)))));
      }
    }
  }

 private:
  void check_request(Transition transition, std::size_t request) {
    const AlState requested = *requested_state(config_.init_cmds[request]);
    if (requested != target(transition)) {
      findings_.add("ENI-STATE-02", {PlaceKind::kSlaveInitCmd, slave_, request},
                    fig::text<"transition">(std::string(transition_name(transition))),
                    fig::text<"requested">(std::string(al_state_name(requested))),
                    fig::text<"wanted">(std::string(al_state_name(target(transition)))));
      return;
    }
    check_waits(transition, is_needed(transition));
  }

  /// Each request on a transition is waited for before the next one, and nothing else is.
  void check_waits(Transition transition, bool must_wait) {
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::size_t open = kNone;            // request that nothing has waited for yet
    AlState there = origin(transition);  // a request of the state that a slave is in is answered
    AlState requested = there;
    bool any = false;
    const auto unanswered = [&] {
      if (open == kNone || !must_wait) return;
      findings_.add("ENI-STATE-03", {PlaceKind::kSlaveInitCmd, slave_, open},
                    fig::text<"transition">(std::string(transition_name(transition))),
                    fig::text<"state">(std::string(al_state_name(requested))));
    };
    for (std::size_t i = 0; i < config_.init_cmds.size(); ++i) {
      const InitCmd& cmd = config_.init_cmds[i];
      if (!has_transition(cmd, transition)) continue;
      if (const auto request = requested_state(cmd)) {
        unanswered();
        open = *request == there ? kNone : i;
        requested = *request;
        any = true;
      } else if (const auto awaited = awaited_state(cmd); awaited && any) {
        open = kNone;
        if (expects_error(cmd)) {
          findings_.add("ENI-STATE-04/error-bit", {PlaceKind::kSlaveInitCmd, slave_, i},
                        fig::text<"transition">(std::string(transition_name(transition))),
                        fig::text<"state">(std::string(al_state_name(*awaited))));
        }
        if (*awaited == requested) {
          there = requested;
          continue;
        }
        findings_.add("ENI-STATE-04", {PlaceKind::kSlaveInitCmd, slave_, i},
                      fig::text<"transition">(std::string(transition_name(transition))),
                      fig::text<"awaited">(std::string(al_state_name(*awaited))),
                      fig::text<"requested">(std::string(al_state_name(requested))));
      }
    }
    unanswered();
  }

  std::size_t slave_;
  const SlaveConfig& config_;
  Findings& findings_;
};

}  // namespace

AlState target(Transition transition) { return state_of_letter(transition_name(transition).back()); }

std::optional<AlState> requested_state(const InitCmd& cmd) {
  const auto value = written_number(cmd, reg::kAlControl, 1);
  return value ? std::optional(al_state_of(static_cast<std::uint16_t>(*value))) : std::nullopt;
}

std::optional<std::size_t> state_request(const SlaveConfig& slave, Transition transition) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < slave.init_cmds.size(); ++i) {
    if (has_transition(slave.init_cmds[i], transition) && requested_state(slave.init_cmds[i])) found = i;
  }
  return found;
}

void check_state_requests(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    StateCheck(view, i, findings).run();
  }
}

}  // namespace syncline::checker
