// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/network_commands.h"

#include <QAction>
#include <QWidget>
#include <utility>

#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

NetworkCommands::NetworkCommands(Workspace& workspace, QWidget& window, std::function<bool()> commit)
    : QObject(&window), workspace_(workspace), window_(window), commit_(std::move(commit)) {
  const auto make = [this](const char* name, const QString& text, const QString& tip, auto command) {
    auto* action = new QAction(text, this);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, command);
    return action;
  };
  next_ = make("actionNextNetwork", tr("Ne&xt Network"), tr("Work on the next network of the machine"), [this] {
    auto& document = workspace_.document();
    choose((document.network() + 1) % static_cast<int>(document.networks().size()));
  });
  next_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_F6));
  add_ = make("actionAddNetwork", tr("&Add Network"), tr("Add a network without slaves to the machine"),
              [this] { add(); });
  remove_ = make("actionRemoveNetwork", tr("Re&move Network…"), tr("Take the network in work out of the machine"),
                 [this] { remove(); });
  all_offline_ = make("actionAllOffline", tr("All Net&works Offline"),
                      tr("Take all networks of the machine that run offline"), [this] {
                        if (mayStopWriting(window_, workspace_)) workspace_.runs().goOffline();
                      });
  connect(&workspace.document(), &ProjectDocument::networksChanged, this, &NetworkCommands::update);
  connect(&workspace.runs(), &NetworkRuns::phaseChanged, this, &NetworkCommands::update);
  connect(&workspace.recording(), &OpenedRecording::changed, this, &NetworkCommands::update);
  connect(&workspace, &Workspace::mayEditSlavesChanged, this, &NetworkCommands::update);
  update();
}

void NetworkCommands::update() {
  const bool several = workspace_.document().networks().size() > 1;
  const bool recorded = workspace_.recording().isOpen();
  next_->setEnabled(several && !recorded);
  remove_->setEnabled(several && workspace_.mayEditSlaves());
  add_->setEnabled(!recorded);
  all_offline_->setEnabled(workspace_.runs().any());
}

/// What runs goes on; what belongs to the network in work alone must have come to its end.
QString NetworkCommands::whyNot() const {
  if (workspace_.recording().isOpen()) return tr("A recording is shown: close it first (File, Close Recording).");
  if (workspace_.scan().isRunning()) return tr("A bus is being scanned: wait for its slaves, or cancel the scan.");
  if (workspace_.requests().writing()) return tr("A slave is being written to: wait until it has been.");
  return {};
}

bool NetworkCommands::may() {
  const auto why = whyNot();
  if (!why.isEmpty()) Q_EMIT refused(why);
  return why.isEmpty() && commit_();
}

void NetworkCommands::choose(int network) {
  if (may()) workspace_.document().chooseNetwork(network);
}

/// Named by the field of its first page.
void NetworkCommands::add() {
  if (!may()) return;
  auto& document = workspace_.document();
  document.addNetwork(tr("Network %1").arg(document.networks().size() + 1));
}

void NetworkCommands::remove() {
  if (!workspace_.mayEditSlaves() || !may()) return;
  auto& document = workspace_.document();
  const auto name = document.networks().value(document.network());
  if (!document.project().slaves.empty() &&
      !ask(window_, "removeNetworkQuestion", tr("Take %1 out of the machine?").arg(name),
           tr("Its %n slave(s) go with it. That cannot be undone, but until the project is saved the file keeps it.",
              nullptr, static_cast<int>(document.project().slaves.size())),
           tr("Remove"))) {
    return;
  }
  document.removeNetwork();
}

}  // namespace syncline::ui
