// SPDX-License-Identifier: Apache-2.0
#include "ui/session/watch_list.h"

#include <QCryptographicHash>
#include <QStringList>

#include "protocol/object_value.h"
#include "ui/models/dictionary.h"
#include "ui/session/project_document.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {

WatchList::WatchList(ProjectDocument& document, WindowMemory& memory, QObject* parent)
    : QObject(parent), document_(document), memory_(memory), path_(document.path()) {
  load();
  connect(&document_, &ProjectDocument::taken, this, [this] {
    path_ = document_.path();
    load();
  });
  // Saved under another name it is the same machine, whatever that file held before.
  connect(&document_, &ProjectDocument::pathChanged, this, [this] {
    if (path_ == document_.path()) return;
    path_ = document_.path();
    store();
  });
}

/// A path is no name of a setting.
QString WatchList::place() const {
  const auto hash = QCryptographicHash::hash(path_.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
  return QStringLiteral("watched/") + QString::fromLatin1(hash);
}

/// "1002 6041:00 6064:00"
void WatchList::load() {
  watched_.clear();
  if (path_.isEmpty()) return;
  for (const auto& line : memory_.value(place()).toStringList()) {
    const auto words = line.split(u' ', Qt::SkipEmptyParts);
    if (words.isEmpty()) continue;
    auto& objects = watched_[words.front().toUShort()];
    for (const auto& word : words.sliced(1)) {
      if (const auto object = object_name(word.toStdString())) objects.push_back({object->index, object->sub_index});
    }
  }
}

void WatchList::store() {
  if (path_.isEmpty()) return;
  QStringList lines;
  for (const auto& [station, objects] : watched_) {
    QStringList words{QString::number(station)};
    for (const auto object : objects) words << objectText(object);
    if (!objects.empty()) lines << words.join(u' ');
  }
  memory_.setValue(place(), lines);
}

std::vector<coe::ObjectAddress> WatchList::of(std::uint16_t station) const {
  const auto found = watched_.find(station);
  return found == watched_.end() ? std::vector<coe::ObjectAddress>{} : found->second;
}

void WatchList::set(std::uint16_t station, std::vector<coe::ObjectAddress> objects) {
  watched_[station] = std::move(objects);
  store();
}

}  // namespace syncline::ui
