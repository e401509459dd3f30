// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "check/network_view.h"
#include "config/mailbox_config.h"
#include "config/master_config.h"
#include "config/network_config.h"
#include "protocol/frame.h"
#include "protocol/registers.h"

namespace syncline::checker {
namespace {

constexpr std::uint16_t kSmallestCoeMailbox = 16;  // header, CoE header, an expedited SDO
constexpr auto kLargestDatagram = static_cast<std::uint16_t>(kMaxDatagramData);

class MailboxCheck {
 public:
  MailboxCheck(const NetworkView& view, std::size_t slave, Findings& findings)
      : view_(view), slave_(slave), mailbox_(*view.config.slaves[slave].mailbox), findings_(findings) {}

  void run() {
    check_protocols();
    if (mailbox_.status_bit_address) {
      check_status_bit(*mailbox_.status_bit_address);
    } else if (!mailbox_.poll_time_ms) {
      add("ENI-MBX-05");
    }
    check_memory();
  }

 private:
  void check_memory() {
    const bool sends = check_channel(mailbox_.send, "Send");
    const bool receives = check_channel(mailbox_.receive, "Recv");
    if (sends && receives && range(mailbox_.send).overlaps(range(mailbox_.receive))) {
      return add("ENI-MBX-02", fig::hex<"send">(mailbox_.send.start), fig::count<"send_bytes">(mailbox_.send.length),
                 fig::hex<"receive">(mailbox_.receive.start), fig::count<"receive_bytes">(mailbox_.receive.length));
    }
    if (sends) check_manager(0, mailbox_.send, "Send");
    if (receives) check_manager(1, mailbox_.receive, "Recv");
  }

  template <FigureName... kNames>
  void add(Sentence<kNames...> code, Named<kNames>... figures) {
    findings_.add<kNames...>(code, {PlaceKind::kMailbox, slave_}, std::move(figures)...);
  }
  static Range range(const MailboxChannel& channel) {
    return {channel.start, std::uint64_t{channel.start} + channel.length};
  }

  bool check_channel(const MailboxChannel& channel, const char* name) {
    if (channel.length >= kSmallestCoeMailbox && channel.length <= kLargestDatagram && channel.start >= 0x0F00) {
      return true;
    }
    add("ENI-MBX-01", fig::text<"element">(name), fig::count<"bytes">(channel.length),
        fig::hex<"start">(channel.start));
    return false;
  }

  /// The init command on IP sets the SyncManager to what the mailbox element says.
  void check_manager(unsigned number, const MailboxChannel& channel, const char* name) {
    const SyncManagerWrite* write = view_.registers[slave_].manager(number);
    if (write == nullptr) {
      if (!view_.config.slaves[slave_].init_cmds.empty()) {
        add("ENI-MBX-03", fig::number<"manager">(number), fig::text<"element">(name));
      }
      return;
    }
    const ConfigPlace place{PlaceKind::kSlaveInitCmd, slave_, write->cmd};
    const SyncManager& manager = write->manager;
    if (manager.start != channel.start || manager.length != channel.length) {
      findings_.add("ENI-MBX-04", place, fig::number<"manager">(number), fig::count<"bytes">(manager.length),
                    fig::hex<"start">(manager.start), fig::text<"element">(name),
                    fig::count<"said_bytes">(channel.length), fig::hex<"said_start">(channel.start));
    }
    if (!manager.is_mailbox() || manager.ecat_writes() != (number == 0)) {
      findings_.add("ENI-MBX-09", place, fig::hex<"control">(manager.control, 2), fig::number<"manager">(number),
                    fig::phrase<"use">(number == 0 ? "requests" : "answers"));
    }
  }

  void check_protocols() {
    const bool any = mailbox_.aoe || mailbox_.eoe || mailbox_.coe || mailbox_.foe || mailbox_.soe || mailbox_.voe;
    const bool coe_missing = !mailbox_.coe && !mailbox_.coe_commands.empty();
    const bool soe_missing = !mailbox_.soe && !mailbox_.soe_commands.empty();
    if (coe_missing || soe_missing) {
      add("ENI-MBX-06", fig::text<"protocol">(coe_missing ? "CoE" : "SoE"));
    } else if (!any) {
      add("ENI-MBX-10");
    }
  }

  /// The status bit is counted, mapped by an FMMU and read cyclically.
  void check_status_bit(std::uint32_t bit) {
    const MasterConfig& master = view_.config.master;
    const std::uint64_t logical = std::uint64_t{master.mailbox_state_start} * 8 + bit;
    const bool mapped = std::ranges::any_of(view_.registers[slave_].fmmus, [&](const FmmuWrite& write) {
      return write.fmmu.read && logical_bits(write.fmmu).begin == logical &&
             write.fmmu.physical_start < reg::kSyncManager + 0x80;
    });
    const bool read = std::ranges::any_of(view_.cyclic, [&](const CyclicPlace& cyclic) {
      return (cyclic.cmd->command == Command::kLrd || cyclic.cmd->command == Command::kLrw) &&
             has(*cyclic.cmd, AlState::kPreop) && logical_bytes(*cyclic.cmd).contains({logical / 8, logical / 8 + 1});
    });
    if (bit >= master.mailbox_state_count.value_or(0)) {
      add("ENI-MBX-07", fig::number<"bit">(bit), fig::count<"counted">(master.mailbox_state_count.value_or(0)));
    } else if (!mapped) {
      add("ENI-MBX-07/unmapped", fig::number<"bit">(bit));
    } else if (!read) {
      add("ENI-MBX-07/unread", fig::number<"bit">(bit));
    }
  }

  const NetworkView& view_;
  std::size_t slave_;
  const MailboxConfig& mailbox_;
  Findings& findings_;
};

}  // namespace

void check_mailboxes(const NetworkView& view, Findings& findings) {
  std::unordered_map<std::uint32_t, std::size_t> bits;
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const auto& mailbox = view.config.slaves[i].mailbox;
    if (!mailbox) continue;
    MailboxCheck(view, i, findings).run();
    if (!mailbox->status_bit_address) continue;
    if (const auto [it, is_new] = bits.emplace(*mailbox->status_bit_address, i); !is_new) {
      findings.add("ENI-MBX-08", {PlaceKind::kMailbox, i}, fig::number<"bit">(*mailbox->status_bit_address),
                   view.slave<"slave">(it->second));
    }
  }
}

}  // namespace syncline::checker
