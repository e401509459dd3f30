// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <optional>
#include <vector>

#include "config/project.h"
#include "settings/setting.h"
#include "support/result.h"
#include "ui/commands/edit_project_command.h"
#include "ui/session/project_lock.h"

namespace syncline::ui {

/// A value for a setting of the table (settings/settings_table.h).
struct SettingEdit {
  const settings::Setting* setting = nullptr;
  settings::Place place;
  settings::Value value;
};

/// A slave that stays who it is while others come, go and move.
struct SlaveMark {
  std::uint64_t generation = 0;
  int address = 0;  // station address, 0 = the master
};

/// The project being edited: a value, its undo steps and its file.
class ProjectDocument final : public QObject, private ProjectHolder {
  Q_OBJECT

 public:
  explicit ProjectDocument(QObject* parent = nullptr);

  [[nodiscard]] const Project& project() const { return project_; }
  [[nodiscard]] QUndoStack& undoStack() { return undo_; }
  [[nodiscard]] const QString& path() const { return path_; }
  /// Another one for each project that comes in place of the one before (reset, take, load, replace): answers to what
  /// was asked before are not about its slaves.
  [[nodiscard]] std::uint64_t generation() const { return generation_; }
  /// To find a slave again, position -1 = the master.
  [[nodiscard]] SlaveMark mark(int slave) const;
  /// Where it stands now; empty: it is gone, or the project is another one.
  [[nodiscard]] std::optional<int> find(const SlaveMark& mark) const;
  /// File name without folder, or a name for a project that was not saved yet.
  [[nodiscard]] QString displayName() const;
  [[nodiscard]] bool isModified() const { return !undo_.isClean(); }

  /// One undo step called `text`. An edit that fails changes nothing, one without effect makes no step.
  Status edit(const QString& text, ProjectEdit edit);
  /// Settings of the table; all in one undo step. The error's subject is the key.
  Status set(const QString& text, std::vector<SettingEdit> edits);
  /// Another project in place of this one, as one undo step (scan).
  void replace(const QString& text, Project project);

  /// Empty project, no file, no undo steps.
  void reset();
  /// What a file holds, before anything else is touched.
  [[nodiscard]] static Result<Machine> read(const QString& path);
  /// `machine` in place of what is edited, without undo steps. `saved`: it is what the file holds; else it counts as
  /// modified until it is saved.
  void take(Machine machine, const QString& path, bool saved = true);
  /// read() and take().
  Status load(const QString& path);
  /// Fails without a trace when another window has the file open.
  Status save(const QString& path);
  /// All networks of the file with the edited one.
  [[nodiscard]] Machine machine() const;
  /// Another window that has this file open, in words; empty: none.
  [[nodiscard]] QString holder(const QString& path) const { return lock_.holder(path); }
  /// Another window has the file open: it can only be saved under another name.
  [[nodiscard]] bool readOnly() const { return !path_.isEmpty() && !lock_.held(); }

 Q_SIGNALS:
  /// Another machine is edited from now on (reset, take, load): comes first of all. What is known of the slaves that
  /// there were holds for none of these, alike as they may be.
  void taken();
  /// Comes before projectChanged(true), for whoever holds what belongs to the slaves there were.
  void slavesReplaced();
  /// `structural`: slaves came or went.
  void projectChanged(bool structural);
  /// Of another machine, or because this one was saved under another name.
  void pathChanged();
  void modifiedChanged(bool modified);

 private:
  Project& mutableProject() override { return project_; }
  void projectEdited(bool structural) override;

  Project project_;
  std::uint64_t generation_ = 0;
  /// The file that `project_` came from: its other networks go back into it when it is saved.
  Machine machine_;
  QUndoStack undo_;
  QString path_;
  ProjectLock lock_;
};

}  // namespace syncline::ui
