// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/mailbox_bits.h"

#include <algorithm>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "master/exchange/mailbox_handshake.h"
#include "master/exchange/slave_mailbox.h"
#include "protocol/fmmu.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {
namespace {

constexpr std::uint16_t kFmmuEnd = reg::fmmu(16);

}  // namespace

std::optional<LogicalBit> mailbox_state_bit(const SlaveConfig& slave) {
  if (!slave.mailbox) return std::nullopt;
  for (const auto& command : slave.init_cmds) {
    if (is_logical(command.command) || command.ado < reg::fmmu(0) || command.ado >= kFmmuEnd) continue;
    // A command may set several FMMUs.
    const std::span<const std::uint8_t> data(command.data);
    for (std::size_t at = 0; at + Fmmu::kSize <= data.size(); at += Fmmu::kSize) {
      const auto fmmu = Fmmu::decode(data.subspan(at).first<Fmmu::kSize>());
      if (!fmmu.active || !fmmu.read || fmmu.physical_start != kSm1Status || fmmu.logical_start_bit > 7) continue;
      return LogicalBit{fmmu.logical_start, fmmu.logical_start_bit};
    }
  }
  return std::nullopt;
}

MailboxBits::MailboxBits(const NetworkConfig& config, const Snapshot& snapshot, std::span<SlaveMailbox> mailboxes,
                         const CyclicFrameSet& frames)
    : snapshot_(snapshot), mailboxes_(mailboxes), frames_(frames) {
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto bit = mailbox_state_bit(config.slaves[i]);
    const auto byte = bit ? frames.find_logical(bit->address) : std::nullopt;
    if (byte) places_.push_back({i, *byte, static_cast<std::uint8_t>(1U << bit->bit)});
  }
}

void MailboxBits::observe() {
  std::optional<std::size_t> entry;  // that `bytes` are of: mostly all bits are in one
  std::span<const std::uint8_t> bytes;
  for (const auto& place : places_) {
    if (place.byte.entry != entry) {
      entry = place.byte.entry;
      bytes = frames_.read_logical(place.byte.entry);
    }
    const bool known = !bytes.empty() && snapshot_.slaves[place.slave].present;
    mailboxes_[place.slave].full = known ? std::optional((bytes[place.byte.offset] & place.mask) != 0) : std::nullopt;
  }
}

bool MailboxBits::has(std::size_t slave) const {
  return std::ranges::find(places_, slave, &Place::slave) != places_.end();
}

}  // namespace syncline
