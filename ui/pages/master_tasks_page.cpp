// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/master_tasks_page.h"

#include <QGridLayout>
#include <algorithm>

#include "ui/editors/field_binder.h"
#include "ui/editors/record_editor.h"
#include "ui/pages/sync_unit_tree.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

using Kind = RecordPart::Kind;
constexpr const char *kTask = "master.task.K", *kUnit = "master.sync_unit.K";

QString fromStd(const std::string& text) { return QString::fromStdString(text); }

// "Slow x4"
QString taskName(const std::string& record) { return fromStd(record.substr(0, record.rfind(" x"))); }
QString taskMultiple(const std::string& record) { return fromStd(record.substr(record.rfind(" x") + 2)); }
std::string taskText(const QString& name, const QString& multiple) {
  return QStringLiteral("%1 x%2").arg(name, multiple.trimmed()).toStdString();
}

// "Heating@Slow"
QString unitName(const std::string& record) { return fromStd(record.substr(0, record.rfind('@'))); }
QString unitTask(const std::string& record) {
  const auto mark = record.rfind('@');
  return mark == std::string::npos ? QString() : fromStd(record.substr(mark + 1));
}
std::string unitText(const QString& name, const QString& task) {
  return (task.isEmpty() ? name : QStringLiteral("%1@%2").arg(name, task)).toStdString();
}

/// "Task 2" that no record has yet.
QString freshName(const QString& word, const Records& records, QString (*name)(const std::string&)) {
  for (int number = static_cast<int>(records.size()) + 1;; ++number) {
    auto candidate = QStringLiteral("%1 %2").arg(word).arg(number);
    if (std::ranges::none_of(records, [&](const std::string& record) { return name(record) == candidate; })) {
      return candidate;
    }
  }
}

/// The one name that became another or went: then who refers to it follows.
std::optional<std::pair<QString, QString>> renamed(const Records& before, const Records& after,
                                                   QString (*name)(const std::string&)) {
  const auto lost = std::ranges::find_if(before, [&](const std::string& record) {
    return std::ranges::none_of(after, [&](const std::string& other) { return name(other) == name(record); });
  });
  if (lost == before.end()) return {};
  const auto at = static_cast<std::size_t>(lost - before.begin());
  return std::pair(name(*lost), before.size() == after.size() ? name(after[at]) : QString());
}

RecordPart namePart(const char* object_name, const QString& label, const QString& tip,
                    QString (*name)(const std::string&), std::string (*join)(const QString&, const QString&),
                    QString (*rest)(const std::string&)) {
  return {.object_name = object_name,
          .label = label,
          .tip = tip,
          .text = [name](const Records& records, std::size_t row) { return name(records[row]); },
          .put = [join, rest](const std::string& record, const QString& typed) -> Result<std::string> {
            return join(typed.trimmed(), rest(record));
          }};
}

}  // namespace

MasterTasksPage::MasterTasksPage(Workspace& workspace) : Page(workspace, "masterTasksPage", tr("Tasks (Expert)")) {
  fields().setExpertPage();
  std::vector<RecordPart> task_parts{
      namePart("taskName", tr("Task"), tr("Name of the task (ENI Cyclic)"), taskName, taskText, taskMultiple),
      {.object_name = "taskMultiple",
       .label = tr("Bus cycles"),
       .tip = tr("Its frames are sent in every so many-th bus cycle, 1 to 1000"),
       .width = 90,
       .text = [](const Records& records, std::size_t row) { return taskMultiple(records[row]); },
       .put = [](const std::string& record, const QString& typed) -> Result<std::string> {
         return taskText(taskName(record), typed);
       }},
      {.label = tr("Cycle"),
       .tip = {},
       .kind = Kind::kShown,
       .width = 90,
       .text = [this](const Records& r, std::size_t row) {
         return cycleText(project().master.cycle_time * taskMultiple(r[row]).toLongLong());
       }}};
  tasks_ = new RecordEditor(*this, "tasks", tr("Tasks beside the Base Task"), tasks(), std::move(task_parts), false);
  std::vector<RecordPart> unit_parts{
      namePart("unitName", tr("Sync Unit"), tr("Slaves of one unit are exchanged in datagrams of their own"), unitName,
               unitText, unitTask),
      {.object_name = "unitTask",
       .label = tr("Task"),
       .tip = tr("The task that exchanges the unit's process data"),
       .kind = Kind::kChoice,
       .width = 120,
       .text = [](const Records& records, std::size_t row) { return unitTask(records[row]); },
       .put = [](const std::string& record, const QString& typed) -> Result<std::string> {
         return unitText(unitName(record), typed);
       },
       .options = [this] { return taskNames(); }},
      {.label = tr("Slaves"),
       .tip = {},
       .kind = Kind::kShown,
       .width = 64,
       .text = [this](const Records& r, std::size_t row) {
         const auto name = unitName(r[row]).toStdString();
         return QString::number(std::ranges::count_if(project().slaves, [&](const SlaveSettings& slave) {
           return slave.output_unit == name || slave.input_unit == name;
         }));
       }}};
  units_ = new RecordEditor(*this, "units", tr("Sync Units"), units(), std::move(unit_parts), false);
  members_ = new SyncUnitTree(*this);
  auto* content = new QWidget;
  auto* layout = new QGridLayout(content);
  layout->setContentsMargins(12, 10, 12, 10);
  layout->setSpacing(14);
  layout->addWidget(tasks_, 0, 0);
  layout->addWidget(units_, 0, 1);
  layout->addWidget(members_, 1, 0, 1, 2);
  layout->setRowStretch(1, 1);
  setWidget(content);
}

