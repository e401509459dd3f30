// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "check/network_view.h"
#include "config/network_config.h"
#include "config/object_description.h"
#include "config/slave_config.h"

namespace syncline::checker {
namespace {

using ObjectKey = std::pair<std::uint16_t, std::uint8_t>;

/// Bytes of objects whose size a standard fixes: ETG.1000.6 tables 71 to 79 (lists of PDOs, synchronisation), ETG.1020
/// (0x10F1, 0x10F3, 0xF030), CiA 402 / ETG.6010. 0 = not fixed.
unsigned standard_size(std::uint16_t index, std::uint8_t sub_index) {
  const bool list = (index >= 0x1600 && index <= 0x17FF) || (index >= 0x1A00 && index <= 0x1BFF);
  if (list) return sub_index == 0 ? 1 : 4;
  if (index >= 0x1C10 && index <= 0x1C2F) return sub_index == 0 ? 1 : 2;
  if (index == 0x1C32 || index == 0x1C33) {
    constexpr std::uint8_t kType = 1, kCycle = 2, kShift = 3;
    return sub_index == kType ? 2 : sub_index == kCycle || sub_index == kShift ? 4 : 0;
  }
  if (index == 0x10F1) return sub_index == 2 ? 2 : 0;
  if (index == 0xF030) return sub_index == 0 ? 1 : 4;
  // Each axis of a drive has its objects 0x0800 behind those of the one before (ETG.6010, 8 axes).
  if (index < 0x6000 || index >= 0xA000) return 0;
  switch (0x6000 + (index - 0x6000) % 0x0800) {
    case 0x6040:
    case 0x6041:
      return sub_index == 0 ? 2 : 0;
    case 0x6060:
    case 0x6061:
      return sub_index == 0 ? 1 : 0;
    case 0x607A:
    case 0x6064:
    case 0x60FF:
      return sub_index == 0 ? 4 : 0;
    case 0x60C2:
      return sub_index == 1 || sub_index == 2 ? 1 : 0;
    default:
      return 0;
  }
}

/// Sizes that the file's own PDOs give: an entry of whole bytes maps the whole object. Where two differ, none counts.
std::map<ObjectKey, unsigned> mapped_sizes(const SlaveConfig& slave) {
  std::map<ObjectKey, unsigned> sizes;
  for (const ConfiguredPdo& pdo : slave.pdos) {
    for (const PdoEntry& entry : pdo.pdo.entries) {
      if (entry.index == 0 || entry.bit_length == 0) continue;
      const unsigned bytes = entry.bit_length % 8 == 0 ? entry.bit_length / 8U : 0;
      const auto [known, is_new] = sizes.emplace(ObjectKey{entry.index, entry.sub_index}, bytes);
      if (!is_new && known->second != bytes) known->second = 0;
    }
  }
  return sizes;
}

/// Sub-indices that objects of CiA 402 do not have: 0x60C2 has two, the others here are single values.
bool lacks_sub_index(std::uint16_t index, std::uint8_t sub_index) {
  if (index < 0x6000 || index >= 0xA000) return false;
  switch (0x6000 + (index - 0x6000) % 0x0800) {
    case 0x6040:
    case 0x6041:
    case 0x6060:
    case 0x6061:
    case 0x6064:
    case 0x607A:
    case 0x60FF:
      return sub_index > 0;
    case 0x60C2:
      return sub_index > 2;
    default:
      return false;
  }
}

bool is_drive(const SlaveConfig& slave) {
  constexpr std::uint16_t kDriveProfile = 402;
  return slave.mailbox && std::ranges::any_of(slave.mailbox->profiles, [](const ChannelProfile& profile) {
           return profile.profile_no == kDriveProfile;
         });
}

void check_downloads(const NetworkView& view, std::size_t slave, Findings& findings) {
  const SlaveConfig& config = view.config.slaves[slave];
  const auto mapped = mapped_sizes(config);
  const auto& commands = config.mailbox->coe_commands;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const StartupCommand& command = commands[i].command;
    if (!command.enabled || command.complete_access || command.data.empty()) continue;
    const auto entry = mapped.find({command.index, command.sub_index});
    const bool profile_object = command.index >= 0x6000 && command.index < 0xA000;
    if (is_drive(config) && lacks_sub_index(command.index, command.sub_index)) {
      findings.add("ENI-COE-09/sub-index", {PlaceKind::kCoeCmd, slave, i}, fig::hex<"object">(command.index),
                   fig::number<"sub_index">(command.sub_index));
      continue;
    }
    unsigned size = profile_object && !is_drive(config) ? 0 : standard_size(command.index, command.sub_index);
    if (size == 0 && entry != mapped.end()) size = entry->second;
    if (size != 0 && command.data.size() != size) {
      findings.add("ENI-COE-09", {PlaceKind::kCoeCmd, slave, i}, fig::hex<"object">(command.index),
                   fig::number<"sub_index">(command.sub_index), fig::count<"written">(command.data.size()),
                   fig::count<"bytes">(size));
    }
  }
}

}  // namespace

void check_coe_sizes(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    if (view.config.slaves[i].mailbox) check_downloads(view, i, findings);
  }
}

}  // namespace syncline::checker
