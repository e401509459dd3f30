// SPDX-License-Identifier: Apache-2.0
#include "protocol/al_state.h"

#include <array>
#include <cctype>
#include <string>

namespace syncline {
namespace {

struct StateRow {
  AlState state;
  std::string_view name;
  std::string_view letter;
};
constexpr std::array<StateRow, 5> kStates{{{AlState::kInit, "INIT", "I"},
                                           {AlState::kPreop, "PREOP", "P"},
                                           {AlState::kBoot, "BOOT", "B"},
                                           {AlState::kSafeop, "SAFEOP", "S"},
                                           {AlState::kOp, "OP", "O"}}};

struct TransitionRow {
  Transition transition;
  std::string_view name;
};
constexpr std::array<TransitionRow, 15> kTransitions{{
    {Transition::kII, "II"},
    {Transition::kIP, "IP"},
    {Transition::kPP, "PP"},
    {Transition::kPO, "PO"},
    {Transition::kPS, "PS"},
    {Transition::kPI, "PI"},
    {Transition::kSS, "SS"},
    {Transition::kSP, "SP"},
    {Transition::kSO, "SO"},
    {Transition::kSI, "SI"},
    {Transition::kOS, "OS"},
    {Transition::kOP, "OP"},
    {Transition::kOI, "OI"},
    {Transition::kIB, "IB"},
    {Transition::kBI, "BI"},
}};

bool same_name(std::string_view text, std::string_view name) {
  // "PRE-OP", "Safe_Op" and "preop" are all in use; punctuation says nothing.
  std::string plain;
  for (const char c : text) {
    if (c != '-' && c != '_' && c != ' ') plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return plain == name;
}

}  // namespace

std::string_view al_state_name(AlState state) {
  for (const auto& row : kStates) {
    if (row.state == state) return row.name;
  }
  return state == AlState::kNone ? "NONE" : "MIXED";
}

std::string_view al_state_letter(AlState state) {
  for (const auto& row : kStates) {
    if (row.state == state) return row.letter;
  }
  return "?";
}

std::optional<AlState> al_state_from_name(std::string_view name) {
  for (const auto& row : kStates) {
    if (same_name(name, row.name)) return row.state;
  }
  if (same_name(name, "BOOTSTRAP")) return AlState::kBoot;
  return std::nullopt;
}

std::string_view transition_name(Transition transition) {
  for (const auto& row : kTransitions) {
    if (row.transition == transition) return row.name;
  }
  return "?";
}

std::optional<Transition> transition_from_name(std::string_view name) {
  for (const auto& row : kTransitions) {
    if (row.name == name) return row.transition;
  }
  return std::nullopt;
}

std::optional<Transition> transition_between(AlState from, AlState to) {
  const auto first = al_state_letter(from);
  const auto second = al_state_letter(to);
  for (const auto& row : kTransitions) {
    if (row.name.substr(0, 1) == first && row.name.substr(1) == second) return row.transition;
  }
  return std::nullopt;
}

}  // namespace syncline
