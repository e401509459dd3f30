// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compile/compile.h"
#include "compile/init_cmd_builder.h"
#include "config/device_description.h"

namespace syncline::compiler {

/// Requests of AL states (0x0120) and the checks that follow (0x0130), with the ESI's time-outs. A device with
/// emulation mirrors AL control into AL status, so the error-acknowledge bit is not set for it: it would come back as
/// an error.
class StateCommands {
 public:
  StateCommands(const DeviceDescription& device, EniDialect dialect) : device_(device), dialect_(dialect) {}

  /// To INIT from any state; with DC also the cyclic unit is stopped here.
  void add_back_to_init(InitCmdBuilder& cmds, bool dc) const;
  /// INIT once more at the start, with acknowledge, before the slave is identified.
  void add_start_in_init(InitCmdBuilder& cmds) const;
  void add_request_back_to_preop(InitCmdBuilder& cmds) const;
  void add_request_back_to_safeop(InitCmdBuilder& cmds) const;
  void add_check_back_to_preop(InitCmdBuilder& cmds) const;
  /// SII to the PDI, then PREOP or BOOT.
  void add_preop_and_boot(InitCmdBuilder& cmds) const;
  void add_safeop_and_op(InitCmdBuilder& cmds) const;

 private:
  /// AL control word: state, with error acknowledge below SAFEOP unless the device is emulated.
  [[nodiscard]] Bytes request(AlState state) const;
  /// ET9000 gives the writes no time-out of their own.
  void write_timeout(InitCmdEdit edit, std::uint32_t ms) const;

  const DeviceDescription& device_;
  EniDialect dialect_;
};

}  // namespace syncline::compiler
