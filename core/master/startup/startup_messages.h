// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/al_state.h"
#include "protocol/mailbox.h"
#include "reasons/reason.h"

namespace syncline {

struct MailboxConfig;

/// Start-up message of another protocol than CoE, as it goes into the mailbox.
struct StartupMessage {
  MailboxType type = MailboxType::kEoe;
  std::vector<std::uint8_t> data;  // behind the mailbox header
  std::uint32_t timeout_ms = 0;    // 0: the slave's own
  std::string name;                // for errors: "EoE start-up message 1 (set IP parameter)"
  /// The slave answers; what is vendor specific (VoE) is only sent.
  bool answered = true;
};

/// AoE, EoE, SoE, FoE and VoE messages of a slave at a transition, in this order, which is that of the ENI's elements.
/// Disabled ones are left out.
[[nodiscard]] std::vector<StartupMessage> startup_messages(const MailboxConfig& mailbox, Transition transition);

/// What a message of the same protocol means for the one that was sent.
struct StartupAnswer {
  bool is_answer = false;
  std::optional<Reason> refusal;  // why, when it is a refusal
};
/// SoE error flag, EoE result, AoE error code, FoE error. Messages that are too short for their protocol are refusals.
[[nodiscard]] StartupAnswer judge_startup_answer(MailboxType type, std::span<const std::uint8_t> data);

}  // namespace syncline
