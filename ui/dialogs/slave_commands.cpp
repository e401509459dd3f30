// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/slave_commands.h"

#include <QKeySequence>
#include <algorithm>
#include <memory>
#include <utility>

#include "compare/replaced_slave.h"
#include "config/wiring_tree.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/replace_dialog.h"
#include "ui/session/device_catalogue.h"
#include "ui/session/workspace.h"
#include "ui/text/menu_key.h"

namespace syncline::ui {

SlaveCommands::SlaveCommands(Workspace& workspace, DeviceCatalogue& catalogue, QWidget& window,
                             std::function<bool()> commit)
    : QObject(&window), workspace_(workspace), catalogue_(catalogue), window_(window), commit_(std::move(commit)) {
  add =
      make("actionAddDevice", tr("&Add Device…"), tr("Choose a device in the catalogue for behind the selected slave"),
           QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A));
  duplicate = make("actionDuplicateSlave", tr("&Duplicate"), tr("Put a copy behind the slave, with its branches"),
                   QKeySequence(Qt::CTRL | Qt::Key_D));
  move_up = make("actionMoveUp", tr("&Move Up"), tr("Change places with the slave before it in its line"),
                 QKeySequence(Qt::ALT | Qt::Key_Up));
  move_down = make("actionMoveDown", tr("Move Do&wn"), tr("Change places with the slave behind it in its line"),
                   QKeySequence(Qt::ALT | Qt::Key_Down));
  replace = make("actionReplaceSlave", tr("Re&place…"), tr("Put another revision or another device in its place"),
                 QKeySequence(Qt::CTRL | Qt::Key_H));
  remove = make("actionRemoveSlave", tr("Remo&ve"), tr("Take the slave with its branches out; its line closes"),
                QKeySequence(Qt::Key_Delete));
  // The others are keys of the explorer: in a field they mean something else.
  for (auto* action : {duplicate, move_up, move_down, replace, remove})
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connectActions();
  connect(&workspace, &Workspace::mayEditSlavesChanged, this, &SlaveCommands::updateActions);
  connect(&workspace.document(), &ProjectDocument::projectChanged, this, [this](bool structural) {
    if (structural) updateActions();
  });
  updateActions();
}

QAction* SlaveCommands::make(const char* name, const QString& text, const QString& tip, const QKeySequence& keys) {
  auto* action = new QAction(text, this);
  action->setObjectName(QLatin1String(name));
  action->setIconText(withoutMenuKey(text));
  action->setShortcut(keys);
  action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
  return action;
}

void SlaveCommands::connectActions() {
  const auto on = [this](QAction* action, auto command) {
    connect(action, &QAction::triggered, this, [this, command] {
      if (mayEdit()) command();
    });
  };
  on(add, [this] { Q_EMIT catalogueWanted(); });
  on(duplicate, [this] {
    apply(tr("Duplicate %1").arg(nameOf(slave_)),
          [slave = static_cast<std::size_t>(slave_)](Project& project) { return duplicate_slave(project, slave); });
  });
  on(move_up, [this] {
    apply(tr("Move %1").arg(nameOf(slave_)),
          [slave = static_cast<std::size_t>(slave_)](Project& project) { return move_slave_up(project, slave); });
  });
  on(move_down, [this] {
    apply(tr("Move %1").arg(nameOf(slave_)),
          [slave = static_cast<std::size_t>(slave_)](Project& project) { return move_slave_down(project, slave); });
  });
  on(remove, [this] { removeSelected(); });
  on(replace, [this] { replaceSelected(); });
}

void SlaveCommands::setNode(int slave) {
  slave_ = slave;
  updateActions();
}

void SlaveCommands::updateActions() {
  const bool may = workspace_.mayEditSlaves();
  const auto count = static_cast<int>(workspace_.document().project().slaves.size());
  const bool some = may && slave_ >= 0 && slave_ < count;
  add->setEnabled(may);
  for (auto* action : {duplicate, move_up, move_down, replace, remove}) action->setEnabled(some);
}

bool SlaveCommands::mayEdit() {
  if (const auto why = workspace_.whySlavesStay(); !why.isEmpty()) {
    Q_EMIT told(why);
    return false;
  }
  return commit_();
}

QString SlaveCommands::nameOf(int slave) const {
  const auto& slaves = workspace_.document().project().slaves;
  const auto at = static_cast<std::size_t>(slave);
  return slave >= 0 && at < slaves.size() ? QString::fromStdString(slaves[at].name) : QString();
}

bool SlaveCommands::apply(const QString& text, const Edit& edit) {
  const auto done = std::make_shared<EditedSlave>(tl::unexpected(WiringObstacle::kNoSuchSlave));
  const auto status = workspace_.document().edit(text, [edit, done](Project& project) -> Status {
    *done = edit(project);
    return *done ? Status{} : Status(fail(ErrorCode::kConfiguration));
  });
  if (!status) {
    Q_EMIT told(obstacleText(done->error()));
    return false;
  }
  Q_EMIT nodeWanted(workspace_.document().project().slaves.empty() ? -1 : static_cast<int>(**done));
  return true;
}

