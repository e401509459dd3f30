// SPDX-License-Identifier: Apache-2.0
#include "ui/session/watch_list.h"

#include <QStringList>

#include "protocol/object_value.h"
#include "ui/models/dictionary.h"
#include "ui/session/project_document.h"

namespace syncline::ui {

WatchList::WatchList(ProjectDocument& document, WindowMemory& memory, QObject* parent)
    : QObject(parent), document_(document), kept_(memory, QStringLiteral("watched"), document.path()) {
  load();
  connect(&document_, &ProjectDocument::taken, this, [this] {
    kept_.setPath(document_.path());
    load();
  });
  // Saved under another name it is the same machine, whatever that file held before.
  connect(&document_, &ProjectDocument::pathChanged, this, [this] {
    if (kept_.setPath(document_.path())) store();
  });
}

/// "1002 6041:00 6064:00"
void WatchList::load() {
  watched_.clear();
  for (const auto& line : kept_.read()) {
    const auto words = line.split(u' ', Qt::SkipEmptyParts);
    if (words.isEmpty()) continue;
    auto& objects = watched_[words.front().toUShort()];
    for (const auto& word : words.sliced(1)) {
      if (const auto object = object_name(word.toStdString())) objects.push_back({object->index, object->sub_index});
    }
  }
}

void WatchList::store() {
  QStringList lines;
  for (const auto& [station, objects] : watched_) {
    QStringList words{QString::number(station)};
    for (const auto object : objects) words << objectText(object);
    if (!objects.empty()) lines << words.join(u' ');
  }
  kept_.write(lines);
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
