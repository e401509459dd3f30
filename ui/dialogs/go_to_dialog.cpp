// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/go_to_dialog.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "config/project.h"
#include "settings/settings_table.h"
#include "ui/text/menu_key.h"
#include "ui/text/setting_text.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kMostGoals = 100;
constexpr std::size_t kMostOfSlaves = 50;  // of settings, and of objects
constexpr qsizetype kLeastLetters = 2;     // one of them is in half of all there is
constexpr int kGoalRole = Qt::UserRole;

bool matches(const QString& found_by, const QStringList& words) {
  return std::ranges::all_of(words, [&](const QString& word) { return found_by.contains(word); });
}

}  // namespace

GoToDialog::GoToDialog(const Project& project, int node, const QMenuBar& menus, QWidget* parent)
    : QDialog(parent), search_(project, node) {
  setObjectName(QStringLiteral("goToDialog"));
  setWindowTitle(tr("Go To"));
  setMinimumSize(520, 360);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* layout = new QVBoxLayout(this);
  words_ = named(new QLineEdit, "goToSearch", tr("Slave, setting, object or command to go to"));
  words_->setPlaceholderText(tr("A slave, a setting or its key, an object (6040, name), a command"));
  words_->installEventFilter(this);
  list_ = named(new QListWidget, "goToList", tr("What can be gone to"));
  list_->setWordWrap(true);
  list_->setFocusPolicy(Qt::NoFocus);
  layout->addWidget(words_);
  layout->addWidget(list_, 1);
  addNodes(project);
  addSettings(project, node);
  for (const auto* menu : menus.findChildren<QMenu*>()) addActions(*menu);
  fixed_ = goals_.size();
  connect(words_, &QLineEdit::textChanged, this, &GoToDialog::showMatches);
  connect(list_, &QListWidget::itemClicked, this, &GoToDialog::go);
  showMatches();
}

void GoToDialog::addGoal(Goal goal) {
  goal.found_by = (goal.text + u' ' + goal.detail + u' ' + goal.key).toLower();
  goals_.push_back(std::move(goal));
}

void GoToDialog::addNodes(const Project& project) {
  addGoal({.text = QString::fromStdString(project.master.name), .detail = tr("the master"), .slave = -1});
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    const auto& slave = project.slaves[i];
    addGoal({.text = QString::fromStdString(slave.name),
             .detail = tr("slave %1, address %2, %3")
                           .arg(i)
                           .arg(slave.station_address)
                           .arg(QString::fromStdString(slave.device.type).trimmed()),
             .slave = static_cast<int>(i)});
  }
}

void GoToDialog::addSettings(const Project& project, int node) {
  for (const auto& setting : settings::table()) {
    settings::Place place;
    if (setting.of_slave()) {
      const auto at = static_cast<std::size_t>(node);
      if (node < 0 || at >= project.slaves.size()) continue;
      if (setting.applies && !setting.applies(project.slaves[at])) continue;
      place.slave = static_cast<std::size_t>(node);
    }
    // Lists have a key for each item; their first one leads to all of them.
    if (setting.items) {
      const auto items = setting.items(project, place.slave);
      if (items.empty()) continue;
      place = items.front();
      place.slave = setting.of_slave() ? static_cast<std::size_t>(node) : 0;
    }
    const auto key = QString::fromStdString(settings::key_of(setting, place));
    addGoal({.text = settingLabel(setting), .detail = tr("setting"), .key = key});
  }
}

void GoToDialog::addActions(const QMenu& menu) {
  for (auto* action : menu.actions()) {
    const auto text = withoutMenuKey(action->text()).remove(u'…');
    if (text.isEmpty() || action->menu() != nullptr || !action->isEnabled()) continue;
    addGoal(
        {.text = text,
         .detail = action->shortcut().isEmpty() ? tr("command") : action->shortcut().toString(QKeySequence::NativeText),
         .action = action});
  }
}

void GoToDialog::addItem(const QString& text, const QString& detail, std::size_t goal) {
  auto* item = new QListWidgetItem(QStringLiteral("%1  \u2013  %2").arg(text, detail), list_);
  item->setData(kGoalRole, static_cast<int>(goal));
}

void GoToDialog::showMatches() {
  list_->clear();
  goals_.resize(fixed_);
  const auto words = words_->text().toLower().split(u' ', Qt::SkipEmptyParts);
  // Those whose name begins with what was typed come first.
  for (const bool first : {true, false}) {
    for (std::size_t i = 0; i < fixed_ && list_->count() < kMostGoals; ++i) {
      const auto& goal = goals_[i];
      const bool begins = !words.isEmpty() && (goal.text.startsWith(words.front(), Qt::CaseInsensitive) ||
                                               goal.detail.contains(u' ' + words.front() + u','));
      if (begins != first || !matches(goal.found_by, words)) continue;
      addItem(goal.text, goal.key.isEmpty() ? goal.detail : goal.key, i);
    }
  }
  if (words.join(QString()).size() >= kLeastLetters) showOfSlaves(words);
  if (list_->count() == 0) {
    auto* nothing = new QListWidgetItem(
        tr("Nothing fits. Slaves are found by name, position, address and type, settings by label and key, objects of "
           "their ESI by index and name."),
        list_);
    nothing->setFlags(Qt::NoItemFlags);
  }
  list_->setCurrentRow(0);
}

/// What else the slaves have, behind what is nearer.
void GoToDialog::showOfSlaves(const QStringList& words) {
  for (const auto& one : search_.settings(words, kMostOfSlaves)) {
    goals_.push_back({.text = one.text, .slave = one.slave, .key = one.key});
    addItem(one.text, one.detail, goals_.size() - 1);
  }
  for (const auto& one : search_.objects(words, kMostOfSlaves)) {
    goals_.push_back({.text = one.text, .slave = one.slave, .object = one.object});
    addItem(one.text, one.detail, goals_.size() - 1);
  }
}

void GoToDialog::go() {
  const auto* item = list_->currentItem();
  if (item == nullptr || !item->data(kGoalRole).isValid()) return;
  const auto goal = goals_[static_cast<std::size_t>(item->data(kGoalRole).toInt())];
  accept();
  if (goal.action) return goal.action->trigger();
  if (goal.object) return Q_EMIT objectWanted(goal.slave, *goal.object);
  if (!goal.key.isEmpty()) return Q_EMIT keyWanted(goal.key);
  Q_EMIT nodeWanted(goal.slave);
}

/// The list is walked through from the field.
bool GoToDialog::eventFilter(QObject* object, QEvent* event) {
  if (object != words_ || event->type() != QEvent::KeyPress) return QDialog::eventFilter(object, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      QCoreApplication::sendEvent(list_, event);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      go();
      return true;
    default:
      return QDialog::eventFilter(object, event);
  }
}

}  // namespace syncline::ui
