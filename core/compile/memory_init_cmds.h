// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compile/compile.h"
#include "compile/slave_plan.h"

namespace syncline::compiler {

class InitCmdBuilder;

/// Commands that set and clear the SyncManagers and FMMUs of one slave.
class MemoryCommands {
 public:
  MemoryCommands(const SlavePlan& slave, EniDialect dialect) : slave_(slave), dialect_(dialect) {}
  void add_mailbox(InitCmdBuilder& cmds) const;
  void add_sync_managers(InitCmdBuilder& cmds) const;
  void add_fmmus(InitCmdBuilder& cmds) const;
  void add_clear_fmmus(InitCmdBuilder& cmds) const;

 private:
  const SlavePlan& slave_;
  EniDialect dialect_;
};

}  // namespace syncline::compiler
