// SPDX-License-Identifier: Apache-2.0
#include "ui/commands/edit_project_command.h"

#include <algorithm>

namespace syncline::ui {

ProjectPatch ProjectPatch::between(const Project& before, const Project& after) {
  ProjectPatch patch;
  if (before.name != after.name) patch.name_ = before.name;
  if (!(before.master == after.master)) patch.master_ = before.master;
  if (before.slaves.size() != after.slaves.size()) {
    patch.all_slaves_ = before.slaves;
    return patch;
  }
  for (std::size_t i = 0; i < before.slaves.size(); ++i) {
    if (!(before.slaves[i] == after.slaves[i])) patch.slaves_.emplace_back(i, before.slaves[i]);
  }
  return patch;
}

ProjectPatch ProjectPatch::of(const Project& project, bool master, const std::vector<std::size_t>& slaves) {
  ProjectPatch patch;
  if (master) {
    patch.name_ = project.name;
    patch.master_ = project.master;
  }
  for (const auto slave : slaves) patch.slaves_.emplace_back(slave, project.slaves[slave]);
  return patch;
}

bool ProjectPatch::same(const Project& project) const {
  return (!name_ || *name_ == project.name) && (!master_ || *master_ == project.master) &&
         (!all_slaves_ || *all_slaves_ == project.slaves) &&
         std::ranges::all_of(slaves_, [&](const auto& part) { return project.slaves[part.first] == part.second; });
}

void ProjectPatch::restore(Project& project) const {
  if (name_) project.name = *name_;
  if (master_) project.master = *master_;
  if (all_slaves_) project.slaves = *all_slaves_;
  for (const auto& [position, slave] : slaves_) project.slaves[position] = slave;
}

EditProjectCommand::EditProjectCommand(ProjectHolder& holder, const QString& text, ProjectEdit edit,
                                       ProjectPatch before)
    : QUndoCommand(text), holder_(holder), edit_(std::move(edit)), before_(std::move(before)) {}

void EditProjectCommand::undo() {
  before_.restore(holder_.mutableProject());
  holder_.projectEdited(before_.structural());
}

void EditProjectCommand::redo() {
  auto& project = holder_.mutableProject();
  // Views are no part of the steps: a step that puts another project in place leaves them as they are.
  auto views = project.views;
  // The edit was tried on a copy before this command was made, and it is pure: it cannot fail here.
  const auto status = edit_(project);
  project.views = std::move(views);
  if (status) holder_.projectEdited(before_.structural());
}

}  // namespace syncline::ui
