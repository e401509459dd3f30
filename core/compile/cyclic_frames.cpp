// SPDX-License-Identifier: Apache-2.0
#include "compile/cyclic_frames.h"

#include <algorithm>

#include "protocol/frame.h"
#include "protocol/registers.h"

namespace syncline::compiler {
namespace {

constexpr std::uint32_t kEthernetAndEtherCatHeader = 16;
constexpr std::uint32_t kHeaderToData = 10;
constexpr std::uint32_t kTwinCatImageBytes = 1536;  // a frame

/// Commands that exchange no process data.
class ServiceCommands {
 public:
  explicit ServiceCommands(const CyclicOptions& options) : options_(options) {}

  [[nodiscard]] CyclicCmd al_status() const {
    CyclicCmd cmd = read(Command::kBrd, 0, reg::kAlStatus, 2, "AL status of all slaves");
    cmd.expected_wkc = options_.slave_count;
    return cmd;
  }

  /// Drift compensation. The NOP keeps room for a latch of the receive times; masters that measure the propagation
  /// delay again while running turn it into a write.
  void append_dc(std::vector<CyclicCmd>& out) const {
    if (!options_.reference_clock) {
      return;
    }
    const std::uint16_t clock = *options_.reference_clock;
    const std::uint16_t length = options_.system_time_64bit ? 8 : 4;
    if (options_.latch_receive_times) {
      out.push_back(read(Command::kBwr, 0, reg::kReceiveTimePort0, 4, "DC: latch receive times"));
    } else {
      out.push_back(read(Command::kNop, 0, reg::kReceiveTimePort0, 4, "DC: room for receive time latch"));
    }
    out.push_back(read(Command::kArmw, clock, reg::kSystemTime, length, "DC: distribute reference time"));
    if (options_.bus_shift) {
      out.push_back(read(Command::kApwr, clock, reg::kSystemTime, 4, "DC: steer reference clock (bus shift)"));
    }
  }

  void append_mailbox_states(std::vector<CyclicCmd>& out) const {
    if (options_.mailbox_state_count == 0) {
      return;
    }
    CyclicCmd cmd = read(Command::kLrd, 0, 0, mailbox_state_length(), "mailbox states");
    cmd.logical_address = kMailboxStateLogicalBase;
    out.push_back(std::move(cmd));
  }

  void append_sync_window(std::vector<CyclicCmd>& out) const {
    if (options_.reference_clock && options_.sync_window) {
      CyclicCmd cmd = read(Command::kBrd, 0, reg::kSystemTimeDifference, 4, "DC: sync window");
      cmd.states = {AlState::kSafeop, AlState::kOp};
      out.push_back(std::move(cmd));
    }
  }

  [[nodiscard]] static CyclicCmd process_data(const LogicalDatagram& datagram) {
    CyclicCmd cmd = read(datagram.command, 0, 0, datagram.length, "process data");
    cmd.states = {AlState::kSafeop, AlState::kOp};
    cmd.logical_address = datagram.logical_address;
    cmd.expected_wkc = datagram.expected_wkc;
    return cmd;
  }

 private:
  static CyclicCmd read(Command command, std::uint16_t adp, std::uint16_t ado, std::uint16_t length,
                        std::string comment) {
    CyclicCmd cmd;
    cmd.states = {AlState::kPreop, AlState::kSafeop, AlState::kOp};
    cmd.comment = std::move(comment);
    cmd.command = command;
    cmd.adp = adp;
    cmd.ado = ado;
    cmd.data_length = length;
    return cmd;
  }

  [[nodiscard]] std::uint16_t mailbox_state_length() const {
    const auto bytes = static_cast<std::uint16_t>((options_.mailbox_state_count + 7U) / 8U);
    return options_.dialect == EniDialect::kEcEngineer ? static_cast<std::uint16_t>((bytes + 1U) / 2U * 2U) : bytes;
  }

