// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/file_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <utility>

#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/import_commands.h"
#include "ui/dialogs/questions.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/files/save_name.h"
#include "ui/session/exporter.h"
#include "ui/session/file_kind.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

FileCommands::FileCommands(Workspace& workspace, QWidget& window)
    : QObject(&window), workspace_(workspace), window_(window), imports_(new ImportCommands(workspace, window)) {}

void FileCommands::create() {
  if (!mayDiscard() || !mayEndAll(window_, workspace_, tr("A new project begins without a machine."))) return;
  workspace_.runs().shutDown();
  workspace_.document().reset();
}

bool FileCommands::takeNew(Machine machine) {
  if (!mayDiscard() || !mayEndAll(window_, workspace_, tr("A new machine takes the place of the present one.")))
    return false;
  workspace_.runs().shutDown();
  workspace_.recording().close();
  workspace_.document().take(std::move(machine), {}, false);
  return true;
}

/// Where the project lies, or what was opened or saved last.
QString FileCommands::usualFolder() const {
  const auto& path = workspace_.document().path();
  if (!path.isEmpty()) return QFileInfo(path).absolutePath();
  const auto& recent = workspace_.memory().recent();
  return recent.isEmpty() ? QString() : QFileInfo(recent.front().path).absolutePath();
}

void FileCommands::open() {
  const auto path = QFileDialog::getOpenFileName(
      &window_, tr("Open"), usualFolder(),
      tr("All that can be opened (*.syncline *.xml *.esi *.eni *.slrec *.csv *.pcap *.pcapng *.toml);;Syncline "
         "projects (*.syncline);;Recordings (*.slrec);;All files (*)"));
  if (!path.isEmpty()) openAny(path);
}

void FileCommands::openAny(const QString& path) {
  const auto refuse = [&](const QString& expected) {
    showError(&window_, tr("%1 cannot be opened here.").arg(QFileInfo(path).fileName()),
              Error{.code = ErrorCode::kNotThatKindOfFile,
                    .detail = Reason::verbatim(expected.toStdString()),
                    .file = path.toStdString()});
  };
  switch (fileKind(path)) {
    case FileKind::kProject:
    case FileKind::kUnreadable:  // says why
      openFile(path);
      return;
    case FileKind::kEni:
      return imports_->importEni(
          path, [this] { return mayDiscard() && mayEndAll(window_, workspace_, tr("Another project is opened.")); });
    case FileKind::kEsi:
      return imports_->addEsiFolder(path);
    case FileKind::kRecording:
    case FileKind::kRunTable:
      return Q_EMIT recordingWanted(path);
    case FileKind::kCapture:
      return Q_EMIT linkWanted(QStringLiteral("replay:") + path);
    case FileKind::kScenario:
      return Q_EMIT linkWanted(QStringLiteral("sim:") + path);
    case FileKind::kOther:
      return refuse(tr("a project, an ENI, an ESI, a recording, a capture or a scenario"));
  }
}

void FileCommands::openDropped(const QString& path) {
  const auto kind = fileKind(path);
  const bool machine = kind == FileKind::kProject || kind == FileKind::kEni;
  if (!machine || workspace_.document().project().slaves.empty() || workspace_.recording().isOpen())
    return openAny(path);
  QMessageBox box(QMessageBox::Question, tr("Syncline"),
                  tr("Open %1, or compare the project with it?").arg(QFileInfo(path).fileName()), QMessageBox::Cancel,
                  &window_);
  box.setObjectName(QStringLiteral("dropQuestion"));
  auto* compare = box.addButton(tr("&Compare"), QMessageBox::AcceptRole);
  compare->setObjectName(QStringLiteral("dropCompare"));
  auto* open = box.addButton(tr("&Open"), QMessageBox::AcceptRole);
  open->setObjectName(QStringLiteral("dropOpen"));
  box.setDefaultButton(compare);
  box.exec();
  if (box.clickedButton() == compare) return Q_EMIT comparisonWanted(path);
  if (box.clickedButton() == open) openAny(path);
}

bool FileCommands::openFile(const QString& path) {
  auto machine = ProjectDocument::read(path);
  if (!machine) {
    workspace_.report(machine.error(), Severity::kError, tr("Open"));
    showError(&window_, tr("The project could not be opened."), machine.error());
    return false;
  }
  if (!mayDiscard() || !mayOpenBeside(path)) return false;
  if (!mayEndAll(window_, workspace_, tr("Another project is opened."))) return false;
  workspace_.runs().shutDown();
  workspace_.recording().close();
  workspace_.document().take(std::move(*machine), path);
  workspace_.inform(tr("Project"), tr("Opened %1").arg(path));
  return true;
}

