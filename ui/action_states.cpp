// SPDX-License-Identifier: Apache-2.0
#include "ui/action_states.h"

#include "ui/actions.h"
#include "ui/dialogs/recording_commands.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

void updateActionStates(const Actions& actions, Workspace& workspace, const RecordingCommands& recordings) {
  const bool recorded = workspace.recording().isOpen();
  const bool some = !workspace.document().project().slaves.empty() && !recorded;
  const bool busy = workspace.scan().isRunning() || recorded;
  const auto phase = workspace.live().phase();
  const bool online = phase == LiveSession::Phase::kOnline;
  actions.create->setEnabled(!busy);
  actions.new_machine->setEnabled(!busy);
  actions.open->setEnabled(!workspace.scan().isRunning());
  for (auto* action : {actions.save, actions.save_as, actions.export_eni, actions.compare}) action->setEnabled(some);
  actions.save_template->setEnabled(some && workspace.templates().isKept());
  actions.go_to->setEnabled(!recorded);
  // Nobody would see what they change.
  const auto& steps = workspace.document().undoStack();
  actions.undo->setEnabled(steps.canUndo() && !recorded);
  actions.redo->setEnabled(steps.canRedo() && !recorded);
  actions.scan->setEnabled(!busy);
  actions.demo->setEnabled(!busy);
  actions.online->setEnabled(some && phase == LiveSession::Phase::kOffline && !busy);
  actions.choose_link->setEnabled(some && phase == LiveSession::Phase::kOffline && !busy);
  actions.offline->setEnabled(phase != LiveSession::Phase::kOffline && phase != LiveSession::Phase::kStopping);
  actions.clear_statistics->setEnabled(online);
  for (auto* action : actions.states) action->setEnabled(online);
  updateRecordingStates(actions, workspace, recordings);
}

void updateRecordingStates(const Actions& actions, Workspace& workspace, const RecordingCommands& recordings) {
  const bool shown = workspace.recording().isOpen();
  const auto& disk = workspace.disk();
  actions.close_recording->setEnabled(shown);
  actions.overlay->setEnabled(shown);
  actions.record->setText(disk.isRecording() ? MainWindow::tr("Stop &Recording") : MainWindow::tr("&Record…"));
  actions.record->setChecked(disk.isRecording());
  actions.record->setEnabled(workspace.live().phase() == LiveSession::Phase::kOnline || disk.isRecording());
  actions.commissioning->setEnabled(workspace.shownRecord() != nullptr && !workspace.shownRecord()->samples().empty());
  actions.save_recent->setText(recordings.saveLastText());
  actions.save_recent->setEnabled(disk.remembered() > 0 && !shown);
  for (auto* action : {actions.create, actions.scan, actions.demo, actions.online, actions.offline, actions.record,
                       actions.save_recent, actions.clear_statistics, actions.go_to, actions.undo, actions.redo}) {
    if (shown && action->property("usualTip").isNull()) {
      action->setProperty("usualTip", action->toolTip());
      action->setToolTip(
          MainWindow::tr("A recording is shown, and nothing runs: close it first (File, Close Recording)"));
    } else if (!shown && !action->property("usualTip").isNull()) {
      action->setToolTip(action->property("usualTip").toString());
      action->setProperty("usualTip", QVariant());
    }
  }
}

}  // namespace syncline::ui
