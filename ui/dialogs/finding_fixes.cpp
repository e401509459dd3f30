// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/finding_fixes.h"

#include <QAction>
#include <QMenu>
#include <memory>
#include <utility>

#include "advice/quick_fixes.h"
#include "ui/session/workspace.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/setting_text.h"

namespace syncline::ui {
namespace {

/// "1000 us", "auto", the words of a choice.
QString valueWords(const QuickFix& fix, const Project& project) {
  const auto& setting = *fix.setting;
  if (std::holds_alternative<settings::Unset>(fix.value)) return settingWord(setting.unset);
  const auto& place = fix.places.front();
  const auto* choice = std::get_if<settings::Choice>(&setting.type);
  if (choice != nullptr) {
    const auto options = setting.options ? setting.options(project, place) : choice->options;
    for (const auto& option : options) {
      if (option.value == fix.value) return optionText(option);
    }
  }
  auto changed = project;
  if (!settings::set_value(setting, changed, place, fix.value)) return {};
  return QString::fromStdString(settings::text_with_unit(setting, changed, place));
}

}  // namespace

FindingFixes::FindingFixes(Workspace& workspace, std::function<bool()> commit, QObject* parent)
    : QObject(parent), workspace_(workspace), commit_(std::move(commit)) {}

void FindingFixes::fill(QMenu& menu, const Message& message) {
  addWay(menu, message);
  if (message.finding == nullptr || message.key.isEmpty()) return;
  menu.addSeparator();
  if (addFixes(menu, message)) return;
  auto* none = menu.addAction(tr("No single value of this setting mends it"));
  none->setEnabled(false);
}

void FindingFixes::addWay(QMenu& menu, const Message& message) {
  auto* go = menu.addAction(!message.key.isEmpty() ? tr("Go to the Setting")
                            : message.slave < 0    ? tr("Show the Master")
                                                   : tr("Show Its Slave"));
  go->setObjectName(QStringLiteral("messageGo"));
  connect(go, &QAction::triggered, this,
          [this, slave = message.slave, key = message.key] { Q_EMIT placeWanted(slave, key); });
}

/// Those about the project name its slaves, the others those that run.
Message FindingFixes::lineFor(const Finding& finding) const {
  if (const auto* line = workspace_.messages().lineOf(finding)) return *line;
  auto own = finding;
  if (!workspace_.recording().isOpen()) own.place.slave = workspace_.runningSlaves().slaveOf(finding.place.slave);
  Message line;
  line.severity = own.severity;
  line.slave = own.place.slave;
  line.key = findingKey(own);
  line.finding = std::make_shared<const Finding>(std::move(own));
  return line;
}

void FindingFixes::go(const Finding& finding) {
  const auto line = lineFor(finding);
  if (line.slave >= 0 || finding.place.slave < 0) Q_EMIT placeWanted(line.slave, line.key);
}

void FindingFixes::fillFor(QMenu& menu, const Finding& finding) {
  const auto line = lineFor(finding);
  if (workspace_.messages().lineOf(finding) != nullptr) return fill(menu, line);
  addWay(menu, line);
  // What it takes where no value is advised, the next run shows.
  if (!workspace_.recording().isOpen() && !line.key.isEmpty()) addFixes(menu, line);
}

bool FindingFixes::addFixes(QMenu& menu, const Message& message) {
  const auto& project = workspace_.document().project();
  const auto fixes = quick_fixes(project, *message.finding, message.found_at);
  for (const auto& fix : fixes) {
    const auto label = settingLabel(*fix.setting);
    const auto words = valueWords(fix, project);
    const int count = static_cast<int>(fix.places.size());
    auto text = count > 1 ? tr("Set %1 of %n slave(s) to %2", nullptr, count).arg(label, words)
                          : tr("Set %1 to %2").arg(label, words);
    auto* action = menu.addAction(text);
    action->setObjectName(QStringLiteral("messageFix"));
    connect(action, &QAction::triggered, this, [this, fix, text] {
      if (!commit_()) return;
      std::vector<SettingEdit> edits;
      for (const auto& place : fix.places) edits.push_back({fix.setting, place, fix.value});
      if (auto status = workspace_.document().set(text, std::move(edits)); !status)
        workspace_.report(status.error(), Severity::kError, tr("Configuration"));
    });
  }
  return !fixes.empty();
}

}  // namespace syncline::ui
