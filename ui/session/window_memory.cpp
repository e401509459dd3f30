// SPDX-License-Identifier: Apache-2.0
#include "ui/session/window_memory.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace syncline::ui {
namespace {

constexpr int kMostUnpinned = 10;
const QString kRecent = QStringLiteral("recent"), kPath = QStringLiteral("path"), kPinned = QStringLiteral("pinned");

}  // namespace

WindowMemory::WindowMemory(const QString& file, QObject* parent) : QObject(parent) {
  if (file.isEmpty()) return;
  settings_ = std::make_unique<QSettings>(file, QSettings::IniFormat);
  const int count = settings_->beginReadArray(kRecent);
  for (int i = 0; i < count; ++i) {
    settings_->setArrayIndex(i);
    const auto path = settings_->value(kPath).toString();
    if (!path.isEmpty()) recent_.append({path, settings_->value(kPinned).toBool()});
  }
  settings_->endArray();
}

WindowMemory::~WindowMemory() = default;

void WindowMemory::remember(const QString& path) {
  const auto absolute = QFileInfo(path).absoluteFilePath();
  const auto known = std::ranges::find(recent_, absolute, &Recent::path);
  const bool pinned = known != recent_.end() && known->pinned;
  if (known != recent_.end()) recent_.erase(known);
  recent_.prepend({absolute, pinned});
  store();
}

void WindowMemory::forget(const QString& path) {
  recent_.removeIf([&](const Recent& one) { return one.path == path; });
  store();
}

void WindowMemory::pin(const QString& path, bool pinned) {
  const auto known = std::ranges::find(recent_, path, &Recent::path);
  if (known == recent_.end() || known->pinned == pinned) return;
  known->pinned = pinned;
  store();
}

void WindowMemory::clearUnpinned() {
  recent_.removeIf([](const Recent& one) { return !one.pinned; });
  store();
}

void WindowMemory::store() {
  // Not std::ranges::stable_partition: clang 14 cannot compile what libstdc++ 12 makes of it.
  std::stable_partition(recent_.begin(), recent_.end(), [](const Recent& one) { return one.pinned; });
  while (std::ranges::count(recent_, false, &Recent::pinned) > kMostUnpinned) recent_.removeLast();
  if (settings_) {
    settings_->beginWriteArray(kRecent, static_cast<int>(recent_.size()));
    for (int i = 0; i < recent_.size(); ++i) {
      settings_->setArrayIndex(i);
      settings_->setValue(kPath, recent_[i].path);
      settings_->setValue(kPinned, recent_[i].pinned);
    }
    settings_->endArray();
  }
  Q_EMIT recentChanged();
}

QVariant WindowMemory::value(const QString& name) const {
  return settings_ ? settings_->value(name) : held_.value(name);
}

void WindowMemory::setValue(const QString& name, const QVariant& value) {
  // What is the same is not written again.
  if (!settings_) {
    held_.insert(name, value);
  } else if (settings_->value(name) != value) {
    settings_->setValue(name, value);
  }
}

}  // namespace syncline::ui
