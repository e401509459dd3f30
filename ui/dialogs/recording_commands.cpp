// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/recording_commands.h"

#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <algorithm>

#include "record/import_run.h"
#include "record/run_record.h"
#include "ui/dialogs/black_box_dialog.h"
#include "ui/dialogs/commissioning_dialog.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/dialogs/memory_dialog.h"
#include "ui/dialogs/opening_picture.h"
#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"
#include "ui/text/black_box_text.h"
#include "ui/text/recorded_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

constexpr std::uint64_t kManyCycles = 1'000'000;

}  // namespace

RecordingCommands::RecordingCommands(Workspace& workspace, QWidget& window)
    : QObject(&window), workspace_(workspace), window_(window), progress_(window) {
  auto& recording = workspace.recording();
  connect(&recording, &OpenedRecording::progress, this, [this](int permille) { progress_.set(permille); });
  connect(&recording, &OpenedRecording::outlined, this, &RecordingCommands::onOutlined);
  connect(&recording, &OpenedRecording::finished, this, &RecordingCommands::onRead);
  connect(&recording, &OpenedRecording::failed, this, &RecordingCommands::onFailed);
  connect(&workspace.runs(), &NetworkRuns::recordingEnded, this, &RecordingCommands::onEnded);
  connect(&workspace.runs(), &NetworkRuns::framesKept, this, &RecordingCommands::onFramesKept);
  connect(&workspace.runs(), &NetworkRuns::stretchSaved, this, &RecordingCommands::onSaved);
}

void RecordingCommands::open(const QString& path) {
  if (workspace_.recording().isReading()) return;
  progress_.begin(path, "recordingProgress", tr("Open Recording"), [this] { workspace_.recording().cancel(); });
  workspace_.recording().read(path);
}

