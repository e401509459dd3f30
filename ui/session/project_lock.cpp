// SPDX-License-Identifier: Apache-2.0
#include "ui/session/project_lock.h"

#include <QFileInfo>
#include <QLockFile>

namespace syncline::ui {
namespace {

/// The one file that several ways and links lead to.
QString sameFile(const QString& path) {
  const QFileInfo file(path);
  const auto canonical = file.canonicalFilePath();
  return canonical.isEmpty() ? file.absoluteFilePath() : canonical;
}

/// Never too old: a window may be open for weeks. One whose process is gone counts as none.
std::unique_ptr<QLockFile> lockOf(const QString& path) {
  auto lock = std::make_unique<QLockFile>(ProjectLock::fileOf(path));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

ProjectLock::ProjectLock() = default;
ProjectLock::~ProjectLock() = default;

QString ProjectLock::fileOf(const QString& path) {
  const QFileInfo file(sameFile(path));
  return QStringLiteral("%1/.%2.lock").arg(file.path(), file.fileName());
}

bool ProjectLock::take(const QString& path) {
  const auto wanted = path.isEmpty() ? QString() : sameFile(path);
  if (wanted == path_ && held_) return true;
  lock_.reset();
  path_ = wanted;
  held_ = true;
  if (wanted.isEmpty()) return true;
  auto lock = lockOf(wanted);
  if (lock->tryLock(0)) {
    lock_ = std::move(lock);
  } else {
    held_ = lock->error() != QLockFile::LockFailedError;
  }
  return held_;
}

QString ProjectLock::holder(const QString& path) const {
  if (held_ && sameFile(path) == path_) return {};
  const auto lock = lockOf(path);
  if (lock->tryLock(0) || lock->error() != QLockFile::LockFailedError) return {};
  qint64 process = 0;
  QString host, program;
  if (!lock->getLockInfo(&process, &host, &program)) return QStringLiteral("?");
  return QStringLiteral("%1, process %2 on %3").arg(program).arg(process).arg(host);
}

}  // namespace syncline::ui
