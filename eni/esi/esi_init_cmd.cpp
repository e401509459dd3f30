// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "eni/esi/esi_device.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return text;
}

}  // namespace

std::vector<Transition> read_transitions(const Node& node) {
  std::vector<Transition> transitions;
  for (const Node& transition : node.children("Transition")) {
    const auto text = transition.trimmed();
    if (const auto known = transition_from_name(text)) {
      transitions.push_back(*known);
    } else if (const auto meant = transition_from_name(upper(text)); meant && node.reading().tolerant()) {
      transition.warn(because("\"{text}\" is read as {value}", text, transition_name(*meant)));
      transitions.push_back(*meant);
    } else {
      transition.fail(ErrorCode::kXmlBadValue, because("\"{text}\" is no state transition", text));
    }
  }
  if (transitions.empty() && node && node.reading().tolerant() && !node.child("Transition")) {
    node.warn(because("Transition is missing; taken for PS"));
    transitions.push_back(Transition::kPS);
  }
  if (transitions.empty()) (void)node.required("Transition");
  return transitions;
}

StartupCommand read_init_cmd(const Node& node) {
  StartupCommand command;
  command.transitions = read_transitions(node);
  const Node index = node.required("Index");
  command.index = index.number<std::uint16_t>();
  command.depend_on_slot = index.boolean("DependOnSlot").value_or(false);
  command.depend_on_slot_group = index.boolean("DependOnSlotGroup").value_or(false);
  command.sub_index = node.child_number<std::uint8_t>("SubIndex").value_or(0);
  const Node data = node.required("Data");
  command.data = data.bytes();
  command.adapt_automatically = data.boolean("AdaptAutomatically").value_or(false);
  command.comment = node.localized("Comment").trimmed();
  command.complete_access = node.boolean("CompleteAccess").value_or(false);
  command.fixed = node.boolean("Fixed").value_or(false);
  command.overwritten_by_module = node.boolean("OverwrittenByModule").value_or(false);
  return command;
}

}  // namespace syncline::eni
