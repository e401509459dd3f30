// SPDX-License-Identifier: Apache-2.0
#include "ui/session/project_document.h"

#include <fmt/format.h>

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "eni/project/project_file.h"
#include "reasons/because.h"
#include "settings/settings_table.h"
#include "ui/files/held_file.h"

namespace syncline::ui {
namespace {

Status applyAll(Project& project, const std::vector<SettingEdit>& edits) {
  for (const auto& [setting, place, value] : edits) {
    if (auto status = settings::set_value(*setting, project, place, value); !status) {
      status.error().subject = settings::key_of(*setting, place);
      return status;
    }
  }
  return {};
}

}  // namespace

ProjectDocument::ProjectDocument(QObject* parent) : QObject(parent) {
  machine_.networks.emplace_back();
  addStack();
  undo_.setActiveStack(stacks_.front().get());
}

void ProjectDocument::addStack() {
  auto* stack = stacks_.emplace_back(std::make_unique<QUndoStack>()).get();
  undo_.addStack(stack);
  connect(stack, &QUndoStack::cleanChanged, this, [this] { Q_EMIT modifiedChanged(isModified()); });
}

bool ProjectDocument::isModified() const {
  // A stack that goes with its network, or with all of them, tells that it is empty while its neighbours are gone
  // already.
  const auto clean = [](const auto& stack) { return stack == nullptr || stack->isClean(); };
  return regrouped_ || viewed_ || !std::ranges::all_of(stacks_, clean);
}

QString ProjectDocument::displayName() const { return path_.isEmpty() ? tr("Untitled") : QFileInfo(path_).fileName(); }

SlaveMark ProjectDocument::mark(int slave) const {
  const auto at = static_cast<std::size_t>(slave);
  const bool is_slave = slave >= 0 && at < project_.slaves.size();
  return {generation_, is_slave ? project_.slaves[at].station_address : 0};
}

std::optional<int> ProjectDocument::find(const SlaveMark& mark) const {
  if (mark.generation != generation_) return std::nullopt;
  if (mark.address == 0) return -1;
  const auto found = std::ranges::find(project_.slaves, mark.address,
                                       [](const SlaveSettings& slave) { return int{slave.station_address}; });
  if (found == project_.slaves.end()) return std::nullopt;
  return static_cast<int>(found - project_.slaves.begin());
}

Status ProjectDocument::edit(const QString& text, ProjectEdit edit) {
  Project changed = project_;
  if (auto status = edit(changed); !status) return status;
  auto patch = ProjectPatch::between(project_, changed);
  if (!patch.empty()) undoStack().push(new EditProjectCommand(*this, text, std::move(edit), std::move(patch)));
  return {};
}

Status ProjectDocument::set(const QString& text, std::vector<SettingEdit> edits) {
  bool master = false;
  std::vector<std::size_t> slaves;
  for (const auto& [setting, place, value] : edits) {
    if (!setting->of_slave()) {
      master = true;
    } else if (place.slave >= project_.slaves.size()) {
      return fail(ErrorCode::kUnknownKey, settings::key_of(*setting, place), because("the slave is gone"));
    } else if (std::ranges::find(slaves, place.slave) == slaves.end()) {
      slaves.push_back(place.slave);
    }
  }
  // A setting touches its slave or the master alone: the other slaves of a large machine need not be copied.
  auto before = ProjectPatch::of(project_, master, slaves);
  const auto status = applyAll(project_, edits);
  const bool changed = !before.same(project_);
  before.restore(project_);
  if (!status || !changed) return status;
  const auto again = [edits = std::move(edits)](Project& project) { return applyAll(project, edits); };
  undoStack().push(new EditProjectCommand(*this, text, again, std::move(before)));
  return {};
}

void ProjectDocument::setViews(std::vector<MonitorView> views) {
  if (views == project_.views) return;
  project_.views = std::move(views);
  const bool told = std::exchange(viewed_, true);
  Q_EMIT viewsChanged();
  if (!told) Q_EMIT modifiedChanged(isModified());
}

void ProjectDocument::replace(const QString& text, Project project) {
  ++generation_;
  static_cast<void>(edit(text, [project = std::move(project)](Project& target) -> Status {
    target = project;
    return {};
  }));
}

void ProjectDocument::reset() { take({}, {}); }

Result<Machine> ProjectDocument::read(const QString& path) { return eni::load_machine(path.toStdString()); }

void ProjectDocument::take(Machine machine, const QString& path, bool saved) {
  Q_EMIT machineReplaced();
  ++generation_;
  machine_ = std::move(machine);
  if (machine_.networks.empty()) machine_.networks.emplace_back();
  project_ = machine_.networks.front();
  current_ = 0;
  setPath(path);
  stacks_.resize(1);
  stacks_.front()->clear();
  while (stacks_.size() < machine_.networks.size()) addStack();
  undo_.setActiveStack(stacks_.front().get());
  regrouped_ = viewed_ = false;
  if (!saved) stacks_.front()->resetClean();
  Q_EMIT taken();
  Q_EMIT pathChanged();
  projectEdited(true);
  Q_EMIT networksChanged();
}

Status ProjectDocument::load(const QString& path) {
  auto loaded = read(path);
  if (!loaded) return tl::unexpected(loaded.error());
  take(std::move(*loaded), path);
  return {};
}

Status ProjectDocument::save(const QString& path) {
  const auto holder = lock_.holder(path);
  if (!holder.isEmpty()) {
    return fail(ErrorCode::kFileNotWritable, path.toStdString(),
                because("another window has it open ({who}): save under another name", holder.toStdString()));
  }
  if (auto status = mayWrite(path, &file_); !status) return status;
  if (auto status = eni::save_machine(machine(), path.toStdString()); !status) return status;
  setPath(path);
  const bool regrouped = std::exchange(regrouped_, false);
  const bool viewed = std::exchange(viewed_, false);
  for (const auto& stack : stacks_) stack->setClean();
  if (regrouped || viewed) Q_EMIT modifiedChanged(isModified());
  Q_EMIT pathChanged();
  return {};
}

void ProjectDocument::setPath(const QString& path) {
  path_ = path;
  file_.hold(path);
  lock_.take(path);
}

Machine ProjectDocument::machine() const {
  auto machine = machine_;
  machine.networks[current_] = project_;
  return machine;
}

const Project& ProjectDocument::project(int network) const {
  return network == this->network() ? project_ : machine_.networks[static_cast<std::size_t>(network)];
}

QStringList ProjectDocument::networks() const {
  QStringList names;
  for (std::size_t i = 0; i < machine_.networks.size(); ++i) {
    const auto& name = project(static_cast<int>(i)).name;
    names << (name.empty() ? tr("Network %1").arg(i + 1) : QString::fromStdString(name));
  }
  return names;
}

void ProjectDocument::show(std::size_t network) {
  ++generation_;
  current_ = network;
  project_ = machine_.networks[network];
  undo_.setActiveStack(stacks_[network].get());
  Q_EMIT taken();
  projectEdited(true);
  Q_EMIT networksChanged();
}

void ProjectDocument::chooseNetwork(int network) {
  const auto wanted = static_cast<std::size_t>(network);
  if (network < 0 || wanted >= machine_.networks.size() || wanted == current_) return;
  machine_.networks[current_] = project_;
  show(wanted);
}

void ProjectDocument::addNetwork(const QString& name) {
  machine_.networks[current_] = project_;
  machine_.networks.emplace_back().name = name.toStdString();
  addStack();
  regrouped_ = true;
  show(machine_.networks.size() - 1);
  Q_EMIT modifiedChanged(true);
}

void ProjectDocument::removeNetwork() {
  if (machine_.networks.size() < 2) return;
  Q_EMIT networkRemoved(network());
  const auto gone = static_cast<std::ptrdiff_t>(current_);
  machine_.networks.erase(machine_.networks.begin() + gone);
  stacks_.erase(stacks_.begin() + gone);
  regrouped_ = true;
  show(std::min(current_, machine_.networks.size() - 1));
  Q_EMIT modifiedChanged(true);
}

void ProjectDocument::projectEdited(bool structural) {
  if (structural) Q_EMIT slavesReplaced();
  Q_EMIT projectChanged(structural);
  if (machine_.networks[current_].name != project_.name) {
    machine_.networks[current_].name = project_.name;
    Q_EMIT networksChanged();
  }
}

}  // namespace syncline::ui
