// SPDX-License-Identifier: Apache-2.0
#include "config/compile/mailbox_init_cmds.h"

#include <algorithm>
#include <charconv>

#include "protocol/eoe.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

constexpr int kSetIpParameter = static_cast<int>(eoe::Kind::kSetIpRequest);
constexpr std::size_t kHostNameBytes = 32;

/// `N` numbers 0..255 with dots.
template <std::size_t N>
std::optional<std::array<std::uint8_t, N>> dotted_bytes(std::string_view text) {
  std::array<std::uint8_t, N> bytes{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0 && (at == end || *at++ != '.')) return std::nullopt;
    const auto [behind, error] = std::from_chars(at, end, bytes[i]);
    if (error != std::errc{}) return std::nullopt;
    at = behind;
  }
  return at == end ? std::optional(bytes) : std::nullopt;
}

/// One fragment which is the last, no time stamp; then the service's data.
MailboxInitCmd eoe_message(int type, const std::vector<std::uint8_t>& data, std::vector<Transition> when, std::string comment) {
  MailboxInitCmd message;
  message.transitions = std::move(when);
  message.comment = std::move(comment);
  eoe::Header header;
  header.kind = static_cast<eoe::Kind>(type & 0x0F);
  header.last_fragment = true;
  message.data = eoe::encode(header);
  message.data.insert(message.data.end(), data.begin(), data.end());
  return message;
}

/// Data of "set IP parameter": a bit for each parameter that follows.
class IpParameters {
 public:
  IpParameters() { ByteWriter(data_).u32(0); }

  void add(unsigned bit, std::span<const std::uint8_t> bytes) {
    data_[0] = static_cast<std::uint8_t>(data_[0] | 1U << bit);
    data_.insert(data_.end(), bytes.begin(), bytes.end());
  }
  void add_address(unsigned bit, std::string_view text) {
    if (auto bytes = dotted_bytes<4>(text)) {
      std::ranges::reverse(*bytes);  // a 32-bit number, least significant byte first
      add(bit, *bytes);
    }
  }
  [[nodiscard]] bool empty() const { return data_[0] == 0; }
  [[nodiscard]] const std::vector<std::uint8_t>& data() const { return data_; }

 private:
  std::vector<std::uint8_t> data_;
};

IpParameters ip_parameters(const EoeSlaveSettings& eoe) {
  IpParameters parameters;
  if (eoe.mac) parameters.add(0, *eoe.mac);
  parameters.add_address(1, eoe.ip);
  parameters.add_address(2, eoe.subnet);
  parameters.add_address(3, eoe.gateway);
  parameters.add_address(4, eoe.dns);
  if (!eoe.host_name.empty()) {
    std::array<std::uint8_t, kHostNameBytes> name{};
    std::copy_n(eoe.host_name.begin(), std::min(eoe.host_name.size(), kHostNameBytes), name.begin());
    parameters.add(5, name);
  }
  return parameters;
}

void add_eoe(MailboxConfig& mailbox, const SlavePlan& slave) {
  const EoeSlaveSettings& eoe = slave.settings->eoe;
  mailbox.eoe_disabled = !eoe.enabled;
  if (!eoe.enabled) return;
  const IpParameters parameters = ip_parameters(eoe);
  for (const MailboxCommand& command : slave.device().mailbox->eoe_options.init_commands) {
    // The user's address replaces the one that the ESI sets.
    if (command.type == kSetIpParameter && !parameters.empty()) continue;
    mailbox.eoe_commands.push_back(eoe_message(command.type, command.data, command.transitions, command.comment));
  }
  if (!parameters.empty()) {
    mailbox.eoe_commands.push_back(
        eoe_message(kSetIpParameter, parameters.data(), {Transition::kIP}, "set IP parameter"));
  }
}

void add_soe(MailboxConfig& mailbox, const SlavePlan& slave) {
  for (const SoeCommand& command : slave.settings->soe_startup) {
    SoeInitCmd cmd;
    cmd.transitions = command.transitions;
    cmd.drive_no = command.drive;
    cmd.idn = command.idn;
    cmd.data = command.data;
    cmd.fixed = command.fixed;
    cmd.enabled = command.enabled;
    cmd.timeout_ms = command.timeout_ms;
    cmd.comment = command.comment;
    mailbox.soe_commands.push_back(std::move(cmd));
  }
}

void add_aoe(MailboxConfig& mailbox, const SlavePlan& slave) {
  mailbox.aoe_net_id = slave.settings->ams_net_id;
  for (const MailboxCommand& command : slave.device().mailbox->aoe_options.init_commands) {
    MailboxInitCmd cmd;
    cmd.transitions = command.transitions;
    cmd.data = command.data;
    cmd.comment = command.comment;
    mailbox.aoe_commands.push_back(std::move(cmd));
  }
}

}  // namespace

std::optional<std::array<std::uint8_t, 4>> ipv4_bytes(std::string_view text) { return dotted_bytes<4>(text); }

std::optional<std::array<std::uint8_t, 6>> ams_net_id_bytes(std::string_view text) { return dotted_bytes<6>(text); }

void add_mailbox_init_cmds(MailboxConfig& mailbox, const SlavePlan& slave) {
  if (mailbox.eoe) add_eoe(mailbox, slave);
  if (mailbox.soe) add_soe(mailbox, slave);
  if (mailbox.aoe) add_aoe(mailbox, slave);
}

}  // namespace syncline::compiler
