// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/template_commands.h"

#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <utility>

#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

TemplateCommands::TemplateCommands(Workspace& workspace, FileCommands& files, QWidget& window)
    : QObject(&window), workspace_(workspace), files_(files), window_(window) {}

void TemplateCommands::save() {
  const auto proposal = QFileInfo(workspace_.document().displayName()).completeBaseName();
  auto* dialog = new QInputDialog(&window_);
  dialog->setObjectName(QStringLiteral("templateName"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Save as Template"));
  dialog->setLabelText(tr("Name of the template:"));
  dialog->setTextValue(proposal);
  dialog->setOkButtonText(tr("Save"));
  connect(dialog, &QInputDialog::textValueSelected, this, &TemplateCommands::saveAs);
  dialog->open();
}

bool TemplateCommands::saveAs(const QString& text) {
  const auto name = text.simplified().left(TemplateStore::kLongestName);
  auto& store = workspace_.templates();
  if (name.isEmpty()) return false;
  if (store.has(name) && !ask(window_, "templateQuestion", tr("There is a template %1 already.").arg(name),
                              tr("What it holds is lost when it is replaced."), tr("Replace")))
    return false;
  if (const auto status = store.save(name, workspace_.document().machine()); !status) {
    workspace_.report(status.error(), Severity::kError, tr("Template"));
    showError(&window_, tr("The template could not be saved."), status.error());
    return false;
  }
  workspace_.inform(tr("Template"), tr("Saved the template %1").arg(name));
  return true;
}

bool TemplateCommands::begin(const TemplateStore::Entry& entry) {
  auto machine = ProjectDocument::read(entry.path);
  if (!machine) {
    workspace_.report(machine.error(), Severity::kError, tr("Template"));
    showError(&window_, tr("The template %1 cannot be read.").arg(entry.name), machine.error());
    return false;
  }
  return files_.takeNew(std::move(*machine));
}

void TemplateCommands::remove(const TemplateStore::Entry& entry) {
  removeTemplate(window_, workspace_.templates(), entry);
}

void removeTemplate(QWidget& window, TemplateStore& store, const TemplateStore::Entry& entry) {
  if (!ask(window, "templateRemoveQuestion", TemplateCommands::tr("Remove the template %1?").arg(entry.name),
           TemplateCommands::tr("Projects that were begun with it stay as they are."), TemplateCommands::tr("Remove")))
    return;
  if (const auto status = store.remove(entry); !status)
    showError(&window, TemplateCommands::tr("The template %1 could not be removed.").arg(entry.name), status.error());
}

}  // namespace syncline::ui
