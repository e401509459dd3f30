// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTemporaryDir>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "reasons/because.h"
#include "record/replay_run.h"
#include "record/run_replay.h"
#include "support/result.h"
#include "ui/files/held_file.h"
#include "ui/session/bus_connection.h"
#include "ui/session/first_pictures.h"
#include "ui/text/message.h"

namespace syncline {
struct ImportedRun;
struct ImportLimits;
}  // namespace syncline

namespace syncline::ui {

/// A recording that the window shows in place of the live run, read in a thread of its own. Until it is read whole,
/// what was shown before stays.
class OpenedRecording final : public QObject {
  Q_OBJECT

 public:
  explicit OpenedRecording(QObject* parent = nullptr);
  ~OpenedRecording() override;

  /// No-op while one is being read.
  void read(const QString& path);
  /// Writes the recording of a capture to a new file and reads that, as read() does. No-op while one is being read.
  void importCapture(const QString& capture, const QString& path, const ImportLimits& limits,
                     const CaptureImporter& importer);
  /// Curves of the recording that is being read, or is going to be; pictured() follows unless it is whole before.
  void picture(std::vector<FirstPicture> pictures) { pictures_.ask(std::move(pictures)); }
  /// Ends the reading within a block; failed() with kCancelled follows.
  void cancel();
  /// What was read last and waits: it is shown from now on.
  void show();
  /// It is not wanted after all.
  void drop();
  void close();

  [[nodiscard]] bool isReading() const { return reading_; }
  [[nodiscard]] bool isOpen() const { return shown_ != nullptr; }
  /// Of the one that is shown.
  [[nodiscard]] const ReplayedRun& run() const { return shown_->run; }
  /// Shows it at a moment; null where none is shown, or what it would be read from could not be kept.
  [[nodiscard]] RunReplay* replay() const { return shown_ && shown_->replay ? &*shown_->replay : nullptr; }
  /// The latest ones, oldest first.
  [[nodiscard]] const std::vector<Message>& messages() const { return shown_->messages; }
  /// Notes in place of those that it has, in its file, too; kFileNotWritable, then they stay as they are.
  /// notesChanged() follows.
  Status setNotes(std::vector<RunNote> notes);
  [[nodiscard]] const QString& path() const { return path_; }

  /// What is known of a recording before its samples are read.
  struct Outline {
    Nanoseconds first = 0, last = 0;  // host clock, of its cycles
    std::uint64_t cycles = 0;
    RunLimits limits;
  };

 Q_SIGNALS:
  void started(const QString& path);
  /// While it is read: picture() may be asked for now. Not of tables.
  void outlined(const syncline::ui::OpenedRecording::Outline& outline);
  void pictured(const std::vector<syncline::ui::FirstPicture>& pictures);
  void progress(int permille);
  /// It is whole: show() or drop() it.
  void finished(const QString& path);
  void failed(const QString& path, const syncline::Error& error);
  /// Another one is shown, or none: the one before is gone when this returns.
  void changed();
  /// Another set of notes, and messages() with it.
  void notesChanged();

 private:
  struct Whole {
    ReplayedRun run;
    std::vector<Message> messages;
    std::unique_ptr<QTemporaryDir> folder{};  // of a table: a recording of it, to be read again
    std::optional<RunReplay> replay{};
  };
  using Outcome = Result<Whole>;
  void begin(const QString& path, std::function<Outcome()> work);
  Outcome load(const QString& path);
  /// In the reader's thread: the recording is at `path` when there is no error.
  Status makeRecording(const QString& capture, const QString& path, const ImportLimits& limits,
                       const CaptureImporter& importer);
  /// Between two blocks, in the reader's thread.
  void answer(const QString& path);
  static void keepForReplay(const ImportedRun& run, Whole& whole);
  void deliver(const QString& path, Outcome outcome);

  std::thread worker_;
  std::atomic<bool> cancelled_{false};
  bool made_ = false;  // the worker's, until it is over: the file that is read is one that it wrote
  FirstPictures pictures_;
  bool reading_ = false;
  QString path_, next_path_;
  HeldFile shown_file_{because("a recording that is shown here")};
  HeldFile read_file_{because("a recording that is shown here")};  // or is going to be
  std::unique_ptr<Whole> shown_, next_;
};

}  // namespace syncline::ui
