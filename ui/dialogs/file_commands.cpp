// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/file_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "ui/dialogs/error_dialog.h"
#include "ui/session/exporter.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

FileCommands::FileCommands(Workspace& workspace, QWidget& window)
    : QObject(&window), workspace_(workspace), window_(window) {}

void FileCommands::create() {
  if (!mayDiscard()) return;
  workspace_.live().shutDown();
  workspace_.document().reset();
}

void FileCommands::open() {
  if (!mayDiscard()) return;
  const auto path = QFileDialog::getOpenFileName(&window_, tr("Open Project"), {},
                                                 tr("Syncline projects (*.syncline);;All files (*)"));
  if (!path.isEmpty()) openFile(path);
}

bool FileCommands::openFile(const QString& path) {
  workspace_.live().shutDown();
  if (auto status = workspace_.document().load(path); !status) {
    workspace_.report(status.error(), Severity::kError, tr("Open"));
    showError(&window_, tr("The project could not be opened."), status.error());
    return false;
  }
  workspace_.inform(tr("Project"), tr("Opened %1").arg(path));
  return true;
}

bool FileCommands::save() {
  const auto& path = workspace_.document().path();
  return path.isEmpty() ? saveAs() : saveTo(path);
}

bool FileCommands::saveAs() {
  auto path = QFileDialog::getSaveFileName(&window_, tr("Save Project"), proposedName(QStringLiteral(".syncline")),
                                           tr("Syncline projects (*.syncline)"));
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".syncline");
  return saveTo(path);
}

bool FileCommands::saveTo(const QString& path) {
  if (auto status = workspace_.document().save(path); !status) {
    workspace_.report(status.error(), Severity::kError, tr("Save"));
    showError(&window_, tr("The project could not be saved."), status.error());
    return false;
  }
  workspace_.inform(tr("Project"), tr("Saved %1").arg(path));
  return true;
}

void FileCommands::exportEni() {
  auto path = QFileDialog::getSaveFileName(&window_, tr("Export ENI"), proposedName(QStringLiteral(".eni.xml")),
                                           tr("EtherCAT network information (*.xml)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".xml");
  exportTo(path);
}

bool FileCommands::exportTo(const QString& path) {
  if (auto status = ui::exportEni(workspace_.configuration(), path); !status) {
    workspace_.report(status.error(), Severity::kError, tr("Export"));
    showError(&window_, tr("The ENI could not be written."), status.error());
    return false;
  }
  workspace_.inform(tr("Export"), tr("ENI written to %1").arg(path));
  return true;
}

bool FileCommands::mayDiscard() {
  if (!workspace_.document().isModified()) return true;
  const auto answer = QMessageBox::question(
      &window_, tr("Syncline"), tr("Save the changes to %1?").arg(workspace_.document().displayName()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

QString FileCommands::proposedName(const QString& suffix) const {
  const auto& path = workspace_.document().path();
  if (path.isEmpty()) return QStringLiteral("machine") + suffix;
  const QFileInfo file(path);
  return file.path() + u'/' + file.completeBaseName() + suffix;
}

}  // namespace syncline::ui