/// The description comes from its file, in the catalogue's thread.
void SlaveCommands::fetch(const eni::CatalogueEntry& device, int slave, Addition edit) {
  if (!mayEdit()) return;
  const auto mark = workspace_.document().mark(slave);
  catalogue_.read(device, this, [this, mark, edit = std::move(edit)](const Result<DeviceDescription>& read) {
    if (!read) {
      workspace_.report(read.error(), Severity::kError, tr("Catalogue"));
      return showError(&window_, tr("The description of the device could not be read."), read.error());
    }
    if (!mayEdit()) return;
    const auto now = workspace_.document().find(mark);
    if (!now) return Q_EMIT told(obstacleText(WiringObstacle::kNoSuchSlave));
    apply(tr("Add %1").arg(QString::fromStdString(read->type)),
          [edit, device = *read, at = *now](Project& project) { return edit(project, device, at); });
  });
}

void SlaveCommands::addDevice(const eni::CatalogueEntry& device) {
  fetch(device, slave_, [](Project& project, const DeviceDescription& read, int slave) {
    return add_slave(project, read, slave < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(slave)));
  });
}

void SlaveCommands::addDeviceTo(const eni::CatalogueEntry& device, DropPlace place) {
  fetch(device, place.slave,
        [before = place.before](Project& project, const DeviceDescription& read, int slave) -> EditedSlave {
          if (slave < 0 && project.slaves.empty()) return add_slave(project, read, {});
          const auto target = static_cast<std::size_t>(std::max(slave, 0));
          return before || slave < 0 ? add_slave_before(project, read, target) : add_slave(project, read, target);
        });
}

void SlaveCommands::addDeviceAt(const eni::CatalogueEntry& device, PreviousPort at) {
  fetch(device, at.position, [port = at.port](Project& project, const DeviceDescription& read, int slave) {
    return add_slave_at(project, read, {static_cast<std::uint16_t>(slave), port});
  });
}

void SlaveCommands::move(int slave, DropPlace place) {
  if (slave < 0 || slave == place.slave || !mayEdit()) return;
  apply(tr("Move %1").arg(nameOf(slave)), [from = static_cast<std::size_t>(slave), place](Project& project) {
    if (place.slave < 0) return move_slave_first(project, from);
    const auto target = static_cast<std::size_t>(place.slave);
    return place.before ? move_slave_before(project, from, target) : move_slave_behind(project, from, target);
  });
}

void SlaveCommands::rewire(int slave, PreviousPort at) {
  if (slave < 0 || !mayEdit()) return;
  apply(tr("Rewire %1").arg(nameOf(slave)),
        [slave = static_cast<std::size_t>(slave), at](Project& project) { return rewire_slave(project, slave, at); });
}

void SlaveCommands::removeSelected() {
  const auto slave = static_cast<std::size_t>(slave_);
  const auto name = nameOf(slave_);
  const auto along = static_cast<int>(WiringTree::of(workspace_.document().project().slaves).group(slave).size()) - 1;
  const bool done =
      apply(tr("Remove %1").arg(name), [slave](Project& project) { return remove_slave(project, slave); });
  if (done && along > 0) Q_EMIT told(tr("%1 was removed with %n slave(s) of its branches.", nullptr, along).arg(name));
}

void SlaveCommands::replaceSelected() {
  auto* dialog = new ReplaceDialog(workspace_.document().project(), slave_, catalogue_, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, mark = workspace_.document().mark(slave_)] {
    if (const auto& device = dialog->device(); device && mayEdit()) replaceBy(mark, *device);
  });
  dialog->open();
}

void SlaveCommands::replaceBy(const SlaveMark& mark, const DeviceDescription& device) {
  const auto slave = workspace_.document().find(mark);
  if (!slave || *slave < 0) return Q_EMIT told(obstacleText(WiringObstacle::kNoSuchSlave));
  const auto at = static_cast<std::size_t>(*slave);
  const auto lost = std::make_shared<std::size_t>(0);
  const bool done = apply(tr("Replace %1").arg(nameOf(*slave)), [at, device, lost](Project& project) -> EditedSlave {
    auto replaced = replace_device(project, at, device);
    if (!replaced) return tl::unexpected(replaced.error());
    *lost = replaced->lost.size();
    project = std::move(replaced->project);
    return at;
  });
  if (done && *lost > 0)
    Q_EMIT told(
        tr("%n setting(s) of the old device are gone; undo brings them back.", nullptr, static_cast<int>(*lost)));
}

QString obstacleText(WiringObstacle obstacle) {
  switch (obstacle) {
    case WiringObstacle::kNoSuchSlave:
      return SlaveCommands::tr("The slave is gone.");
    case WiringObstacle::kNoPort:
      return SlaveCommands::tr("No free port there, or nearer to the master, takes this device.");
    case WiringObstacle::kPortTaken:
      return SlaveCommands::tr("That port is not free.");
    case WiringObstacle::kOtherKind:
      return SlaveCommands::tr("A terminal needs an E-bus port, a device with a cable an Ethernet port.");
    case WiringObstacle::kNoWayOn:
      return SlaveCommands::tr("It has no port for what would hang behind it.");
    case WiringObstacle::kBehindIt:
      return SlaveCommands::tr("That place is behind the slave itself.");
    case WiringObstacle::kFirst:
      return SlaveCommands::tr("The slave stands first in its line.");
    case WiringObstacle::kLast:
      return SlaveCommands::tr("The slave stands last in its line.");
    case WiringObstacle::kTooMany:
      return SlaveCommands::tr("A network has at most 65535 slaves.");
  }
  return {};
}

}  // namespace syncline::ui
