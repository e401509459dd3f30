// SPDX-License-Identifier: Apache-2.0
#include "app/cli/visit_options.h"

#include <fmt/format.h>

#include "app/cli/context.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/composition/open_link.h"
#include "engine/opened_link.h"
#include "master/startup/slave_visit.h"
#include "protocol/al_state.h"
#include "protocol/coe.h"

namespace syncline::cli {

void add_slave_options(CLI::App& command, SlaveOnLink& slave, bool& json) {
  command.add_option("link", slave.link, "LINK")->required();
  command.add_option("position", slave.position, "Position of the slave, 0 is the first")->required();
  command.add_flag("--json", json, "Print JSON");
}

void with_mailbox(Context& context, SlaveOnLink slave, const std::function<Status(SlaveVisit&)>& work, bool boot) {
  const InterruptGuard interrupt;
  slave.cancel = &interrupt.interrupted();
  slave.on_left = [&context](const Error& error) { context.warn(error); };
  const auto done = visit_slave(open_link(slave.link), slave, [&](SlaveVisit& visit) -> Status {
    visit.set_emergency_handler([&](const coe::Emergency& emergency) {
      context.console.err << fmt::format("{}: emergency 0x{:04X}, error register 0x{:02X}\n", visit.name(),
                                         emergency.error_code, emergency.error_register);
    });
    if (boot) {
      if (auto status = visit.lead_to(AlState::kBoot); !status) return status;
    }
    if (auto status = visit.open_mailbox(); !status) return status;
    if (visit.state() != visit.found()) {
      context.console.err << fmt::format("{} was in {} and is led to {} meanwhile\n", visit.name(),
                                         al_state_name(visit.found()), al_state_name(visit.state()));
    }
    return work(visit);
  });
  if (!done) context.fail_with(done.error());
}

}  // namespace syncline::cli