RecordList MasterTasksPage::tasks() {
  RecordList list{.key = kTask, .item = tr("task"), .read = {}, .edits = {}, .fresh = {}, .place = {}};
  list.nothing = tr("None: all process data are exchanged in each bus cycle.");
  list.read = [this] {
    Records records;
    for (const auto& task : project().master.tasks)
      records.push_back(taskText(fromStd(task.name), QString::number(task.multiple)));
    return records;
  };
  list.edits = [this](const Records& before, const Records& after) { return taskEdits(before, after); };
  list.fresh = [](const Records& records) {
    return taskText(freshName(tr("Task"), records, taskName), QStringLiteral("2"));
  };
  list.place = [this](int row) -> std::optional<settings::Place> {
    if (row < 0 || std::cmp_greater_equal(row, project().master.tasks.size())) return {};
    return settings::Place{0, static_cast<std::uint32_t>(row)};
  };
  return list;
}

RecordList MasterTasksPage::units() {
  RecordList list{.key = kUnit, .item = tr("Sync Unit"), .read = {}, .edits = {}, .fresh = {}, .place = {}};
  list.nothing = tr("None: the slaves share their datagrams. Once there is a unit, slaves are dragged to it below.");
  list.read = [this] {
    Records records;
    for (const auto& unit : project().master.sync_units)
      records.push_back(unitText(fromStd(unit.name), fromStd(unit.task)));
    return records;
  };
  list.edits = [this](const Records& before, const Records& after) { return unitEdits(before, after); };
  list.fresh = [](const Records& records) { return freshName(tr("Unit"), records, unitName).toStdString(); };
  list.place = [this](int row) -> std::optional<settings::Place> {
    if (row < 0 || std::cmp_greater_equal(row, project().master.sync_units.size())) return {};
    return settings::Place{0, static_cast<std::uint32_t>(row)};
  };
  return list;
}

QList<std::pair<QString, QString>> MasterTasksPage::taskNames() const {
  QList<std::pair<QString, QString>> names{{QString(), tr("Base task")}};
  for (const auto& task : project().master.tasks) names.append({fromStd(task.name), fromStd(task.name)});
  return names;
}

/// Units follow the name of their task; without it they are exchanged by the base task.
std::vector<SettingEdit> MasterTasksPage::taskEdits(const Records& before, const Records& after) const {
  auto edits = itemEdits(kTask, 0, before, after);
  const auto name = renamed(before, after, taskName);
  const auto& units = project().master.sync_units;
  for (std::size_t i = 0; name && i < units.size(); ++i) {
    if (fromStd(units[i].task) != name->first) continue;
    edits.push_back({&settings::row(kUnit),
                     {.item = static_cast<std::uint32_t>(i)},
                     settings::Value{unitText(fromStd(units[i].name), name->second)}});
  }
  return edits;
}

/// Slaves follow the name of their unit; without it they are in the unnamed one.
std::vector<SettingEdit> MasterTasksPage::unitEdits(const Records& before, const Records& after) const {
  auto edits = itemEdits(kUnit, 0, before, after);
  const auto name = renamed(before, after, unitName);
  const auto& slaves = project().slaves;
  for (std::size_t i = 0; name && i < slaves.size(); ++i) {
    const auto follow = [&](const std::string& unit, const char* key) {
      if (fromStd(unit) != name->first) return;
      SettingEdit edit{&settings::row(key), {.slave = i}, {}};
      edit.value.emplace<std::string>(name->second.toStdString());
      edits.push_back(std::move(edit));
    };
    follow(slaves[i].output_unit, "slave.N.sync_unit.outputs");
    follow(slaves[i].input_unit, "slave.N.sync_unit.inputs");
  }
  return edits;
}

bool MasterTasksPage::appliesTo(int slave) const {
  return slave < 0 && (expert() || !project().master.tasks.empty() || !project().master.sync_units.empty());
}

void MasterTasksPage::showPlace(const settings::Setting& setting, const settings::Place& place) {
  if (setting.key == kTask) tasks_->select(static_cast<int>(place.item));
  if (setting.key == kUnit) units_->select(static_cast<int>(place.item));
}

void MasterTasksPage::refresh() {
  tasks_->showRecords();
  units_->showRecords();
  members_->refresh();
  fields().refresh();
  tasks_->refreshButtons();
  units_->refreshButtons();
}

}  // namespace syncline::ui
