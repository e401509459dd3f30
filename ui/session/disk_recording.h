// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "config/monitor_view.h"
#include "reasons/because.h"
#include "record/recent_samples.h"
#include "record/recording_bounds.h"
#include "support/result.h"
#include "ui/files/held_file.h"

namespace syncline {
class RecordingSession;
struct RecordedDocument;
struct RecordingAbout;
}  // namespace syncline

namespace syncline::ui {

struct Environment;

class NetworkRun;
class RunFindings;

/// The running machine to a file: from now on until it is stopped, or the last stretch out of memory, where every cycle
/// is kept for as long as the budget reaches. Threads of their own write.
class DiskRecording final : public QObject {
  Q_OBJECT

 public:
  static constexpr int kUsualMemoryMib = 256, kMostMemoryMib = 65'536;

  DiskRecording(NetworkRun& run, const RunFindings& findings, const Environment& environment,
                QObject* parent = nullptr);
  ~DiskRecording() override;

  /// From now on; kFileNotWritable, also when there is a file of this name or nothing runs. One that was stopped may
  /// still be written.
  Status start(const QString& path);
  /// The rest is written meanwhile; ended() follows.
  void stop();
  /// Stops and waits for the disk, also for those that were stopped before: for closing the window.
  void finish();
  [[nodiscard]] bool isRecording() const { return session_ != nullptr; }
  [[nodiscard]] const QString& path() const { return path_; }
  /// Something is on its way to the disk, also after stop().
  [[nodiscard]] bool isWriting() const { return isRecording() || saving_ || !ending_.empty(); }
  /// What a recording of the run that goes on, or was the last one, says of it as a whole; there must be one.
  [[nodiscard]] RecordingAbout about() const;
  /// Of the run, in the file.
  [[nodiscard]] Nanoseconds duration() const;
  [[nodiscard]] qint64 bytes() const;
  [[nodiscard]] std::uint64_t lostSamples() const;

  /// How far back the memory reaches, and how far the budget lets it.
  [[nodiscard]] Nanoseconds remembered() const { return recent_.span(); }
  [[nodiscard]] Nanoseconds memoryReach() const;
  /// The same of another budget, 1 to kMostMemoryMib.
  [[nodiscard]] Nanoseconds memoryReach(int mib) const;
  /// The budget; less than before forgets the oldest at once.
  void setMemoryMib(int mib);
  [[nodiscard]] int memoryMib() const { return static_cast<int>(recent_.budget() >> 20U); }
  /// Writes the last `duration` to a new file; saved() follows. kFileNotWritable where nothing is remembered, or while
  /// another stretch is being written.
  Status saveLast(Nanoseconds duration, const QString& path);
  /// The same of a stretch (host clock): what of it is remembered; kFileNotWritable where nothing is.
  Status saveRange(Nanoseconds from, Nanoseconds to, const QString& path);

  /// Views of the monitor of what runs, as the project has them now: they go into its recordings.
  void setViews(const std::vector<MonitorView>& views);

 Q_SIGNALS:
  void changed();
  /// `error`: why it ended before it was told to, or what could not be written.
  void ended(const QString& path, const QString& why, const std::optional<syncline::Error>& error);
  /// `error`: why there is no such file.
  void saved(const QString& path, const std::optional<syncline::Error>& error);

 private:
  /// One that was stopped, until the disk has it.
  struct Ending {
    QString path;
    std::optional<RecordingStop> stop;  // why it ended by itself
    std::thread thread;
  };
  [[nodiscard]] RecordedDocument project() const;
  void connectRun();
  void onStopped(int number, const RecordingStop& stop);
  void onFinished(int number, const Status& status);

  NetworkRun& run_;
  const RunFindings& findings_;
  const Environment& environment_;
  RecentSamples recent_;
  QString path_;
  HeldFile file_{because("the recording that is being written")};
  std::unique_ptr<RecordingSession> session_;
  int number_ = 0;                // of the recording that goes on, or was the last one
  std::map<int, Ending> ending_;  // by number
  std::thread saver_;
  bool saving_ = false;
  std::optional<std::vector<MonitorView>> views_;  // nothing: those with which it went online
};

}  // namespace syncline::ui
