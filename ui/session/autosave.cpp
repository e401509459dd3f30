// SPDX-License-Identifier: Apache-2.0
#include "ui/session/autosave.h"

#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QUuid>
#include <algorithm>
#include <chrono>

#include "reasons/because.h"
#include "ui/session/post.h"
#include "ui/session/project_document.h"
#include "ui/session/recovery_file.h"

namespace syncline::ui {
namespace {

constexpr std::chrono::milliseconds kDelay{1000};

/// Stale when its process is gone, however young, and never by age.
std::unique_ptr<QLockFile> recoveryLock(const QString& file) {
  auto lock = std::make_unique<QLockFile>(file + QStringLiteral(".lock"));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

Autosave::Autosave(ProjectDocument& document, QString folder, QObject* parent)
    : QObject(parent), document_(document), folder_(std::move(folder)) {
  timer_.setSingleShot(true);
  timer_.setInterval(kDelay);
  writer_.setMaxThreadCount(1);
  if (folder_.isEmpty()) return;
  file_ =
      QDir(folder_).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + QLatin1String(kRecoveryExtension));
  connect(&timer_, &QTimer::timeout, this, &Autosave::keep);
  connect(&document_, &ProjectDocument::projectChanged, this, &Autosave::onEdit);
  connect(&document_, &ProjectDocument::viewsChanged, this, &Autosave::onEdit);
  connect(&document_, &ProjectDocument::modifiedChanged, this, &Autosave::onEdit);
}

Autosave::~Autosave() {
  if (!folder_.isEmpty() && document_.isModified() && !forgotten_) flush();
  writer_.waitForDone();
}

void Autosave::onEdit() {
  if (!document_.isModified()) return forget();
  forgotten_ = false;
  if (!timer_.isActive()) timer_.start();  // not put off by the next edit
}

void Autosave::forget() {
  timer_.stop();
  forgotten_ = true;
  writer_.waitForDone();
  if (std::exchange(kept_, false)) QFile::remove(file_);
}

/// The lock stands before the file: nobody takes it for one that was left.
bool Autosave::lockOwn() {
  if (own_) return true;
  if (!QDir().mkpath(folder_)) return false;
  auto lock = recoveryLock(file_);
  if (!lock->tryLock(0)) return false;
  own_ = std::move(lock);
  return true;
}

void Autosave::keep() {
  timer_.stop();
  if (!lockOwn())
    return done(fail(ErrorCode::kFileNotWritable, folder_.toStdString(), because("no file can be made there")));
  kept_ = true;
  const KeptWork work{document_.path(), QDateTime::currentDateTimeUtc(), document_.undoStack().undoText(),
                      static_cast<int>(document_.project().slaves.size())};
  writer_.start([this, file = file_, work, machine = document_.machine()] {
    const auto status = keepWork(file, work, machine);
    post(*this, [this, status] { done(status); });
  });
}

void Autosave::done(const Status& status) {
  if (!status && !std::exchange(told_, true)) Q_EMIT failed(status.error());
  if (status) told_ = false;
}

void Autosave::flush() {
  if (folder_.isEmpty() || !document_.isModified()) return;
  if (timer_.isActive() || !kept_) keep();
  writer_.waitForDone();
}

std::vector<LostWork> Autosave::lost() {
  std::vector<LostWork> all;
  if (folder_.isEmpty()) return all;
  const auto files = QDir(folder_).entryInfoList({QLatin1Char('*') + QLatin1String(kRecoveryExtension)}, QDir::Files);
  for (const auto& entry : files) {
    const auto file = entry.absoluteFilePath();
    if (entry.fileName() == QFileInfo(file_).fileName()) continue;
    auto lock = recoveryLock(file);
    if (!found_.contains(file)) {
      if (!lock->tryLock(0)) continue;  // its window is open, or another one offers it
      found_[file] = std::move(lock);
    }
    if (auto work = readWork(file)) {
      all.push_back({file, std::move(*work)});
    } else {
      found_.erase(file);
    }
  }
  std::ranges::sort(all, std::ranges::greater{}, [](const LostWork& one) { return one.work.saved; });
  return all;
}

Status Autosave::recover(const LostWork& lost) {
  auto machine = readMachine(lost.file);
  if (!machine) return tl::unexpected(machine.error());
  document_.take(std::move(*machine), lost.work.path, false);
  flush();  // it is this window's from now on
  discard(lost);
  return {};
}

void Autosave::leaveAll() { found_.clear(); }

void Autosave::discard(const LostWork& lost) {
  QFile::remove(lost.file);
  found_.erase(lost.file);
}

}  // namespace syncline::ui
