// SPDX-License-Identifier: Apache-2.0
#include "compile/identity_cmds.h"

#include "compile/slave_plan.h"
#include "config/device_description.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

constexpr std::uint32_t kSiiTimeoutMs = 100;
constexpr std::uint32_t kIdTimeoutMs = 1'000;
constexpr std::uint16_t kRevisionWord = 0x0C;

void check_at_start(InitCmdBuilder& cmds, const std::string& what, std::uint16_t word, Bytes expected,
                    ValidateType type = ValidateType::kEqual) {
  Bytes request;
  ByteWriter(request).u16(0x0100).u16(word).u16(0);  // read command, word address
  cmds.apwr({Transition::kIP}, "read " + what + " from SII", reg::kSiiControl, std::move(request)).answered();
  const std::size_t length = expected.size();
  cmds.aprd({Transition::kIP}, "check " + what, reg::kSiiData, length)
      .cycle()
      .answered()
      .validate(std::move(expected), {}, kSiiTimeoutMs, type);
}

void check_revision(InitCmdBuilder& cmds, RevisionCheck rule, std::uint32_t revision) {
  const auto low = static_cast<std::uint16_t>(revision), high = static_cast<std::uint16_t>(revision >> 16);
  switch (rule) {
    case RevisionCheck::kNone:
      return;
    case RevisionCheck::kEqual:
      return check_at_start(cmds, "revision number", kRevisionWord, le_bytes(revision));
    case RevisionCheck::kEqualOrGreater:
      return check_at_start(cmds, "revision number (or newer)", kRevisionWord, le_bytes(revision),
                            ValidateType::kGreaterOrEqual);
    case RevisionCheck::kLowWordEqualHighWordEqualOrGreater:
      check_at_start(cmds, "revision number (low word)", kRevisionWord, le_bytes(low));
      return check_at_start(cmds, "revision number (high word or newer)", kRevisionWord + 1, le_bytes(high),
                            ValidateType::kGreaterOrEqual);
    case RevisionCheck::kLowWordEqual:
      return check_at_start(cmds, "revision number (low word)", kRevisionWord, le_bytes(low));
  }
}

}  // namespace

RevisionCheck revision_rule(const SlaveSettings& slave) {
  if (slave.check.revision_rule) return *slave.check.revision_rule;
  // "None" is how an ESI says that nothing is compared unless the user wants it; when the user does, it is the number.
  const auto of_esi = slave.device.check_revision.value_or(RevisionCheck::kEqual);
  return of_esi == RevisionCheck::kNone ? RevisionCheck::kEqual : of_esi;
}

void add_device_id_check(InitCmdBuilder& cmds, const Transitions& when, const DeviceDescription& device,
                         std::uint16_t id, std::uint32_t timeout_ms) {
  if (device.identification_ado) {
    cmds.aprd(when, "check device ID", *device.identification_ado, 2).answered().validate(le_bytes(id), {}, timeout_ms);
    return;
  }
  constexpr std::uint16_t kIdBit = 0x0020;  // request in AL control, loaded in AL status
  const auto init = static_cast<std::uint16_t>(AlState::kInit);
  cmds.apwr(when, "request device ID", reg::kAlControl, le_bytes(static_cast<std::uint16_t>(init | kIdBit)))
      .cycle()
      .answered();
  cmds.aprd(when, "wait for device ID", reg::kAlStatus, 2)
      .cycle()
      .answered()
      .validate(le_bytes(kIdBit), le_bytes(kIdBit), timeout_ms);
  cmds.aprd(when, "check device ID", reg::kAlStatusCode, 2).answered().validate(le_bytes(id), {}, timeout_ms);
  cmds.apwr(when, "end request of device ID", reg::kAlControl, le_bytes(init)).cycle().answered();
}

void add_identity_check(InitCmdBuilder& cmds, const SlavePlan& slave) {
  const IdentityCheck& check = slave.settings->check;
  const Identity& identity = slave.device().identity;
  cmds.apwr({Transition::kIP}, "assign SII to EtherCAT", reg::kSiiConfiguration, {0}).cycle().answered();
  if (check.vendor) check_at_start(cmds, "vendor id", 0x08, le_bytes(identity.vendor_id));
  if (check.product) check_at_start(cmds, "product code", 0x0A, le_bytes(identity.product_code));
  if (check.revision) check_revision(cmds, revision_rule(*slave.settings), identity.revision_no);
  if (check.serial && identity.serial_no != 0)
    check_at_start(cmds, "serial number", 0x0E, le_bytes(identity.serial_no));
  if (check.alias) {
    cmds.aprd({Transition::kIP}, "check alias", reg::kStationAlias, 2)
        .answered()
        .validate(le_bytes(slave.settings->alias), {}, kSiiTimeoutMs);
  }
  if (check.device_id) add_device_id_check(cmds, {Transition::kIP}, slave.device(), *check.device_id, kIdTimeoutMs);
}

}  // namespace syncline::compiler
