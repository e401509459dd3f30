// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "check/network_view.h"
#include "config/command_text.h"
#include "config/network_config.h"
#include "protocol/frame.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

void check_sizes(const NetworkView& view, Findings& findings) {
  const auto& tasks = view.config.cyclic;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    for (std::size_t f = 0; f < tasks[t].frames.size(); ++f) {
      std::uint64_t bytes = 0;
      for (const CyclicCmd& cmd : tasks[t].frames[f].commands) {
        bytes += kDatagramOverhead + std::max<std::uint64_t>(cmd.length(), cmd.data.size());
      }
      if (bytes > kMaxDatagramBytes) {
        findings.add("ENI-FRM-01", {PlaceKind::kFrame, t, f}, fig::count<"bytes">(bytes),
                     fig::count<"most">(kMaxDatagramBytes));
      }
    }
  }
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const auto& commands = view.config.slaves[i].init_cmds;
    for (std::size_t c = 0; c < commands.size(); ++c) {
      const auto length = std::max<std::size_t>(commands[c].length(), commands[c].data.size());
      if (length > kMaxDatagramData) {
        findings.add("ENI-FRM-01/command", {PlaceKind::kSlaveInitCmd, i, c}, fig::count<"bytes">(length),
                     fig::count<"most">(kMaxDatagramData));
      } else if (length == 0 && commands[c].command != Command::kNop) {
        findings.add("ENI-FRM-02", {PlaceKind::kSlaveInitCmd, i, c}, fig::text<"command">(address_text(commands[c])));
      }
    }
  }
  for (const CyclicPlace& cyclic : view.cyclic) {
    if (cyclic.cmd->length() == 0 && cyclic.cmd->command != Command::kNop) {
      findings.add("ENI-FRM-02", cyclic.place(), fig::text<"command">(address_text(*cyclic.cmd)));
    }
  }
}

/// Two commands that carry the same logical bytes in the same direction.
void check_twice(const NetworkView& view, bool inputs, Findings& findings) {
  std::vector<OwnedRange> ranges;
  for (std::size_t i = 0; i < view.cyclic.size(); ++i) {
    const CyclicCmd& cmd = *view.cyclic[i].cmd;
    if (cmd.command == Command::kLrw || cmd.command == (inputs ? Command::kLrd : Command::kLwr)) {
      ranges.push_back({logical_bytes(cmd), i});
    }
  }
  for (const auto& [first, second] : overlaps(ranges)) {
    const CyclicPlace& one = view.cyclic[ranges[first].owner];
    const CyclicPlace& other = view.cyclic[ranges[second].owner];
    const bool together = std::ranges::any_of(one.cmd->states, [&](AlState state) { return has(*other.cmd, state); });
    // An LRW that meets an LRW carries both directions twice: once is enough to say so.
    const bool said = !inputs && one.cmd->command == Command::kLrw && other.cmd->command == Command::kLrw;
    if (together && !said) {
      findings.add("ENI-FRM-04", other.place(), fig::text<"first">(address_text(*one.cmd)),
                   fig::text<"second">(address_text(*other.cmd)), fig::phrase<"data">(inputs ? "inputs" : "outputs"));
    }
  }
}

void check_status(const NetworkView& view, Findings& findings) {
  const bool read = std::ranges::any_of(view.cyclic, [](const CyclicPlace& cyclic) {
    return cyclic.cmd->command == Command::kBrd && cyclic.cmd->ado == reg::kAlStatus;
  });
  if (!view.cyclic.empty() && !read) {
    findings.add("ENI-FRM-03", {PlaceKind::kTask, 0});
  }
}

void check_copies(const NetworkView& view, Findings& findings) {
  const std::uint64_t inputs = std::uint64_t{view.config.image.input_bytes} * 8;
  const std::uint64_t outputs = std::uint64_t{view.config.image.output_bytes} * 8;
  for (const CyclicPlace& cyclic : view.cyclic) {
    for (const CopyInfo& copy : cyclic.cmd->copy_infos) {
      if (std::uint64_t{copy.source_bit} + copy.bit_size > inputs ||
          std::uint64_t{copy.destination_bit} + copy.bit_size > outputs) {
        findings.add("ENI-IMG-11", cyclic.place(), fig::count<"bits">(copy.bit_size),
                     fig::number<"from">(copy.source_bit), fig::number<"to">(copy.destination_bit),
                     fig::number<"inputs">(inputs), fig::number<"outputs">(outputs));
      }
    }
  }
}

}  // namespace

void check_frames(const NetworkView& view, Findings& findings) {
  check_sizes(view, findings);
  check_twice(view, true, findings);
  check_twice(view, false, findings);
  check_status(view, findings);
  check_copies(view, findings);
}

}  // namespace syncline::checker
