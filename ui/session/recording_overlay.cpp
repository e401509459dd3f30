// SPDX-License-Identifier: Apache-2.0
#include "ui/session/recording_overlay.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "record/overlay_anchor.h"
#include "trace/trigger.h"

namespace syncline::ui {

RecordingOverlay::RecordingOverlay(OpenedRecording& shown, QObject* parent) : QObject(parent), shown_(shown) {
  connect(&shown_, &OpenedRecording::changed, this, &RecordingOverlay::close);
  connect(&other_, &OpenedRecording::progress, this, &RecordingOverlay::progress);
  connect(&other_, &OpenedRecording::failed, this, &RecordingOverlay::failed);
  connect(&other_, &OpenedRecording::finished, this, [this] {
    // The one below may be gone by now.
    shown_.isOpen() ? other_.show() : other_.drop();
  });
  connect(&other_, &OpenedRecording::changed, this, [this] {
    place_ = Place::kBegin;
    offset_ = 0;
    Q_EMIT changed();
  });
}

void RecordingOverlay::read(const QString& path) {
  if (shown_.isOpen()) other_.read(path);
}

void RecordingOverlay::close() {
  other_.cancel();
  other_.close();
}

QString RecordingOverlay::name() const {
  const QFileInfo own(shown_.path()), other(path());
  return own.completeBaseName() == other.completeBaseName() ? QDir(other.path()).dirName() + u'/' + other.fileName()
                                                            : other.completeBaseName();
}

QString RecordingOverlay::ownName() const {
  const QFileInfo own(shown_.path()), other(path());
  return own.completeBaseName() == other.completeBaseName() ? QDir(own.path()).dirName() + u'/' + own.fileName()
                                                            : own.completeBaseName();
}

bool RecordingOverlay::align(Place place, const Trigger& trigger) {
  if (!isOpen() || !shown_.isOpen()) return false;
  if (place == Place::kByHand) return true;
  const auto alignment = place == Place::kBegin   ? OverlayAlignment::kBegin
                         : place == Place::kArmed ? OverlayAlignment::kArmed
                                                  : OverlayAlignment::kTrigger;
  const auto offset = overlay_offset(*shown_.run().record, *run().record, alignment, trigger);
  if (!offset) return false;
  place_ = place;
  offset_ = *offset;
  Q_EMIT moved();
  return true;
}

void RecordingOverlay::setOffset(Nanoseconds offset) {
  if (!isOpen() || offset == offset_) return;
  place_ = Place::kByHand;
  offset_ = offset;
  Q_EMIT moved();
}

Nanoseconds RecordingOverlay::shift() const {
  if (!isOpen() || !shown_.isOpen()) return 0;
  return offset_ + shown_.run().record->overview().begin - run().record->overview().begin;
}

Nanoseconds RecordingOverlay::step() const {
  return isOpen() ? std::max<Nanoseconds>(run().record->limits().cycle_time, 1) : kMillisecond;
}

}  // namespace syncline::ui
