// SPDX-License-Identifier: Apache-2.0
#include "config/compile/cyclic_frames.h"

#include <algorithm>

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

  /// Drift compensation. The NOP keeps room for a latch of the receive times; masters that measure the propagation delay
  /// again while running turn it into a write.
  void append_dc(std::vector<CyclicCmd>& out) const {
    if (!options_.reference_clock) {
      return;
    }
    const std::uint16_t clock = *options_.reference_clock;
    const std::uint16_t length = options_.system_time_64bit ? 8 : 4;
    out.push_back(read(Command::kNop, 0, reg::kReceiveTimePort0, 4, "DC: room for receive time latch"));
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
  static CyclicCmd read(Command command, std::uint16_t adp, std::uint16_t ado, std::uint16_t length, std::string comment) {
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

/// All commands in order; `process_data` gets the index of the first process-data command.
std::vector<CyclicCmd> command_sequence(const ImageLayout& image, const CyclicOptions& options,
                                        std::size_t& process_data) {
  const ServiceCommands service(options);
  std::vector<CyclicCmd> commands;
  if (options.dialect == EniDialect::kEcEngineer) {
    commands.push_back(service.al_status());
  }
  service.append_dc(commands);
  service.append_mailbox_states(commands);
  process_data = commands.size();
  for (const auto& datagram : image.datagrams) {
    commands.push_back(ServiceCommands::process_data(datagram));
  }
  service.append_sync_window(commands);
  if (options.dialect == EniDialect::kTwinCat) {
    commands.push_back(service.al_status());
  }
  return commands;
}

std::uint32_t size_on_wire(const CyclicCmd& cmd) { return kDatagramOverhead + cmd.length(); }

std::vector<CyclicFrame> split_into_frames(const std::vector<CyclicCmd>& commands) {
  std::vector<CyclicFrame> frames;
  std::uint32_t used = kMaxDatagramBytes;
  for (const CyclicCmd& cmd : commands) {
    if (frames.empty() || used + size_on_wire(cmd) > kMaxDatagramBytes) {
      frames.emplace_back();
      used = 0;
    }
    frames.back().commands.push_back(cmd);
    used += size_on_wire(cmd);
  }
  return frames;
}

/// Data offsets: process data from 0 as in the logical area, the rest behind it in command order.
void set_data_offsets(CyclicLayout& layout, const ImageLayout& image) {
  const auto is_process_data = [](const CyclicCmd& cmd) {
    return is_logical(cmd.command) && cmd.logical_address != kMailboxStateLogicalBase;
  };
  std::uint32_t end = 0;
  for (const auto& datagram : image.datagrams) {
    const std::uint32_t offset = datagram.logical_address - kEcEngineerLogicalBase;
    layout.data_offsets.push_back(offset);
    end = std::max(end, offset + datagram.length);
  }
  std::size_t next = 0;
  for (auto& frame : layout.frames) {
    for (auto& cmd : frame.commands) {
      const std::uint32_t offset = is_process_data(cmd) ? layout.data_offsets[next++] : end;
      if (!is_process_data(cmd)) {
        end += cmd.length();
      }
      cmd.input_offset = cmd.output_offset = offset;
    }
  }
  layout.image_bytes = end;
}

/// Header offsets: where the datagram stands in its Ethernet frame, one image page a frame.
void set_header_offsets(CyclicLayout& layout, std::size_t first_process_data, std::size_t process_data_count) {
  std::size_t index = 0;
  std::uint32_t page = 0;
  for (auto& frame : layout.frames) {
    std::uint32_t offset = page + kEthernetAndEtherCatHeader;
    for (auto& cmd : frame.commands) {
      cmd.input_offset = cmd.output_offset = offset;
      if (index >= first_process_data && index < first_process_data + process_data_count) {
        layout.data_offsets.push_back(offset + kHeaderToData);
      }
      offset += size_on_wire(cmd);
      ++index;
    }
    page += kTwinCatImageBytes;
  }
  layout.image_bytes = page;
  layout.command_data_offset = kHeaderToData;
}

}  // namespace

std::uint16_t max_process_data_length(const CyclicOptions& options) {
  std::size_t ignored = 0;
  std::uint32_t others = kDatagramOverhead;
  for (const CyclicCmd& cmd : command_sequence({}, options, ignored)) {
    others += size_on_wire(cmd);
  }
  return static_cast<std::uint16_t>(kMaxDatagramBytes - others);
}

CyclicLayout cyclic_frames(const ImageLayout& image, const CyclicOptions& options) {
  std::size_t first_process_data = 0;
  CyclicLayout layout;
  layout.frames = split_into_frames(command_sequence(image, options, first_process_data));
  if (options.dialect == EniDialect::kEcEngineer) {
    set_data_offsets(layout, image);
  } else {
    set_header_offsets(layout, first_process_data, image.datagrams.size());
  }
  return layout;
}

Nanoseconds wire_time(const CyclicFrame& frame) {
  constexpr std::uint32_t kMinimumPayload = 46;
  constexpr std::uint32_t kAroundPayload = 8 + 14 + 4 + 12;  // preamble, Ethernet header, FCS, gap
  constexpr Nanoseconds kByteTime = 80;
  std::uint32_t payload = 2;
  for (const auto& cmd : frame.commands) {
    payload += size_on_wire(cmd);
  }
  return (std::max(payload, kMinimumPayload) + kAroundPayload) * kByteTime;
}

}  // namespace syncline::compiler
