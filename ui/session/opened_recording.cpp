// SPDX-License-Identifier: Apache-2.0
#include "ui/session/opened_recording.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "eni/format/eni_file.h"
#include "record/import_run.h"
#include "record/recorded_configuration.h"
#include "record/recording_notes.h"
#include "sqlite/database_files.h"
#include "support/whole_file.h"
#include "ui/models/message_model.h"
#include "ui/session/file_kind.h"
#include "ui/session/post.h"
#include "ui/text/recorded_text.h"

namespace syncline::ui {
namespace {

constexpr int kRenewal = 20;                     // per mille of the cycles
constexpr std::size_t kLargestTable = 1U << 30;  // bytes: two hours at 1 kHz

/// A table or log that is shown like a recording.
Result<ImportedRun> imported(const QString& path) {
  const auto text = read_whole_file(path.toStdString(), kLargestTable);
  if (!text) return tl::unexpected(text.error());
  return import_table(*text, QFileInfo(path).fileName().toStdString());
}

}  // namespace

OpenedRecording::OpenedRecording(QObject* parent) : QObject(parent) {}

OpenedRecording::~OpenedRecording() {
  cancel();
  if (worker_.joinable()) worker_.join();
}

void OpenedRecording::read(const QString& path) {
  begin(path, [this, path] { return load(path); });
}

void OpenedRecording::importCapture(const QString& capture, const QString& path, const ImportLimits& limits,
                                    const CaptureImporter& importer) {
  begin(path, [this, capture, path, limits, importer]() -> Outcome {
    if (auto made = makeRecording(capture, path, limits, importer); !made) return tl::unexpected(made.error());
    made_ = true;
    return load(path);
  });
}

Status OpenedRecording::makeRecording(const QString& capture, const QString& path, const ImportLimits& limits,
                                      const CaptureImporter& importer) {
  if (auto status = may_write_recording(path.toStdString()); !status) return status;
  int told = -1;
  const auto run = importer(capture, limits, [this, &told](std::uint64_t done, std::uint64_t all) {
    const int now = all == 0 ? 0 : static_cast<int>(std::min<std::uint64_t>(done * 1000 / all, 1000));
    if (now != std::exchange(told, now)) {
      post(*this, [this, now] { Q_EMIT progress(now); });
    }
    return !cancelled_;
  });
  if (!run) return tl::unexpected(run.error());
  return write_recording(*run, path.toStdString());
}

void OpenedRecording::begin(const QString& path, std::function<Outcome()> work) {
  if (reading_) return;
  if (worker_.joinable()) worker_.join();
  reading_ = true;
  cancelled_ = false;
  made_ = false;
  read_file_.hold(path);
  Q_EMIT started(path);
  worker_ = std::thread([this, path, work = std::move(work)] {
    auto outcome = std::make_shared<Outcome>(work());
    post(*this, [this, path, outcome] { deliver(path, std::move(*outcome)); });
  });
}

void OpenedRecording::cancel() { cancelled_ = true; }

/// A table has to be read whole, so that no moment could be made of it in time: a recording of it is kept beside. Where
/// there is no room for one it is shown all the same.
void OpenedRecording::keepForReplay(const ImportedRun& run, Whole& whole) {
  whole.folder = std::make_unique<QTemporaryDir>();
  const auto copy = whole.folder->filePath(QStringLiteral("run.slrec")).toStdString();
  if (!whole.folder->isValid() || !write_recording(run, copy)) return;
  auto reader = RecordingReader::open(copy);
  if (!reader) return;
  if (auto replay = RunReplay::open(std::move(*reader), whole.run)) whole.replay.emplace(std::move(*replay));
}

void OpenedRecording::answer(const QString& path) {
  auto pictures = pictures_.answer(path.toStdString());
  if (!pictures) return;
  post(*this, [this, made = std::move(*pictures)] { Q_EMIT pictured(made); });
}

/// In the reader's thread.
OpenedRecording::Outcome OpenedRecording::load(const QString& path) {
  if (fileKind(path) == FileKind::kRunTable) {
    const auto run = imported(path);
    if (!run) return tl::unexpected(run.error());
    Whole whole{replayed(*run), {}};
    keepForReplay(*run, whole);
    return whole;
  }
  auto reader = RecordingReader::open(path.toStdString());
  if (!reader) return tl::unexpected(reader.error());
  auto info = reader->info();
  if (!info) return tl::unexpected(info.error());
  post(*this, [this, outline = Outline{info->begin, info->end, info->cycles, info->about.limits}] {
    Q_EMIT outlined(outline);
  });
  answer(path);
  int told = -1;
  ReplayOptions options;
  options.gap = [this](std::size_t block) { pictures_.leaveOut(block); };
  options.progress = [this, &path, &told](std::uint64_t done, std::uint64_t all) {
    const int now = static_cast<int>(done * 1000 / std::max<std::uint64_t>(all, 1));
    // However much is damaged, the picture is not made anew for each block.
    if (now / kRenewal != told / kRenewal) pictures_.renew();
    answer(path);
    if (now != std::exchange(told, now)) {
      post(*this, [this, now] { Q_EMIT progress(now); });
    }
    return !cancelled_;
  };
  auto config = recorded_configuration(info->about, eni::parse_eni);
  auto run = replay_run(*reader, std::move(*info), std::move(config), options);
  if (!run) return tl::unexpected(run.error());
  auto messages = messagesOf(*run, MessageModel::kMaximum);
  Whole whole{std::move(*run), std::move(messages)};
  // Cut short before its first second it has no moment to be shown at.
  if (whole.run.record->samples().empty()) return whole;
  auto replay = RunReplay::open(std::move(*reader), whole.run);
  if (!replay) return tl::unexpected(replay.error());
  whole.replay.emplace(std::move(*replay));
  return whole;
}

void OpenedRecording::deliver(const QString& path, Outcome outcome) {
  if (worker_.joinable()) worker_.join();
  pictures_.forget();
  reading_ = false;
  if (cancelled_ || !outcome) read_file_.hold({});
  if (cancelled_) {
    if (made_) remove_database(path.toStdString());  // it was whole already, and nobody wants it
    Q_EMIT failed(path, Error{ErrorCode::kCancelled});
  } else if (outcome) {
    next_ = std::make_unique<Whole>(std::move(*outcome));
    next_path_ = path;
    Q_EMIT finished(path);
  } else {
    Q_EMIT failed(path, outcome.error());
  }
}

void OpenedRecording::show() {
  if (next_ == nullptr) return;
  const auto before = std::exchange(shown_, std::move(next_));
  path_ = next_path_;
  shown_file_.hold(path_);
  read_file_.hold({});
  Q_EMIT changed();
}

Status OpenedRecording::setNotes(std::vector<RunNote> notes) {
  if (shown_ == nullptr) return {};
  std::ranges::stable_sort(notes, {}, &RunNote::time);
  if (shown_->replay) shown_->replay->release();
  if (auto status = write_notes(path_.toStdString(), notes); !status) return status;
  auto& run = shown_->run;
  run.info.notes = notes;
  run.record->set_notes(std::move(notes));
  shown_->messages = messagesOf(run, MessageModel::kMaximum);
  Q_EMIT notesChanged();
  return {};
}

void OpenedRecording::drop() {
  next_.reset();
  if (!reading_) read_file_.hold({});
}

void OpenedRecording::close() {
  if (shown_ == nullptr) return;
  const auto before = std::exchange(shown_, nullptr);
  path_.clear();
  shown_file_.hold({});
  Q_EMIT changed();
}

}  // namespace syncline::ui
