// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/slave_state_commands.h"

#include <QMenu>

#include "protocol/al_state_rank.h"
#include "ui/dialogs/questions.h"
#include "ui/session/running_slave.h"
#include "ui/session/slave_requests.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"

namespace syncline::ui {

SlaveStateCommands::SlaveStateCommands(Workspace& workspace, QWidget& window, QObject* parent)
    : QObject(parent), workspace_(workspace), window_(window) {}

std::vector<AlState> SlaveStateCommands::states(int slave) const {
  std::vector<AlState> all{AlState::kInit, AlState::kPreop, AlState::kSafeop, AlState::kOp};
  const auto running = runningSlave(workspace_, slave);
  const auto* mailbox = running && running->config->mailbox ? &*running->config->mailbox : nullptr;
  if (mailbox != nullptr && mailbox->foe && mailbox->bootstrap_send) all.push_back(AlState::kBoot);
  return all;
}

QString SlaveStateCommands::obstacle(int slave) const {
  if (workspace_.live().phase() != LiveSession::Phase::kOnline) return tr("Go online first (F5).");
  const auto running = runningSlave(workspace_, slave);
  if (!running) return tr("The machine was started without this slave.");
  if (!running->present()) return tr("The slave does not answer.");
  // The master leads single slaves beside its cycles only.
  if (al_state_rank(workspace_.live().snapshot().requested) < al_state_rank(AlState::kPreop)) {
    return tr("The whole bus is in INIT: request PREOP or more for all first.");
  }
  return {};
}

bool SlaveStateCommands::failed(int slave) const {
  const auto running = runningSlave(workspace_, slave);
  return running && running->present() && (running->status->al_status & kAlErrorFlag) != 0;
}

/// What a lower state does to a machine that runs; empty when nothing is hurt.
QString SlaveStateCommands::consequence(int slave, AlState state) const {
  const auto running = runningSlave(workspace_, slave);
  if (!running || !running->drives() || al_state_rank(state) >= al_state_rank(running->state())) return {};
  auto text =
      tr("Its outputs stop and its inputs are no longer valid. The other slaves go on, and the master expects the "
         "working counter without it.");
  text += u' ' + tr("It stays where you lead it: automatic recovery brings back only slaves that were lost or fell by "
                    "themselves. A request of a state for the whole bus takes it along again.");
  return text;
}

void SlaveStateCommands::request(int slave, AlState state) {
  if (const auto why = obstacle(slave); !why.isEmpty()) return Q_EMIT told(slave, why, true);
  if (const auto more = consequence(slave, state); !more.isEmpty()) {
    const auto name = nodeName(workspace_.document().project(), slave);
    const auto question = tr("The machine runs. Take %1 to %2?").arg(name, stateName(state));
    if (!ask(window_, "stateQuestion", question, more, tr("Take to %1").arg(stateName(state)))) return;
  }
  const auto running = runningSlave(workspace_, slave);
  if (!running) return Q_EMIT told(slave, obstacle(slave), true);
  Q_EMIT told(slave, tr("%1 is requested.").arg(stateName(state)), false);
  workspace_.requests().post(requests::StateChange{running->position, state}, *this,
                             [this, at = running->position, state](const RequestOutcome& outcome) {
                               tell(at, outcome, tr("It is in %1.").arg(stateName(state)));
                             });
}

void SlaveStateCommands::acknowledge(int slave) {
  if (const auto why = obstacle(slave); !why.isEmpty()) return Q_EMIT told(slave, why, true);
  const auto running = runningSlave(workspace_, slave);
  workspace_.requests().post(requests::ErrorAcknowledge{running->position}, *this,
                             [this, at = running->position](const RequestOutcome& outcome) {
                               tell(at, outcome,
                                    tr("The error is acknowledged; now request the state that it shall have."));
                             });
}

/// The project may have been edited meanwhile.
void SlaveStateCommands::tell(std::uint16_t position, const RequestOutcome& outcome, const QString& done) {
  const int slave = workspace_.runningSlaves().slaveOf(position);
  if (slave >= 0) Q_EMIT told(slave, outcome.ok() ? done : outcome.why, !outcome.ok());
}

void SlaveStateCommands::addTo(QMenu& menu, int slave) {
  const auto why = obstacle(slave);
  menu.setToolTipsVisible(true);
  for (const auto state : states(slave)) {
    auto* action = menu.addAction(stateName(state), this, [this, slave, state] { request(slave, state); });
    action->setObjectName(QStringLiteral("slaveState") + stateName(state));
    action->setEnabled(why.isEmpty());
    action->setToolTip(why);
  }
  menu.addSeparator();
  auto* acknowledging = menu.addAction(tr("Acknowledge Error"), this, [this, slave] { acknowledge(slave); });
  acknowledging->setObjectName(QStringLiteral("slaveAcknowledge"));
  acknowledging->setEnabled(why.isEmpty() && failed(slave));
}

}  // namespace syncline::ui
