// SPDX-License-Identifier: Apache-2.0
#include "config/cyclic_frame.h"
#include "config/process_image.h"
#include "eni/format/eni_text.h"
#include "eni/format/eni_writer.h"
#include "support/types.h"

namespace syncline::eni {
namespace {

void write_address(EniText& out, Command command, std::uint16_t adp, std::uint16_t ado, std::uint32_t logical) {
  if (is_logical(command)) {
    out.number("Addr", logical);
  } else {
    out.number("Adp", adp);
    out.number("Ado", ado);
  }
}

void write_payload(EniText& out, const std::vector<std::uint8_t>& data, const std::optional<std::uint16_t>& length) {
  if (length) {
    out.number("DataLength", *length);
  } else {
    out.bytes("Data", data);
  }
}

void write_validate(EniText& out, const InitCmdValidate& validate) {
  out.open("Validate",
           {{"Type", validate.type == ValidateType::kEqual ? "" : std::string(validate_name(validate.type))},
            {"Signed", out.flag(validate.is_signed)}});
  out.bytes("Data", validate.data);
  if (!validate.mask.empty()) {
    out.bytes("DataMask", validate.mask);
  }
  out.number("Timeout", validate.timeout_ms);
  out.close();
}

void write_cyclic_cmd(EniText& out, const CyclicCmd& cmd) {
  out.open("Cmd");
  for (const AlState state : cmd.states) {
    out.text("State", al_state_name(state));
  }
  if (!cmd.comment.empty()) {
    out.text("Comment", cmd.comment);
  }
  out.number("Cmd", static_cast<std::uint32_t>(cmd.command));
  write_address(out, cmd.command, cmd.adp, cmd.ado, cmd.logical_address);
  write_payload(out, cmd.data, cmd.data_length);
  if (cmd.expected_wkc) {
    out.number("Cnt", *cmd.expected_wkc);
  }
  out.number("InputOffs", cmd.input_offset);
  out.number("OutputOffs", cmd.output_offset);
  if (!cmd.copy_infos.empty()) {
    out.open("CopyInfos");
    for (const auto& copy : cmd.copy_infos) {
      out.open("CopyInfo");
      out.number("SrcBitOffs", copy.source_bit);
      out.number("DstBitOffs", copy.destination_bit);
      out.number("BitSize", copy.bit_size);
      out.close();
    }
    out.close();
  }
  out.close();
}

void write_variables(EniText& out, std::string_view element, std::uint32_t bytes,
                     const std::vector<Variable>& variables) {
  out.open(element);
  out.number("ByteSize", bytes);
  for (const auto& variable : variables) {
    out.open("Variable");
    out.text("Name", variable.name);
    if (!variable.comment.empty()) {
      out.text("Comment", variable.comment);
    }
    if (!variable.data_type.empty()) {
      out.text("DataType", variable.data_type);
    }
    out.number("BitSize", variable.bit_size);
    out.number("BitOffs", variable.bit_offset);
    out.close();
  }
  out.close();
}

}  // namespace

std::string_view validate_name(ValidateType type) {
  switch (type) {
    case ValidateType::kEqual:
      return "EQ";
    case ValidateType::kNotEqual:
      return "NOT_EQ";
    case ValidateType::kGreaterOrEqual:
      return "EQ_OR_G";
    case ValidateType::kLessOrEqual:
      return "EQ_OR_L";
    case ValidateType::kGreater:
      return "G";
    case ValidateType::kLess:
      return "L";
    case ValidateType::kNone:
      return "NONE";
  }
  return "EQ";
}

void write_init_cmd(EniText& out, const InitCmd& cmd, const char* element) {
  out.open(element);
  for (const Transition transition : cmd.transitions) {
    out.text("Transition", transition_name(transition));
  }
  if (cmd.before_slave) {
    out.boolean("BeforeSlave", true);
  }
  if (!cmd.comment.empty()) {
    out.text("Comment", cmd.comment);
  }
  if (cmd.requires_cycle || cmd.requires_frame) {
    out.text("Requires", cmd.requires_cycle ? "cycle" : "frame");
  }
  out.number("Cmd", static_cast<std::uint32_t>(cmd.command));
  write_address(out, cmd.command, cmd.adp, cmd.ado, cmd.logical_address);
  write_payload(out, cmd.data, cmd.data_length);
  if (cmd.expected_wkc) {
    out.number("Cnt", *cmd.expected_wkc);
  }
  out.number("Retries", cmd.retries);
  if (cmd.validate) {
    write_validate(out, *cmd.validate);
  } else if (cmd.timeout_ms) {
    out.number("Timeout", *cmd.timeout_ms);
  }
  out.close();
}

void write_init_cmds(EniText& out, const std::vector<InitCmd>& cmds) {
  if (cmds.empty()) {
    return;
  }
  out.open("InitCmds");
  for (const auto& cmd : cmds) {
    write_init_cmd(out, cmd, "InitCmd");
  }
  out.close();
}

void write_cyclic(EniText& out, const CyclicTask& task) {
  if (task.frames.empty()) {
    return;
  }
  out.open("Cyclic");
  if (!task.comment.empty()) {
    out.text("Comment", task.comment);
  }
  // Whole microseconds; compile() reports a cycle that is none.
  if (task.cycle_time_given) {
    out.signed_number("CycleTime", (task.cycle_time + kMicrosecond / 2) / kMicrosecond);
  }
  if (task.priority) {
    out.signed_number("Priority", *task.priority);
  }
  if (!task.task_id.empty()) {
    out.text("TaskId", task.task_id);
  }
  for (const auto& frame : task.frames) {
    out.open("Frame");
    if (!frame.comment.empty()) {
      out.text("Comment", frame.comment);
    }
    for (const auto& cmd : frame.commands) {
      write_cyclic_cmd(out, cmd);
    }
    out.close();
  }
  out.close();
}

void write_process_image(EniText& out, const ProcessImage& image) {
  out.open("ProcessImage");
  write_variables(out, "Inputs", image.input_bytes, image.inputs);
  write_variables(out, "Outputs", image.output_bytes, image.outputs);
  out.close();
}

}  // namespace syncline::eni
