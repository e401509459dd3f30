// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/project.h"
#include "support/result.h"

namespace syncline::ui {

/// A pure edit: changes the project it is given or fails and leaves it alone.
using ProjectEdit = std::function<Status(Project&)>;

/// The parts of a project that an edit replaced, and the means to put them back; its views are none of them. Slaves
/// carry whole device descriptions, so only the changed ones are kept.
class ProjectPatch {
 public:
  static ProjectPatch between(const Project& before, const Project& after);
  /// What `project` holds of the network and its master, and of these slaves.
  static ProjectPatch of(const Project& project, bool master, const std::vector<std::size_t>& slaves);
  /// Putting the parts back would change nothing.
  [[nodiscard]] bool same(const Project& project) const;
  void restore(Project& project) const;
  [[nodiscard]] bool empty() const { return !name_ && !master_ && !all_slaves_ && slaves_.empty(); }
  /// Slaves came, went or changed their names and places (not only their settings).
  [[nodiscard]] bool structural() const { return all_slaves_.has_value(); }

 private:
  std::optional<std::string> name_;
  std::optional<MasterSettings> master_;
  std::optional<std::vector<SlaveSettings>> all_slaves_;
  std::vector<std::pair<std::size_t, SlaveSettings>> slaves_;
};

/// Where the command puts the project it made.
class ProjectHolder {
 public:
  virtual ~ProjectHolder() = default;
  virtual Project& mutableProject() = 0;
  virtual void projectEdited(bool structural) = 0;
};

/// One undo step: redo applies the edit, undo puts the replaced parts back.
class EditProjectCommand final : public QUndoCommand {
 public:
  EditProjectCommand(ProjectHolder& holder, const QString& text, ProjectEdit edit, ProjectPatch before);
  void undo() override;
  void redo() override;

 private:
  ProjectHolder& holder_;
  ProjectEdit edit_;
  ProjectPatch before_;
};

}  // namespace syncline::ui
