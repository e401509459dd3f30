// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "support/result.h"
#include "support/types.h"

namespace syncline::ui {

class OpenedRecording;

/// Plays the recording that is shown: a moment of it is now, and moves on with a clock. While it is active, the
/// recording's record is that of the moment (RunRecord::shown_at()); else it is whole.
class RecordingReplay final : public QObject {
  Q_OBJECT

 public:
  /// Monotonic, ns.
  using Clock = std::function<Nanoseconds()>;
  /// Time of the run in time of the clock.
  struct Speed {
    std::int64_t run, clock;
  };
  static constexpr std::array<Speed, 7> kSpeeds{{{1, 100}, {1, 10}, {1, 2}, {1, 1}, {2, 1}, {10, 1}, {100, 1}}};
  static constexpr int kRealTime = 3;
  /// Where the transport stops: an event that says something of the machine's order, or a note.
  struct Mark {
    Nanoseconds time = 0;  // host clock
    bool fault = false, note = false;
  };

  /// The recording must outlive it. No clock: that of the host.
  explicit RecordingReplay(OpenedRecording& recording, Clock clock = {}, QObject* parent = nullptr);
  void setClock(Clock clock);

  /// A recording is open whose moments can be shown.
  [[nodiscard]] bool isPossible() const;
  /// A moment is shown.
  [[nodiscard]] bool isActive() const { return active_; }
  [[nodiscard]] bool isPlaying() const { return tick_.isActive(); }
  /// Host clock; of the whole recording its end.
  [[nodiscard]] Nanoseconds moment() const;
  [[nodiscard]] Nanoseconds begin() const;
  [[nodiscard]] Nanoseconds end() const;
  [[nodiscard]] bool isAtEnd() const { return moment() >= end(); }
  [[nodiscard]] int speed() const { return speed_; }
  /// By time.
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }

  /// From the moment on; from the beginning where it is at the end, or all is shown. It pauses at the end.
  void play();
  void pause();
  /// Shows this moment, or the nearest that the recording has. Whoever plays goes on from there.
  void seek(Nanoseconds moment);
  /// A cycle further, or back (-1); pauses.
  void stepCycle(int direction);
  /// To the next mark, or the one before (-1), or to the end or the beginning where there is none; pauses.
  void stepMark(int direction);
  /// A place in kSpeeds; what lies outside means the nearest.
  void setSpeed(int speed);
  /// All of the recording is shown again.
  void leave();
  /// As far as the clock has come; its timer calls it.
  void tick();

 Q_SIGNALS:
  /// What the transport shows beside the moment: possible, active, playing, speed, marks.
  void changed();
  /// Another moment is shown, or all; `back`: what was there before may be there no more.
  void moved(bool back);
  /// The recording cannot be read any more; all of it is shown.
  void failed(const syncline::Error& error);

 private:
  void onRecording();
  void collectMarks();
  void setAnchor();
  void show(Nanoseconds moment);

  OpenedRecording& recording_;
  Clock clock_;
  QTimer tick_;
  bool active_ = false;
  Nanoseconds moment_ = 0;
  Nanoseconds anchor_moment_ = 0, anchor_clock_ = 0;  // where it began to play, so that no rounding adds up
  int speed_ = kRealTime;
  std::vector<Mark> marks_;
};

}  // namespace syncline::ui
