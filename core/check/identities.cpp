// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "check/network_view.h"
#include "config/command_text.h"
#include "config/identity.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "protocol/registers.h"
#include "support/le_number.h"

namespace syncline::checker {
namespace {

/// Words of the SII that say who a slave is (ETG.1000.6, table 16), and what Info says about them.
struct IdentityField {
  std::uint16_t word;
  const char* name;
  std::uint32_t Identity::*member;
};
constexpr IdentityField kFields[] = {{0x08, "VendorId", &Identity::vendor_id},
                                     {0x0A, "ProductCode", &Identity::product_code},
                                     {0x0C, "RevisionNo", &Identity::revision_no},
                                     {0x0E, "SerialNo", &Identity::serial_no}};

/// A file leaves the serial number 0 where any will do, and what is missing is told by the structure.
bool is_said(const IdentityField& field, const Identity& identity) { return identity.*field.member != 0; }

/// Bytes of a field that are read from `word` on.
struct Part {
  const IdentityField* field = nullptr;
  unsigned shift = 0;
};
Part part_at(std::uint16_t word) {
  for (const IdentityField& field : kFields) {
    if (word == field.word || word == field.word + 1) return {&field, word == field.word ? 0U : 16U};
  }
  return {};
}

/// The field whose number a command expects in a word that is none of it.
const IdentityField* field_with(const InitCmdValidate& expected, const Identity& identity) {
  if (expected.data.size() != 4 || std::ranges::any_of(expected.mask, [](auto byte) { return byte != 0xFF; }))
    return nullptr;
  const auto* found = std::ranges::find_if(kFields, [&](const IdentityField& field) {
    return is_said(field, identity) && identity.*field.member == le_number(expected.data);
  });
  return found == std::end(kFields) ? nullptr : found;
}

/// Follows the reads of the EEPROM on one transition and compares what they expect with Info.
void check_identity(const NetworkView& view, std::size_t slave, Findings& findings) {
  const SlaveConfig& config = view.config.slaves[slave];
  std::optional<std::uint16_t> word;
  for (std::size_t i = 0; i < config.init_cmds.size(); ++i) {
    const InitCmd& cmd = config.init_cmds[i];
    if (!has_transition(cmd, Transition::kIP)) continue;
    if (const auto control = written_number(cmd, reg::kSiiControl, 2); control && (*control & kSiiRead) != 0) {
      if (const auto address = written_number(cmd, reg::kSiiAddress, 2)) word = static_cast<std::uint16_t>(*address);
    }
    if (!word || cmd.ado != reg::kSiiData || is_logical(cmd.command) || writes(cmd.command) || !cmd.validate) continue;
    const InitCmdValidate& expected = *cmd.validate;
    const Part part = part_at(*word);
    if (const auto* other = part.field == nullptr ? field_with(expected, config.identity) : nullptr) {
      findings.add("ENI-REF-10/elsewhere", {PlaceKind::kSlaveInitCmd, slave, i},
                   fig::text<"field">(std::string(other->name)), fig::hex<"word">(*word), fig::hex<"own">(other->word));
    }
    if (part.field == nullptr || expected.type != ValidateType::kEqual || !is_said(*part.field, config.identity)) {
      continue;
    }
    const std::uint32_t said = config.identity.*part.field->member >> part.shift;
    for (std::size_t b = 0; b < expected.data.size() && b < (32U - part.shift) / 8; ++b) {
      const std::uint8_t mask = b < expected.mask.size() ? expected.mask[b] : expected.mask.empty() ? 0xFF : 0;
      if (((expected.data[b] ^ said >> (8 * b)) & mask) == 0) continue;
      findings.add(
          "ENI-REF-10", {PlaceKind::kSlaveInitCmd, slave, i}, fig::text<"field">(std::string(part.field->name)),
          fig::hex<"said">(config.identity.*part.field->member, 8), fig::text<"expected">(hex_text(expected.data)));
      break;
    }
  }
}

struct ExpectedAlias {
  std::uint16_t alias = 0;
  std::size_t cmd = 0;
};

/// The alias that a command on the way to PREOP expects in 0x0012; 0 is that of slaves that have none.
std::optional<ExpectedAlias> expected_alias(const SlaveConfig& config) {
  for (std::size_t i = 0; i < config.init_cmds.size(); ++i) {
    const InitCmd& cmd = config.init_cmds[i];
    if (!has_transition(cmd, Transition::kIP) || cmd.ado != reg::kStationAlias || is_logical(cmd.command) ||
        writes(cmd.command) || !cmd.validate || cmd.validate->type != ValidateType::kEqual ||
        cmd.validate->data.size() != 2 ||
        std::ranges::any_of(cmd.validate->mask, [](auto byte) { return byte != 0xFF; })) {
      continue;
    }
    const auto alias = le_number(cmd.validate->data);
    if (alias != 0) return ExpectedAlias{static_cast<std::uint16_t>(alias), i};
  }
  return std::nullopt;
}

void check_aliases(const NetworkView& view, Findings& findings) {
  std::unordered_map<std::uint16_t, std::size_t> used;
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const auto expected = expected_alias(view.config.slaves[i]);
    if (!expected) continue;
    if (const auto [other, is_new] = used.emplace(expected->alias, i); !is_new) {
      findings.add("ENI-REF-12", {PlaceKind::kSlaveInitCmd, i, expected->cmd}, fig::number<"alias">(expected->alias),
                   view.slave<"slave">(other->second));
    }
  }
}

}  // namespace

void check_identities(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) check_identity(view, i, findings);
  check_aliases(view, findings);
}

}  // namespace syncline::checker
