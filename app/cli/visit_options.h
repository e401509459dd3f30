// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "app/cli/context.h"
#include "engine/visit_slave.h"

namespace CLI {
class App;
}  // namespace CLI

namespace syncline::cli {

/// One slave behind a LINK.
struct SlaveOnLink : VisitRequest {
  std::string link;
};

/// Adds LINK, POSITION and --json to a command that works on one slave.
void add_slave_options(CLI::App& command, SlaveOnLink& slave, bool& json);

/// Opens the slave's mailbox (in BOOT its bootstrap mailbox), does `work` and leaves the slave as it was; says on the
/// error stream when the slave was led to another state for it. Ctrl-C ends it in order. Prints the error, if any.
void with_mailbox(Context& context, SlaveOnLink slave, const std::function<Status(SlaveVisit&)>& work,
                  bool boot = false);

}  // namespace syncline::cli
