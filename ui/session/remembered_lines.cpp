// SPDX-License-Identifier: Apache-2.0
#include "ui/session/remembered_lines.h"

#include <QCryptographicHash>
#include <utility>

#include "ui/session/window_memory.h"

namespace syncline::ui {

RememberedLines::RememberedLines(WindowMemory& memory, QString group, QString path)
    : memory_(memory), group_(std::move(group)), path_(std::move(path)) {}

bool RememberedLines::setPath(const QString& path) { return std::exchange(path_, path) != path; }

QStringList RememberedLines::read() const {
  return path_.isEmpty() ? QStringList() : memory_.value(place()).toStringList();
}

void RememberedLines::write(const QStringList& lines) {
  if (!path_.isEmpty()) memory_.setValue(place(), lines);
}

/// A path is no name of a setting.
QString RememberedLines::place() const {
  const auto hash = QCryptographicHash::hash(path_.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
  return group_ + u'/' + QString::fromLatin1(hash);
}

}  // namespace syncline::ui
