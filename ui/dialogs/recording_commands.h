// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "record/black_box.h"
#include "record/import_run.h"
#include "support/types.h"
#include "ui/dialogs/reading_progress.h"
#include "ui/session/opened_recording.h"

class QWidget;

namespace syncline::ui {

class Workspace;

/// Opening, making and saving recordings, with their dialogs.
class RecordingCommands final : public QObject {
  Q_OBJECT

 public:
  RecordingCommands(Workspace& workspace, QWidget& window);

  /// Reads it with progress and Cancel; then asks about a machine that runs. Errors are shown; then all is as it was.
  void open(const QString& path);
  /// Asks for a capture, how much of it is taken and for the file of its recording; then as open().
  void importCapture();
  void importCapture(const QString& capture, const QString& path, const ImportLimits& limits = {});
  /// Begins to record to a file that the user names, or ends it.
  void toggle();
  /// Asks how much, and where to.
  void saveLast();
  /// A stretch of the run (host clock) to a file that the user names.
  void saveRange(Nanoseconds from, Nanoseconds to);
  /// Asks what to write at a moment of what is shown (host clock).
  void writeNote(Nanoseconds time);
  /// How much of every run stays in memory.
  void askMemory();
  /// Whether and where the last frames of every run are kept.
  void askBlackBox();
  /// Whether the run that is shown is accepted, and the page that says so.
  void askCommissioning();
  /// "Save the last 4 min 10 s…"
  [[nodiscard]] QString saveLastText() const;

 private:
  void onOutlined(const OpenedRecording::Outline& outline);
  void onRead(const QString& path);
  void onFailed(const QString& path, const Error& error);
  void onEnded(const QString& path, const QString& why, const std::optional<Error>& error);
  void onFramesKept(const BlackBox::Report& report);
  void onSaved(const QString& path, const std::optional<Error>& error);
  [[nodiscard]] QString askFile(const QString& title) const;
  void tell(const QString& title, const Error& error);

  Workspace& workspace_;
  QWidget& window_;
  ReadingProgress progress_;
};

}  // namespace syncline::ui
