// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoGroup>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <vector>

#include "config/project.h"
#include "reasons/because.h"
#include "support/result.h"
#include "ui/commands/edit_project_command.h"
#include "ui/files/held_file.h"
#include "ui/session/project_lock.h"
#include "ui/session/setting_edit.h"

namespace syncline::ui {

/// A slave that stays who it is while others come, go and move.
struct SlaveMark {
  std::uint64_t generation = 0;
  int address = 0;  // station address, 0 = the master
};

/// The machine being edited: its networks, of which one is in work as a value, with the undo steps of each, and its
/// file.
class ProjectDocument final : public QObject, private ProjectHolder {
  Q_OBJECT

 public:
  explicit ProjectDocument(QObject* parent = nullptr);

  [[nodiscard]] const Project& project() const { return project_; }
  /// What the monitor draws of the network in work.
  [[nodiscard]] const std::vector<MonitorView>& views() const { return project_.views; }
  /// Steps of the network in work.
  [[nodiscard]] QUndoStack& undoStack() { return *stacks_[current_]; }
  /// Whichever network is in work.
  [[nodiscard]] QUndoGroup& undoGroup() { return undo_; }
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
  /// Of all networks.
  [[nodiscard]] bool isModified() const;

  /// All networks of the machine in their order; those without a name by their number.
  [[nodiscard]] QStringList networks() const;
  [[nodiscard]] int network() const { return static_cast<int>(current_); }
  /// Any of the networks as it is now.
  [[nodiscard]] const Project& project(int network) const;
  /// Takes another network in work; edits and undo steps of the one before stay its own.
  void chooseNetwork(int network);
  /// A new network without slaves behind the others, in work from now on.
  void addNetwork(const QString& name);
  /// Takes the network in work out of the machine, with its undo steps, unless it is the only one.
  void removeNetwork();

  /// One undo step called `text`. An edit that fails changes nothing, one without effect makes no step.
  Status edit(const QString& text, ProjectEdit edit);
  /// Settings of the table; all in one undo step. The error's subject is the key.
  Status set(const QString& text, std::vector<SettingEdit> edits);
  /// No undo step: whoever looks at curves does not edit the machine;
  /// but the file lacks them until it is saved.
  void setViews(std::vector<MonitorView> views);
  /// Another project in place of this one, as one undo step (scan); views stay.
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
  /// Fails without a trace when another window has the file open, or this one shows it as something else.
  Status save(const QString& path);
  /// All networks of the file with the edited one.
  [[nodiscard]] Machine machine() const;
  /// Another window that has this file open, in words; empty: none.
  [[nodiscard]] QString holder(const QString& path) const { return lock_.holder(path); }
  /// Another window has the file open: it can only be saved under another name.
  [[nodiscard]] bool readOnly() const { return !path_.isEmpty() && !lock_.held(); }

 Q_SIGNALS:
  /// Another machine comes in place of this one (reset, take, load), which is still there.
  void machineReplaced();
  /// This network goes, and is still there.
  void networkRemoved(int network);
  /// Another machine or network is edited from now on (reset, take, load, chooseNetwork): comes first of all. What is
  /// known of the slaves that there were holds for none of these, alike as they may be.
  void taken();
  /// Comes before projectChanged(true), for whoever holds what belongs to the slaves there were.
  void slavesReplaced();
  /// `structural`: slaves came or went.
  void projectChanged(bool structural);
  void viewsChanged();
  /// Of another machine, or because this one was saved under another name.
  void pathChanged();
  void modifiedChanged(bool modified);
  /// Networks came, went or changed their names, or another one is in work.
  void networksChanged();

 private:
  Project& mutableProject() override { return project_; }
  void projectEdited(bool structural) override;

  void setPath(const QString& path);
  void addStack();
  /// `network` comes in work in place of what was.
  void show(std::size_t network);

  Project project_;
  std::uint64_t generation_ = 0;
  Machine machine_;                                  // its networks as they were when each was in work last
  std::size_t current_ = 0;                          // the one of which `project_` is the present state
  std::vector<std::unique_ptr<QUndoStack>> stacks_;  // of each
  QUndoGroup undo_;
  bool viewed_ = false;     // views have changed since the file was read or written
  bool regrouped_ = false;  // networks came or went since the file was read or written
  QString path_;
  HeldFile file_{because("the project that is open here")};
  ProjectLock lock_;
};

}  // namespace syncline::ui