  const CyclicOptions& options_;
};

/// A command and the datagram of the image that it carries, if it carries one.
struct Placed {
  CyclicCmd command;
  std::optional<std::size_t> datagram{};
};

void append_process_data(std::vector<Placed>& out, const ImageLayout& image, std::size_t task) {
  for (std::size_t i = 0; i < image.datagrams.size(); ++i) {
    if (image.datagrams[i].task == task) out.push_back({ServiceCommands::process_data(image.datagrams[i]), i});
  }
}

/// All commands of the base task in order.
std::vector<Placed> command_sequence(const ImageLayout& image, const CyclicOptions& options) {
  const ServiceCommands service(options);
  std::vector<CyclicCmd> before, after;
  (options.dialect == EniDialect::kEcEngineer ? before : after).push_back(service.al_status());
  service.append_dc(before);
  service.append_mailbox_states(before);
  std::vector<CyclicCmd> window;
  service.append_sync_window(window);
  std::vector<Placed> commands;
  for (auto& cmd : before) commands.push_back({std::move(cmd)});
  append_process_data(commands, image, 0);
  for (auto* tail : {&window, &after}) {
    for (auto& cmd : *tail) commands.push_back({std::move(cmd)});
  }
  return commands;
}

std::size_t size_on_wire(const CyclicCmd& cmd) { return kDatagramOverhead + cmd.length(); }

using PlacedFrame = std::vector<Placed>;

std::vector<PlacedFrame> split_into_frames(std::vector<Placed> commands) {
  std::vector<PlacedFrame> frames;
  std::size_t used = kMaxDatagramBytes;
  for (Placed& placed : commands) {
    const std::size_t size = size_on_wire(placed.command);
    if (frames.empty() || used + size > kMaxDatagramBytes) {
      frames.emplace_back();
      used = 0;
    }
    frames.back().push_back(std::move(placed));
    used += size;
  }
  return frames;
}

/// Data offsets: process data from 0 as in the logical area, the rest behind it in command order.
void set_data_offsets(CyclicLayout& layout, std::vector<PlacedFrame>& frames, const ImageLayout& image,
                      std::uint32_t logical_base) {
  std::uint32_t end = 0;
  for (const auto& datagram : image.datagrams) {
    const std::uint32_t offset = datagram.logical_address - logical_base;
    layout.data_offsets.push_back(offset);
    end = std::max(end, offset + datagram.length);
  }
  for (auto& frame : frames) {
    for (auto& [cmd, datagram] : frame) {
      cmd.input_offset = cmd.output_offset = datagram ? layout.data_offsets[*datagram] : end;
      if (!datagram) end += cmd.length();
    }
  }
  layout.image_bytes = end;
}

/// Header offsets: where the datagram stands in its Ethernet frame, one image page a frame.
void set_header_offsets(CyclicLayout& layout, std::vector<PlacedFrame>& frames, std::size_t datagram_count) {
  layout.data_offsets = std::vector<std::uint32_t>(datagram_count, 0);
  std::uint32_t page = 0;
  for (auto& frame : frames) {
    std::uint32_t offset = page + kEthernetAndEtherCatHeader;
    for (auto& [cmd, datagram] : frame) {
      cmd.input_offset = cmd.output_offset = offset;
      if (datagram) layout.data_offsets[*datagram] = offset + kHeaderToData;
      offset += size_on_wire(cmd);
    }
    page += kTwinCatImageBytes;
  }
  layout.image_bytes = page;
  layout.command_data_offset = kHeaderToData;
}

std::size_t task_count(const ImageLayout& image) {
  std::size_t count = 1;
  for (const auto& datagram : image.datagrams) count = std::max(count, datagram.task + 1);
  return count;
}

CyclicFrame take(PlacedFrame& placed) {
  CyclicFrame frame;
  for (Placed& command : placed) frame.commands.push_back(std::move(command.command));
  return frame;
}

}  // namespace

std::uint16_t max_process_data_length(const CyclicOptions& options) {
  std::size_t others = kDatagramOverhead;
  for (const Placed& placed : command_sequence({}, options)) others += size_on_wire(placed.command);
  return static_cast<std::uint16_t>(kMaxDatagramBytes - others);
}

CyclicLayout cyclic_frames(const ImageLayout& image, const CyclicOptions& options) {
  const std::size_t tasks = task_count(image);
  std::vector<PlacedFrame> frames;
  std::vector<std::size_t> ends;  // of each task's frames
  for (std::size_t task = 0; task < tasks; ++task) {
    std::vector<Placed> commands;
    if (task == 0) {
      commands = command_sequence(image, options);
    } else {
      append_process_data(commands, image, task);
    }
    for (auto& frame : split_into_frames(std::move(commands))) frames.push_back(std::move(frame));
    ends.push_back(frames.size());
  }
  CyclicLayout layout;
  if (options.dialect == EniDialect::kEcEngineer) {
    set_data_offsets(layout, frames, image, options.logical_base);
  } else {
    set_header_offsets(layout, frames, image.datagrams.size());
  }
  layout.slower.resize(tasks - 1);
  std::size_t task = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    while (i >= ends[task]) ++task;
    (task == 0 ? layout.frames : layout.slower[task - 1]).push_back(take(frames[i]));
  }
  return layout;
}

}  // namespace syncline::compiler
