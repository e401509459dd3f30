// SPDX-License-Identifier: Apache-2.0
#include "config/cyclic_frame.h"
#include "config/process_image.h"
#include "eni/format/eni_element.h"
#include "eni/format/eni_reader.h"
#include "eni/format/eni_writer.h"

namespace syncline::eni {
namespace {

Command read_command(const EniElement& cmd) {
  const EniElement element = cmd.required("Cmd");
  const auto code = element.number<std::uint8_t>();
  if (element && code > kLastCommand) {
    element.report(ErrorCode::kXmlBadValue, element.text());
    return Command::kNop;
  }
  return static_cast<Command>(code);
}

/// Fields that init commands and cyclic commands share.
template <class Cmd>
void read_datagram(const EniElement& element, Cmd& cmd) {
  cmd.comment = element.text_of("Comment");
  cmd.command = read_command(element);
  cmd.adp = element.number_of<std::uint16_t>("Adp");
  cmd.ado = element.number_of<std::uint16_t>("Ado");
  cmd.logical_address = element.number_of<std::uint32_t>("Addr");
  cmd.data = element.child("Data").bytes();
  cmd.data_length = element.optional_number_of<std::uint16_t>("DataLength");
  cmd.expected_wkc = element.optional_number_of<std::uint16_t>("Cnt");
}

ValidateType read_validate_type(const EniElement& element) {
  const std::string name = element.attribute("Type");
  for (const ValidateType type :
       {ValidateType::kEqual, ValidateType::kNotEqual, ValidateType::kGreaterOrEqual, ValidateType::kLessOrEqual,
        ValidateType::kGreater, ValidateType::kLess, ValidateType::kNone}) {
    if (name == validate_name(type)) {
      return type;
    }
  }
  if (!name.empty()) {
    element.report(ErrorCode::kXmlBadValue, "Type=\"" + name + "\"");
  }
  return ValidateType::kEqual;
}

std::optional<InitCmdValidate> read_validate(const EniElement& element) {
  if (!element) {
    return std::nullopt;
  }
  return InitCmdValidate{element.child("Data").bytes(), element.child("DataMask").bytes(),
                         element.number_of<std::uint32_t>("Timeout"), read_validate_type(element),
                         element.boolean_attribute("Signed")};
}

std::vector<AlState> read_states(const EniElement& element) {
  std::vector<AlState> states;
  for (const EniElement& state : element.children("State")) {
    if (const auto known = al_state_from_name(state.text())) {
      states.push_back(*known);
    } else {
      state.report(ErrorCode::kXmlBadValue, state.text());
    }
  }
  if (states.empty()) {
    states = {AlState::kPreop, AlState::kSafeop, AlState::kOp};
  }
  return states;
}

CyclicCmd read_cyclic_cmd(const EniElement& element) {
  CyclicCmd cmd;
  cmd.states = read_states(element);
  read_datagram(element, cmd);
  cmd.input_offset = element.number_of<std::uint32_t>("InputOffs");
  cmd.output_offset = element.number_of<std::uint32_t>("OutputOffs");
  cmd.copy_infos = read_each(element.child("CopyInfos").children("CopyInfo"), [](const EniElement& copy) {
    return CopyInfo{copy.number_of<std::uint32_t>("SrcBitOffs"), copy.number_of<std::uint32_t>("DstBitOffs"),
                    copy.number_of<std::uint32_t>("BitSize")};
  });
  return cmd;
}

std::vector<Variable> read_variables(const EniElement& element) {
  return read_each(element.children("Variable"), [](const EniElement& variable) {
    return Variable{variable.text_of("Name"), variable.text_of("DataType"), variable.text_of("Comment"),
                    variable.number_of<std::uint32_t>("BitSize"), variable.number_of<std::uint32_t>("BitOffs")};
  });
}

}  // namespace

std::vector<Transition> read_transitions(const EniElement& cmd) {
  std::vector<Transition> transitions;
  for (const EniElement& element : cmd.children("Transition")) {
    if (const auto known = transition_from_name(element.text())) {
      transitions.push_back(*known);
    } else {
      element.report(ErrorCode::kXmlBadValue, element.text());
    }
  }
  return transitions;
}

InitCmd read_init_cmd(const EniElement& element) {
  InitCmd cmd;
  cmd.transitions = read_transitions(element);
  cmd.before_slave = element.boolean_of("BeforeSlave");
  const std::string requires_what = element.text_of("Requires");
  cmd.requires_cycle = requires_what == "cycle";
  cmd.requires_frame = requires_what == "frame";
  read_datagram(element, cmd);
  cmd.retries = element.number_of<std::uint32_t>("Retries");
  cmd.validate = read_validate(element.child("Validate"));
  cmd.timeout_ms = element.optional_number_of<std::uint32_t>("Timeout");
  return cmd;
}

std::vector<InitCmd> read_init_cmds(const EniElement& init_cmds) {
  return read_each(init_cmds.children("InitCmd"), [](const EniElement& cmd) { return read_init_cmd(cmd); });
}

CyclicTask read_cyclic(const EniElement& cyclic) {
  CyclicTask task;
  task.comment = cyclic.text_of("Comment");
  task.cycle_time = cyclic.number_of<std::uint32_t>("CycleTime") * kMicrosecond;
  task.cycle_time_given = task.cycle_time > 0;
  task.priority = cyclic.optional_number_of<std::int32_t>("Priority");
  task.task_id = cyclic.text_of("TaskId");
  task.frames = read_each(cyclic.children("Frame"), [](const EniElement& frame) {
    return CyclicFrame{read_each(frame.children("Cmd"), [](const EniElement& cmd) { return read_cyclic_cmd(cmd); }),
                       frame.text_of("Comment")};
  });
  return task;
}

ProcessImage read_process_image(const EniElement& image) {
  ProcessImage out;
  const EniElement inputs = image.child("Inputs");
  const EniElement outputs = image.child("Outputs");
  out.input_bytes = inputs.number_of<std::uint32_t>("ByteSize");
  out.output_bytes = outputs.number_of<std::uint32_t>("ByteSize");
  out.inputs = read_variables(inputs);
  out.outputs = read_variables(outputs);
  return out;
}

}  // namespace syncline::eni
