// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "ui/session/opened_recording.h"

namespace syncline {
struct Trigger;
}  // namespace syncline

namespace syncline::ui {

/// A second recording, laid over the one that is shown: read in a thread of its own, and where it lies. It goes with
/// the one below it.
class RecordingOverlay final : public QObject {
  Q_OBJECT

 public:
  /// Where it lies; by hand: where the user put it.
  enum class Place { kBegin, kArmed, kTrigger, kByHand };

  /// `shown`: the recording below, which must outlive it.
  explicit RecordingOverlay(OpenedRecording& shown, QObject* parent = nullptr);

  /// No-op while one is being read, or none is shown to lay it over. finished() or failed() follows.
  void read(const QString& path);
  void cancel() { other_.cancel(); }
  [[nodiscard]] bool isReading() const { return other_.isReading(); }
  void close();
  [[nodiscard]] bool isOpen() const { return other_.isOpen(); }
  /// While one is open.
  [[nodiscard]] const ReplayedRun& run() const { return other_.run(); }
  [[nodiscard]] const QString& path() const { return other_.path(); }
  /// What tells the two apart: their files' names, short where that is enough.
  [[nodiscard]] QString name() const;
  [[nodiscard]] QString ownName() const;

  /// Lays it so; false, and nothing is changed, where one of the two has no such moment. `trigger`: whose first episode
  /// counts.
  bool align(Place place, const Trigger& trigger);
  [[nodiscard]] Place place() const { return place_; }
  /// By hand. ns: how much later than with both beginnings together.
  void setOffset(Nanoseconds offset);
  [[nodiscard]] Nanoseconds offset() const { return offset_; }
  /// Host clock of the recording below less that of the other: what its times are drawn later by.
  [[nodiscard]] Nanoseconds shift() const;
  /// Of one cycle, the step in which it is moved.
  [[nodiscard]] Nanoseconds step() const;

 Q_SIGNALS:
  void progress(int permille);
  void failed(const QString& path, const syncline::Error& error);
  /// Another one lies over it, or none: the one before is gone when this returns.
  void changed();
  /// It lies elsewhere.
  void moved();

 private:
  OpenedRecording& shown_;
  OpenedRecording other_;
  Place place_ = Place::kBegin;
  Nanoseconds offset_ = 0;
};

}  // namespace syncline::ui