/// Two windows do not write one file.
bool FileCommands::mayOpenBeside(const QString& path) {
  const auto holder = workspace_.document().holder(path);
  if (holder.isEmpty()) return true;
  return ask(window_, "lockQuestion", tr("Another window has %1 open.").arg(QFileInfo(path).fileName()),
             tr("It is %1. Here it can be looked at and changed, and be saved under another name. If that window is "
                "gone, delete %2.")
                 .arg(holder, ProjectLock::fileOf(path)),
             tr("Open Read-only"));
}

void FileCommands::offerRecovery(const std::function<void()>& then, const QString& asked) {
  auto lost = workspace_.autosave().lost();
  if (lost.empty()) return then();
  auto* dialog = new RecoveryDialog(workspace_.autosave(), std::move(lost), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RecoveryDialog::wanted, this, [this, asked](const LostWork& work) {
    recover(work);
    offerAsked(asked);
  });
  connect(dialog, &QDialog::finished, this, [this, then](int result) {
    if (result == QDialog::Accepted) return;  // recover() follows
    workspace_.autosave().leaveAll();
    then();
  });
  dialog->open();
}

void FileCommands::recover(const LostWork& work) {
  if (auto status = workspace_.autosave().recover(work); !status) {
    workspace_.report(status.error(), Severity::kError, tr("Recover"));
    return showError(&window_, tr("The unsaved work could not be read."), status.error());
  }
  workspace_.autosave().leaveAll();
  workspace_.inform(tr("Project"), tr("Recovered %1; it is not saved yet").arg(workspace_.document().displayName()));
}

/// What the program was started with waits behind the recovered work, which is not saved yet.
void FileCommands::offerAsked(const QString& asked) {
  if (asked.isEmpty() || QFileInfo(asked) == QFileInfo(workspace_.document().path())) return;
  const auto name = QFileInfo(asked).fileName();
  if (ask(window_, "askedFileQuestion", tr("Open %1 now?").arg(name),
          tr("Syncline was started with it. The recovered work is not saved yet; what would take its place asks "
             "first."),
          tr("Open")))
    return openAny(asked);
  workspace_.inform(tr("Open"), tr("%1 was not opened: the recovered work is shown").arg(name));
}

bool FileCommands::save() {
  const auto& path = workspace_.document().path();
  return path.isEmpty() || workspace_.document().readOnly() ? saveAs() : saveTo(path);
}

bool FileCommands::saveAs() {
  const auto title = tr("Save Project"), suffix = QStringLiteral(".syncline");
  const auto path =
      QFileDialog::getSaveFileName(&window_, title, proposedName(suffix), tr("Syncline projects (*.syncline)"));
  const auto complete = withSuffix(&window_, title, path, suffix);
  return !complete.isEmpty() && saveTo(complete);
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
  const auto title = tr("Export ENI");
  const auto path = withSuffix(&window_, title,
                               QFileDialog::getSaveFileName(&window_, title, proposedExport(QStringLiteral(".eni.xml")),
                                                            tr("EtherCAT network information (*.xml)")),
                               QStringLiteral(".xml"));
  if (path.isEmpty()) return;
  // Of the ENI the dialog has asked, of what stands beside it nobody.
  const auto report = reportFile(path);
  if (workspace_.eni().reported() && QFileInfo::exists(report) && !QFileInfo::exists(path) &&
      !ask(window_, "reportQuestion", tr("There is a report %1 already.").arg(QFileInfo(report).fileName()),
           tr("It is replaced by the one of this export."), tr("Replace"))) {
    return;
  }
  exportTo(path);
}

bool FileCommands::exportTo(const QString& path) {
  const auto wrong = ui::exportEni(workspace_, path);
  if (!wrong) {
    workspace_.report(wrong.error(), Severity::kError, tr("Export"));
    showError(&window_, tr("The ENI could not be written."), wrong.error());
    return false;
  }
  workspace_.inform(tr("Export"), workspace_.eni().reported()
                                      ? tr("ENI written to %1, report to %2").arg(path, reportFile(path))
                                      : tr("ENI written to %1").arg(path));
  workspace_.tellOfExport(*wrong);
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

/// It is of one network: those of the others are not to be proposed for replacing.
QString FileCommands::proposedExport(const QString& suffix) const {
  const auto networks = workspace_.document().networks();
  if (networks.size() < 2) return proposedName(suffix);
  static const QRegularExpression kOdd(QStringLiteral("[^\\w-]+"), QRegularExpression::UseUnicodePropertiesOption);
  const auto name = QString(networks[workspace_.document().network()]).replace(kOdd, QStringLiteral("_"));
  return proposedName(u'.' + name + suffix);
}

QString FileCommands::proposedName(const QString& suffix) const {
  const auto& path = workspace_.document().path();
  if (path.isEmpty()) return QStringLiteral("machine") + suffix;
  const QFileInfo file(path);
  return file.path() + u'/' + file.completeBaseName() + suffix;
}

}  // namespace syncline::ui
