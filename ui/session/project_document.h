// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <vector>

#include "config/project.h"
#include "settings/settings_keys.h"
#include "support/result.h"
#include "ui/commands/edit_project_command.h"

namespace syncline::ui {

/// The project being edited: a value, its undo steps and its file.
class ProjectDocument final : public QObject, private ProjectHolder {
  Q_OBJECT

 public:
  explicit ProjectDocument(QObject* parent = nullptr);

  [[nodiscard]] const Project& project() const { return project_; }
  [[nodiscard]] QUndoStack& undoStack() { return undo_; }
  [[nodiscard]] const QString& path() const { return path_; }
  /// File name without folder, or a name for a project that was not saved yet.
  [[nodiscard]] QString displayName() const;
  [[nodiscard]] bool isModified() const { return !undo_.isClean(); }

  /// One undo step called `text`. An edit that fails changes nothing, one without effect makes no step.
  Status edit(const QString& text, ProjectEdit edit);
  /// Settings by key, as `synclinectl project set` writes them; all in one undo step.
  Status set(const QString& text, std::vector<SettingValue> settings);
  Status set(const QString& text, const QString& key, const QString& value);
  /// Another project in place of this one, as one undo step (scan).
  void replace(const QString& text, Project project);

  /// Empty project, no file, no undo steps.
  void reset();
  Status load(const QString& path);
  Status save(const QString& path);

 Q_SIGNALS:
  /// `structural`: slaves came or went.
  void projectChanged(bool structural);
  void pathChanged();
  void modifiedChanged(bool modified);

 private:
  Project& mutableProject() override { return project_; }
  void projectEdited(bool structural) override;

  Project project_;
  /// The file that `project_` came from: its other networks go back into it when it is saved.
  Machine machine_;
  QUndoStack undo_;
  QString path_;
};

}  // namespace syncline::ui
