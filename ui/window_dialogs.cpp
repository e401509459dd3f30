// SPDX-License-Identifier: Apache-2.0
#include "ui/window_dialogs.h"

#include <QMainWindow>
#include <QMenuBar>

#include "ui/dialogs/compare_dialog.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/go_to_dialog.h"
#include "ui/session/workspace.h"
#include "ui/wizard/new_machine_wizard.h"

namespace syncline::ui {

WindowDialogs::WindowDialogs(Workspace& workspace, FileCommands& files, QMainWindow& window)
    : QObject(&window), workspace_(workspace), files_(files), window_(window) {}

void WindowDialogs::compare(const ComparedSide& left, const ComparedSide& right) {
  auto* dialog = window_.findChild<CompareDialog*>();
  if (dialog == nullptr) {
    dialog = new CompareDialog(workspace_, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &CompareDialog::placeWanted, this, &WindowDialogs::placeWanted);
  }
  dialog->compare(left, right);
  dialog->show();
  dialog->activateWindow();
}

void WindowDialogs::makeNewMachine() {
  auto* wizard = new NewMachineWizard(workspace_, &window_);
  wizard->setAttribute(Qt::WA_DeleteOnClose);
  connect(wizard, &NewMachineWizard::taken, this,
          [this, wizard](const Machine& machine, const QString& link, const QString& eni_path) {
            if (!files_.takeNew(machine)) return;
            if (!link.isEmpty()) workspace_.setLink(link);
            wizard->accept();
            if (!eni_path.isEmpty()) files_.exportTo(eni_path);
          });
  wizard->open();
}

void WindowDialogs::search(int node) {
  auto* dialog = new GoToDialog(workspace_.document().project(), node, *window_.menuBar(), &window_);
  connect(dialog, &GoToDialog::nodeWanted, this, &WindowDialogs::nodeWanted);
  connect(dialog, &GoToDialog::keyWanted, this, &WindowDialogs::keyWanted);
  connect(dialog, &GoToDialog::objectWanted, this, &WindowDialogs::objectWanted);
  dialog->open();
}

}  // namespace syncline::ui
