// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/recent_menu.h"

#include <QFileInfo>
#include <algorithm>

#include "ui/session/project_document.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {

RecentMenu::RecentMenu(WindowMemory& memory, ProjectDocument& document, QWidget* parent)
    : QMenu(tr("Open &Recent"), parent), memory_(memory), document_(document) {
  setObjectName(QStringLiteral("recentMenu"));
  setToolTipsVisible(true);
  connect(&memory_, &WindowMemory::recentChanged, this, &RecentMenu::fill);
  connect(&document_, &ProjectDocument::pathChanged, this, &RecentMenu::fill);
  fill();
}

void RecentMenu::fill() {
  clear();
  const auto& recent = memory_.recent();
  menuAction()->setEnabled(!recent.isEmpty());
  bool pinned = false;
  for (const auto& one : recent) {
    if (pinned && !one.pinned) addSeparator();
    pinned = one.pinned;
    const QFileInfo file(one.path);
    auto* action = addAction(QStringLiteral("%1%2  \u2013  %3")
                                 .arg(one.pinned ? QStringLiteral("\u2605 ") : QString(),
                                      file.fileName().replace(u'&', QStringLiteral("&&")),
                                      file.path().replace(u'&', QStringLiteral("&&"))));
    action->setToolTip(one.path);
    connect(action, &QAction::triggered, this, [this, path = one.path] { Q_EMIT fileWanted(path); });
  }
  addSeparator();
  const auto own = QFileInfo(document_.path()).absoluteFilePath();
  const auto shown = std::ranges::find(recent, own, &WindowMemory::Recent::path);
  const bool known = !document_.path().isEmpty() && shown != recent.end();
  auto* pin = addAction(tr("&Pin This Project"));
  pin->setObjectName(QStringLiteral("actionPin"));
  pin->setCheckable(true);
  pin->setEnabled(known);
  pin->setChecked(known && shown->pinned);
  connect(pin, &QAction::triggered, this, [this, own](bool on) { memory_.pin(own, on); });
  auto* empty = addAction(tr("&Clear List"));
  empty->setObjectName(QStringLiteral("actionClearRecent"));
  empty->setToolTip(tr("Pinned projects stay"));
  connect(empty, &QAction::triggered, &memory_, &WindowMemory::clearUnpinned);
}

}  // namespace syncline::ui