void RecordingCommands::importCapture() {
  if (workspace_.recording().isReading()) return;
  const auto capture = QFileDialog::getOpenFileName(&window_, tr("Import a Capture"), {},
                                                    tr("Captures (*.pcap *.pcapng *.cap);;All files (*)"));
  if (capture.isEmpty()) return;
  ImportDialog dialog(capture, &window_);
  if (dialog.exec() != QDialog::Accepted) return;
  const QFileInfo info(capture);
  const auto proposed = info.path() + u'/' + info.completeBaseName() + QStringLiteral(".slrec");
  auto path = QFileDialog::getSaveFileName(&window_, tr("Recording of the Capture"), proposed,
                                           tr("Recordings (*.slrec)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".slrec");
  importCapture(capture, path, dialog.limits());
}

void RecordingCommands::importCapture(const QString& capture, const QString& path, const ImportLimits& limits) {
  const auto& importer = workspace_.environment().import_capture;
  if (!importer || workspace_.recording().isReading()) return;
  progress_.begin(capture, "importProgress", tr("Import a Capture"), [this] { workspace_.recording().cancel(); });
  workspace_.recording().importCapture(capture, path, limits, importer);
}

/// What is read in an instant needs no picture before.
void RecordingCommands::onOutlined(const OpenedRecording::Outline& outline) {
  if (outline.cycles < kManyCycles) return;
  auto& recording = workspace_.recording();
  auto* picture = new OpeningPicture(outline);
  connect(picture, &OpeningPicture::wanted, &recording, &OpenedRecording::picture);
  connect(&recording, &OpenedRecording::pictured, picture, &OpeningPicture::take);
  progress_.show(picture);
}

void RecordingCommands::onRead(const QString& path) {
  progress_.end();
  if (!mayEndAll(window_, workspace_, tr("A recording is shown in its place."))) return workspace_.recording().drop();
  workspace_.runs().shutDown();
  workspace_.memory().remember(path);
  workspace_.recording().show();
}

void RecordingCommands::onFailed(const QString& path, const Error& error) {
  progress_.end();
  if (error.code == ErrorCode::kCancelled) return;
  workspace_.report(error, Severity::kError, tr("Open"));
  showError(&window_, tr("The recording %1 could not be opened.").arg(QFileInfo(path).fileName()), error);
}

QString RecordingCommands::askFile(const QString& title) const {
  const QFileInfo project(workspace_.document().path());
  const auto name = QStringLiteral("%1-%2.slrec")
                        .arg(project.fileName().isEmpty() ? QStringLiteral("machine") : project.completeBaseName(),
                             QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
  const auto folder = project.fileName().isEmpty() ? QString() : project.path() + u'/';
  auto path = QFileDialog::getSaveFileName(&window_, title, folder + name, tr("Recordings (*.slrec)"), nullptr,
                                           QFileDialog::DontConfirmOverwrite);
  if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".slrec");
  return path;
}

void RecordingCommands::tell(const QString& title, const Error& error) {
  workspace_.report(error, Severity::kError, tr("Recording"));
  showError(&window_, title, error);
}

void RecordingCommands::toggle() {
  auto& disk = workspace_.disk();
  if (disk.isRecording()) return disk.stop();
  const auto path = askFile(tr("Record"));
  if (path.isEmpty()) return;
  if (auto status = disk.start(path); !status) return tell(tr("The recording could not be started."), status.error());
  workspace_.inform(tr("Recording"), tr("Recording to %1").arg(path));
}

/// Never a box out of the running machine: a message says it, and the status bar.
void RecordingCommands::onEnded(const QString& path, const QString& why, const std::optional<Error>& error) {
  if (error) {
    workspace_.report(*error, Severity::kError, tr("Recording"));
  } else if (!why.isEmpty()) {
    workspace_.inform(tr("Recording"), tr("The recording %1 has ended: %2").arg(path, why));
  } else {
    workspace_.inform(tr("Recording"), tr("Recorded to %1").arg(path));
  }
}

QString RecordingCommands::saveLastText() const {
  const auto remembered = workspace_.disk().remembered();
  return remembered == 0 ? tr("Save the &Last…") : tr("Save the &Last %1…").arg(spanText(remembered));
}

void RecordingCommands::saveLast() {
  auto& disk = workspace_.disk();
  const auto remembered = disk.remembered();
  const auto* record = workspace_.runs().current().run.record();
  // Of the moment of the click: while somebody chooses, the run goes on.
  const auto now = record != nullptr && !record->samples().empty() ? record->samples().last_time() : 0;
  QStringList choices{tr("All that is in memory: %1").arg(spanText(remembered))};
  std::vector<Nanoseconds> spans{remembered};
  for (const auto span : {10 * kSecond, 60 * kSecond, 600 * kSecond}) {
    if (span >= remembered) continue;
    choices << tr("The last %1").arg(spanText(span));
    spans.push_back(span);
  }
  bool wanted = false;
  const auto choice = QInputDialog::getItem(
      &window_, tr("Save the Last"),
      tr("The memory holds every cycle of the last %1 at most. Save:").arg(spanText(disk.memoryReach())), choices, 0,
      false, &wanted);
  if (!wanted) return;
  const auto span = spans[static_cast<std::size_t>(std::max<qsizetype>(choices.indexOf(choice), 0))];
  const auto path = askFile(tr("Save the Last"));
  if (path.isEmpty()) return;
  const bool all = span == remembered;
  const auto status = all ? disk.saveLast(disk.remembered(), path) : disk.saveRange(now - span, now, path);
  if (!status) tell(tr("Nothing could be saved."), status.error());
}

void RecordingCommands::saveRange(Nanoseconds from, Nanoseconds to) {
  const auto path = askFile(tr("Save the Episode"));
  if (path.isEmpty()) return;
  if (auto status = workspace_.disk().saveRange(from, to, path); !status)
    tell(tr("Nothing could be saved."), status.error());
}

/// In a recording a note that is there can be changed; a run may have it on the disk by now.
void RecordingCommands::writeNote(Nanoseconds time) {
  const auto* record = workspace_.shownRecord();
  if (record == nullptr) return;
  const bool recorded = workspace_.recording().isOpen();
  const auto there = std::ranges::find(record->notes(), time, &RunNote::time);
  const bool changes = recorded && there != record->notes().end();
  bool wanted = false;
  const auto at = runTimeText(time - record->overview().begin);
  const auto text =
      QInputDialog::getText(&window_, changes ? tr("Change Note") : tr("Add Note"),
                            changes ? tr("At %1 (empty takes the note away):").arg(at) : tr("At %1:").arg(at),
                            QLineEdit::Normal, changes ? QString::fromStdString(there->text) : QString(), &wanted);
  if (!wanted || (text.trimmed().isEmpty() && !changes)) return;
  if (auto status = workspace_.putNote({time, text.trimmed().toStdString()}); !status)
    tell(tr("The note could not be written."), status.error());
}

namespace {

template <class Dialog>
void openOn(Workspace& workspace, QWidget& window) {
  auto* dialog = new Dialog(workspace, &window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

}  // namespace

void RecordingCommands::askMemory() { openOn<MemoryDialog>(workspace_, window_); }

void RecordingCommands::askBlackBox() { openOn<BlackBoxDialog>(workspace_, window_); }

void RecordingCommands::askCommissioning() {
  if (workspace_.shownRecord() == nullptr) return;
  workspace_.replay().leave();  // judged is all of a recording: what is found is known of its end alone
  openOn<CommissioningDialog>(workspace_, window_);
}

void RecordingCommands::onFramesKept(const BlackBox::Report& report) {
  if (report.error) {
    workspace_.report(*report.error, Severity::kError, tr("Black box"));
  } else if (report.frames > 0) {
    workspace_.inform(tr("Black box"), blackBoxText(report).section(u'\n', 0, 0));
  }
}

void RecordingCommands::onSaved(const QString& path, const std::optional<Error>& error) {
  if (error) return tell(tr("The last stretch could not be saved."), *error);
  workspace_.inform(tr("Recording"), tr("Saved to %1").arg(path));
}

}  // namespace syncline::ui
