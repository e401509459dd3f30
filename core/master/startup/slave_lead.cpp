// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "master/cyclic/cyclic_task.h"
#include "master/cyclic/mailbox_hold.h"
#include "master/exchange/slave_name.h"
#include "master/startup/esm.h"
#include "reasons/because.h"

namespace syncline {
Status Esm::judge(std::size_t slave, AlState target) const {
  const auto& known = run_.snapshot.slaves[slave];
  if (known.present && known.al_status == static_cast<std::uint16_t>(target)) return {};
  const bool refused = (known.al_status & kAlErrorFlag) != 0;
  Error error{known.present ? refused ? ErrorCode::kAlState : ErrorCode::kAlTimeout : ErrorCode::kNoResponse,
              slave_name(run_.config(), slave)};
  error.expected = static_cast<std::int64_t>(target);
  error.received = known.al_status;
  error.extra = known.al_status_code;
  return fail(std::move(error));
}

/// Without cycles slaves may not have their station addresses yet.
Status Esm::check_cyclic(std::size_t slave) const {
  if (bus_.cyclic()) return {};
  return fail(ErrorCode::kConfiguration, slave_name(run_.config(), slave),
              because("the bus is at rest in INIT; lead the whole bus to PREOP first"));
}

Status Esm::acknowledge(std::size_t slave) {
  if (auto status = check_cyclic(slave); !status) return status;
  const SlaveList one{slave};
  if (auto status = commands_.read_al_status(one); !status) return status;
  if (auto status = commands_.acknowledge(one); !status) return status;
  return judge(slave, state_of(slave));
}

/// What the slave's own init commands do, or where it has none for that step only the request.
Status Esm::lead_down(std::size_t slave, AlState target) {
  SlaveList one{slave};
  const auto transition = transition_between(state_of(slave), target);
  if (!transition) return {};
  if (task_.working_counter().judging()) task_.expect_present(slave);
  auto status = commands_.run(one, *transition);
  if (!status && ends_everything(status.error())) return status;
  return commands_.read_al_status(SlaveList{slave});
}

Status Esm::lead(std::size_t slave, AlState target) {
  if (auto status = check_cyclic(slave); !status) return status;
  // Whoever goes on its own account is missed by nobody.
  task_.working_counter().set_joining(true);
  commands_.keep_failure_of(slave);
  auto status = lead_alone(slave, target);
  // The step that failed says more than where that has left the slave.
  auto reason = commands_.take_failure();
  if (!status && reason && run_.snapshot.slaves[slave].present && !ends_everything(status.error()))
    status = fail(std::move(*reason));
  task_.working_counter().set_joining(false);
  task_.slaves().refresh_al_status();
  if (task_.working_counter().judging()) task_.expect_present();
  run_.states.update_master_state(bus_.clock().now());
  return status;
}

Status Esm::lead_alone(std::size_t slave, AlState target) {
  const SlaveList one{slave};
  MailboxHold hold(run_.mailboxes, task_.acyclic().mailbox(), one);
  if (auto status = hold.settle(bus_); !status) return status;
  if (auto status = commands_.read_al_status(one); !status) return status;
  if (auto status = commands_.acknowledge(one); !status) return status;
  if (!run_.snapshot.slaves[slave].present) return judge(slave, target);
  const bool boots = target == AlState::kBoot || state_of(slave) == AlState::kBoot;
  if (target != AlState::kBoot && is_above(target, level_)) {
    return fail(ErrorCode::kConfiguration, slave_name(run_.config(), slave),
                because("the bus is in {state}; no slave can be led above it", al_state_name(level_)));
  }
  if (boots && state_of(slave) != target) {
    if (auto status = lead_down(slave, AlState::kInit); !status) return status;
    if (target == AlState::kBoot && state_of(slave) == AlState::kInit) {
      if (auto status = lead_down(slave, target); !status) return status;
    }
  } else if (is_above(state_of(slave), target)) {
    if (auto status = lead_down(slave, target); !status) return status;
  }
  if (target != AlState::kBoot && is_above(target, state_of(slave))) {
    if (auto status = join(one, target); !status) return status;
  }
  return judge(slave, target);
}

}  // namespace syncline
