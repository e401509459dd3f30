// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "check/network_view.h"
#include "config/command_text.h"
#include "config/network_config.h"

/// The same data are named three times: by an FMMU, by the cyclic command that carries it, and by Send or Recv.
namespace syncline::checker {
namespace {

bool reads(Command c) { return c == Command::kLrd || c == Command::kLrw; }

/// Image bytes of a command's data; in the frame images of TwinCAT it lies behind the datagram header.
Range image_bytes(const NetworkView& view, const CyclicCmd& cmd, std::uint32_t offset) {
  const std::uint64_t begin = std::uint64_t{offset} + view.config.image.command_data_offset;
  return {begin, begin + cmd.length()};
}

void check_commands(const NetworkView& view, bool inputs, std::uint32_t size, Findings& findings) {
  std::vector<OwnedRange> ranges;
  for (std::size_t i = 0; i < view.cyclic.size(); ++i) {
    const CyclicCmd& cmd = *view.cyclic[i].cmd;
    if (!is_logical(cmd.command) || (inputs ? cmd.command == Command::kLwr : cmd.command == Command::kLrd)) continue;
    const Range bytes = image_bytes(view, cmd, inputs ? cmd.input_offset : cmd.output_offset);
    ranges.push_back({bytes, i});
    if (bytes.end > size) {
      findings.add("ENI-IMG-08", view.cyclic[i].place(), fig::phrase<"data">(inputs ? "inputs" : "outputs"),
                   fig::number<"first">(bytes.begin), fig::number<"last">(bytes.end), fig::number<"image">(size));
    }
  }
  for (const auto& [first, second] : overlaps(ranges)) {
    findings.add("ENI-IMG-09", view.cyclic[ranges[second].owner].place(),
                 fig::phrase<"data">(inputs ? "inputs" : "outputs"),
                 fig::text<"command">(address_text(*view.cyclic[ranges[first].owner].cmd)));
  }
}

/// Where the commands put logical addresses in the image, for one direction.
class LogicalToImage {
 public:
  LogicalToImage(const NetworkView& view, bool inputs) {
    for (const CyclicPlace& cyclic : view.cyclic) {
      const CyclicCmd& cmd = *cyclic.cmd;
      if (!is_logical(cmd.command) || (inputs ? !reads(cmd.command) : cmd.command == Command::kLrd)) continue;
      const Range image = image_bytes(view, cmd, inputs ? cmd.input_offset : cmd.output_offset);
      pieces_.push_back({logical_bytes(cmd), image.begin});
    }
    std::ranges::stable_sort(pieces_, {}, [](const Piece& piece) { return piece.logical.begin; });
  }

  /// Image bit of a logical bit; nothing when no command carries it.
  [[nodiscard]] std::optional<std::uint64_t> image_bit(std::uint64_t logical_bit) const {
    auto piece = std::ranges::upper_bound(pieces_, logical_bit / 8, {}, [](const Piece& p) { return p.logical.begin; });
    if (piece == pieces_.begin() || (--piece)->logical.end <= logical_bit / 8) return std::nullopt;
    return (piece->image + logical_bit / 8 - piece->logical.begin) * 8 + logical_bit % 8;
  }

 private:
  struct Piece {
    Range logical;
    std::uint64_t image = 0;
  };
  std::vector<Piece> pieces_;
};

/// The "mailbox full" bit lies among the registers of the SyncManagers; other mapped registers are process data.
bool is_mailbox_state(const Fmmu& fmmu) {
  constexpr std::uint16_t kBegin = 0x0800, kEnd = 0x0900;
  return fmmu.physical_start >= kBegin && fmmu.physical_start < kEnd;
}

void check_direction(const NetworkView& view, bool inputs, Findings& findings) {
  const LogicalToImage map(view, inputs);
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const auto& range = inputs ? view.config.slaves[i].receive : view.config.slaves[i].send;
    if (!range) continue;
    std::optional<std::uint64_t> first;
    for (const FmmuWrite& write : view.registers[i].fmmus) {
      if ((inputs ? write.fmmu.read : write.fmmu.write) && !is_mailbox_state(write.fmmu)) {
        const auto bit = map.image_bit(logical_bits(write.fmmu).begin);
        if (bit) first = std::min(first.value_or(*bit), *bit);
      }
    }
    if (first && *first != range->bit_start) {
      findings.add("ENI-IMG-10", {PlaceKind::kSlave, i}, fig::text<"element">(inputs ? "Recv" : "Send"),
                   fig::number<"said">(range->bit_start), fig::number<"computed">(*first));
    }
  }
}

}  // namespace

void check_image_places(const NetworkView& view, Findings& findings) {
  check_commands(view, true, view.config.image.input_bytes, findings);
  check_commands(view, false, view.config.image.output_bytes, findings);
  check_direction(view, true, findings);
  check_direction(view, false, findings);
}

}  // namespace syncline::checker
