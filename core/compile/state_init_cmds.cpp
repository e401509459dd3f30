// SPDX-License-Identifier: Apache-2.0
#include "compile/state_init_cmds.h"

#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

constexpr std::uint32_t kBootToInitTimeoutMs = 10'000;
constexpr std::uint32_t kBackToPreopTimeoutMs = 5'000;
constexpr std::uint32_t kPreopRetries =
    300;  // a slave loading its configuration may leave the mailbox of 0x0120 unread

/// AL status with the error bit in the mask or not; `length` bytes are read (2, or 6 up to the AL status code).
void expect(InitCmdEdit edit, AlState state, bool error_bit, std::size_t length, std::uint32_t timeout_ms) {
  Bytes data(length);
  Bytes mask(length);
  data[0] = static_cast<std::uint8_t>(state);
  mask[0] = error_bit ? 0x1F : 0x0F;
  edit.validate(std::move(data), std::move(mask), timeout_ms);
}

constexpr std::size_t kStatusOnly = 2;
constexpr std::size_t kStatusToCode = 6;

}  // namespace

Bytes StateCommands::request(AlState state) const {
  const bool acknowledge = state != AlState::kSafeop && state != AlState::kOp && !device_.device_emulation();
  return le_bytes(static_cast<std::uint16_t>(static_cast<std::uint16_t>(state) | (acknowledge ? kAlErrorFlag : 0)));
}

void StateCommands::write_timeout(InitCmdEdit edit, std::uint32_t ms) const {
  if (dialect_ == EniDialect::kEcEngineer) {
    edit.timeout(ms);
  }
}

void StateCommands::add_back_to_init(InitCmdBuilder& cmds, bool dc) const {
  using enum Transition;
  write_timeout(cmds.apwr({kPI, kBI, kSI, kOI}, "request INIT", reg::kAlControl, request(AlState::kInit)).cycle(),
                device_.timeouts.back_to_init);
  if (dc) {
    cmds.apwr({kSI, kOI}, "stop SYNC", reg::kCyclicUnitControl, Bytes(2)).cycle();
  }
  expect(cmds.aprd({kPI, kSI, kOI}, "wait for INIT", reg::kAlStatus, kStatusOnly).cycle(), AlState::kInit, false,
         kStatusOnly, device_.timeouts.back_to_init);
  expect(cmds.aprd({kBI}, "wait for INIT", reg::kAlStatus, kStatusOnly).cycle(), AlState::kInit, false, kStatusOnly,
         kBootToInitTimeoutMs);
}

void StateCommands::add_start_in_init(InitCmdBuilder& cmds) const {
  using enum Transition;
  write_timeout(cmds.apwr({kIP, kIB}, "request INIT", reg::kAlControl, request(AlState::kInit)).cycle().answered(),
                device_.timeouts.preop);
  expect(cmds.aprd({kIP, kIB}, "wait for INIT", reg::kAlStatus, kStatusOnly).cycle().answered(), AlState::kInit, false,
         kStatusOnly, device_.timeouts.preop);
}

void StateCommands::add_request_back_to_preop(InitCmdBuilder& cmds) const {
  write_timeout(
      cmds.fpwr({Transition::kSP, Transition::kOP}, "request PREOP", reg::kAlControl, request(AlState::kPreop))
          .cycle()
          .retries(kPreopRetries),
      kBackToPreopTimeoutMs);
}

void StateCommands::add_request_back_to_safeop(InitCmdBuilder& cmds) const {
  write_timeout(cmds.fpwr({Transition::kOS}, "request SAFEOP", reg::kAlControl, request(AlState::kSafeop)).cycle(),
                device_.timeouts.back_to_safeop);
}

void StateCommands::add_check_back_to_preop(InitCmdBuilder& cmds) const {
  expect(cmds.fprd({Transition::kSP, Transition::kOP}, "wait for PREOP", reg::kAlStatus, kStatusToCode).cycle(),
         AlState::kPreop, false, kStatusToCode, kBackToPreopTimeoutMs);
}

void StateCommands::add_preop_and_boot(InitCmdBuilder& cmds) const {
  using enum Transition;
  cmds.fpwr({kIP, kIB}, "assign SII to PDI", reg::kSiiConfiguration, {1}).cycle().answered();
  cmds.apwr({kII}, "assign SII to EtherCAT", reg::kSiiConfiguration, {0}).cycle();
  write_timeout(cmds.fpwr({kIP}, "request PREOP", reg::kAlControl, request(AlState::kPreop))
                    .cycle()
                    .answered()
                    .retries(kPreopRetries),
                device_.timeouts.preop);
  expect(cmds.fprd({kIP}, "wait for PREOP", reg::kAlStatus, kStatusToCode).cycle().answered(), AlState::kPreop, true,
         kStatusToCode, device_.timeouts.preop);
  cmds.apwr({kIP, kBI}, "assign SII to EtherCAT", reg::kSiiConfiguration, {0}).cycle();
  write_timeout(cmds.fpwr({kIB}, "request BOOT", reg::kAlControl, request(AlState::kBoot)).cycle().answered(),
                device_.timeouts.preop);
  expect(cmds.fprd({kIB}, "wait for BOOT", reg::kAlStatus, kStatusToCode).cycle().answered(), AlState::kBoot, true,
         kStatusToCode, device_.timeouts.preop);
}

void StateCommands::add_safeop_and_op(InitCmdBuilder& cmds) const {
  using enum Transition;
  write_timeout(cmds.fpwr({kPS}, "request SAFEOP", reg::kAlControl, request(AlState::kSafeop)).cycle().answered(),
                device_.timeouts.safeop_op);
  expect(cmds.fprd({kPS}, "wait for SAFEOP", reg::kAlStatus, kStatusToCode).cycle().answered(), AlState::kSafeop, true,
         kStatusToCode, device_.timeouts.safeop_op);
  expect(cmds.fprd({kOS}, "wait for SAFEOP", reg::kAlStatus, kStatusToCode).cycle(), AlState::kSafeop, false,
         kStatusToCode, device_.timeouts.back_to_safeop);
  write_timeout(cmds.fpwr({kSO}, "request OP", reg::kAlControl, request(AlState::kOp)).cycle().answered(),
                device_.timeouts.safeop_op);
  expect(cmds.fprd({kSO}, "wait for OP", reg::kAlStatus, kStatusToCode).cycle().answered(), AlState::kOp, true,
         kStatusToCode, device_.timeouts.safeop_op);
}

}  // namespace syncline::compiler
