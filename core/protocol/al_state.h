// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace syncline {

/// Application-layer state (ETG.1000.6, table 9): low nibble of 0x0120 and 0x0130.
enum class AlState : std::uint8_t { kNone = 0, kInit = 1, kPreop = 2, kBoot = 3, kSafeop = 4, kOp = 8 };
/// In the order of their values: BOOT stands between PREOP and SAFEOP.
[[nodiscard]] constexpr bool is_above(AlState state, AlState target) {
  return static_cast<int>(state) > static_cast<int>(target);
}

/// Mailboxes work, but for FoE, which works in BOOT too (ETG.1000.6, 6.4.1: PREOP and above).
[[nodiscard]] constexpr bool has_mailbox_communication(AlState state) {
  return state == AlState::kPreop || state == AlState::kSafeop || state == AlState::kOp;
}
/// Inputs at least are exchanged (ETG.1000.6, 6.4.1).
[[nodiscard]] constexpr bool has_process_data_communication(AlState state) {
  return state == AlState::kSafeop || state == AlState::kOp;
}

inline constexpr std::uint16_t kAlErrorFlag = 0x0010;  // status: error indication, control: acknowledge

[[nodiscard]] constexpr AlState al_state_of(std::uint16_t al_status) { return static_cast<AlState>(al_status & 0x0F); }
[[nodiscard]] std::string_view al_state_name(AlState state);    // "PREOP"
[[nodiscard]] std::string_view al_state_letter(AlState state);  // "P"
[[nodiscard]] std::optional<AlState> al_state_from_name(std::string_view name);

/// State transitions as ENI writes them (ETG.2100): two letters, from and to.
enum class Transition : std::uint8_t { kII, kIP, kPP, kPO, kPS, kPI, kSS, kSP, kSO, kSI, kOS, kOP, kOI, kIB, kBI };
[[nodiscard]] std::string_view transition_name(Transition transition);
[[nodiscard]] std::optional<Transition> transition_from_name(std::string_view name);
[[nodiscard]] std::optional<Transition> transition_between(AlState from, AlState to);

/// AL status code (0x0134): meaning and what to check, ETG.1020 table 11.
struct AlStatusCodeText {
  std::string_view meaning;
  std::string_view check;  // what to look at first
};
[[nodiscard]] AlStatusCodeText al_status_code_text(std::uint16_t code);

}  // namespace syncline
