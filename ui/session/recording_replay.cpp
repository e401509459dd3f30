// SPDX-License-Identifier: Apache-2.0
#include "ui/session/recording_replay.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "ui/session/opened_recording.h"

namespace syncline::ui {
namespace {

constexpr std::chrono::milliseconds kReplayTick{33};

Nanoseconds hostClock() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

RecordingReplay::RecordingReplay(OpenedRecording& recording, Clock clock, QObject* parent)
    : QObject(parent), recording_(recording) {
  setClock(std::move(clock));
  tick_.setInterval(kReplayTick);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this, &RecordingReplay::tick);
  connect(&recording_, &OpenedRecording::changed, this, &RecordingReplay::onRecording);
  connect(&recording_, &OpenedRecording::notesChanged, this, [this] {
    collectMarks();
    Q_EMIT changed();
  });
}

void RecordingReplay::setClock(Clock clock) {
  clock_ = clock ? std::move(clock) : Clock(hostClock);
  setAnchor();
}

bool RecordingReplay::isPossible() const { return recording_.replay() != nullptr; }
Nanoseconds RecordingReplay::moment() const { return active_ ? moment_ : end(); }
Nanoseconds RecordingReplay::begin() const {
  const auto* run = recording_.replay();
  return run == nullptr ? 0 : run->begin();
}
Nanoseconds RecordingReplay::end() const {
  const auto* run = recording_.replay();
  return run == nullptr ? 0 : run->end();
}

/// The one before is gone with whatever was shown of it.
void RecordingReplay::onRecording() {
  active_ = false;
  tick_.stop();
  collectMarks();
  Q_EMIT changed();
}

void RecordingReplay::collectMarks() {
  marks_.clear();
  const auto* run = recording_.replay();
  if (run == nullptr) return;
  for (const auto& event : run->events()) {
    const auto meaning = meaning_of(event);
    if (meaning != EventMeaning::kNews) marks_.push_back({event.time, meaning == EventMeaning::kFault, false});
  }
  for (const auto& note : recording_.run().info.notes) marks_.push_back({note.time, false, true});
  std::ranges::stable_sort(marks_, {}, &Mark::time);
}

void RecordingReplay::setAnchor() {
  anchor_moment_ = moment_;
  anchor_clock_ = clock_();
}

void RecordingReplay::show(Nanoseconds moment) {
  auto* run = recording_.replay();
  if (run == nullptr) return;
  moment = std::clamp(moment, run->begin(), run->end());
  const bool back = !active_ || moment < moment_;
  if (const auto status = run->show(moment); !status) {
    tick_.stop();
    active_ = false;
    Q_EMIT moved(true);
    Q_EMIT changed();
    Q_EMIT failed(status.error());
    return;
  }
  moment_ = moment;
  const bool entered = !std::exchange(active_, true);
  Q_EMIT moved(back);
  if (entered) Q_EMIT changed();
}

void RecordingReplay::play() {
  if (!isPossible() || isPlaying()) return;
  if (!active_ || isAtEnd()) show(begin());
  if (!active_) return;
  setAnchor();
  tick_.start();
  Q_EMIT changed();
}

void RecordingReplay::pause() {
  if (!isPlaying()) return;
  tick_.stop();
  Q_EMIT changed();
}

void RecordingReplay::seek(Nanoseconds moment) {
  show(moment);
  setAnchor();
}

void RecordingReplay::stepCycle(int direction) {
  if (!isPossible()) return;
  pause();
  const auto& samples = recording_.run().record->samples();
  if (direction > 0) return show(samples.next_cycle_time(moment()).value_or(end()));
  const auto now = samples.cycle_time_at(moment());
  show(now ? samples.cycle_time_at(*now - 1).value_or(begin()) : begin());
}

void RecordingReplay::stepMark(int direction) {
  if (!isPossible()) return;
  pause();
  if (direction > 0) {
    const auto next = std::ranges::upper_bound(marks_, moment(), {}, &Mark::time);
    return show(next == marks_.end() ? end() : next->time);
  }
  const auto first = std::ranges::lower_bound(marks_, moment(), {}, &Mark::time);
  show(first == marks_.begin() ? begin() : std::prev(first)->time);
}

void RecordingReplay::setSpeed(int speed) {
  speed = std::clamp(speed, 0, static_cast<int>(kSpeeds.size()) - 1);
  if (speed == speed_) return;
  if (isPlaying()) tick();
  speed_ = speed;
  setAnchor();
  Q_EMIT changed();
}

void RecordingReplay::leave() {
  if (!active_) return;
  tick_.stop();
  active_ = false;
  if (auto* run = recording_.replay()) run->leave();
  Q_EMIT moved(false);
  Q_EMIT changed();
}

void RecordingReplay::tick() {
  if (!isPlaying()) return;
  const auto& speed = kSpeeds[static_cast<std::size_t>(speed_)];
  // What is left in any case, so that no time that the computer slept overflows.
  const auto passed = std::min(clock_() - anchor_clock_,
                               (end() - anchor_moment_) / speed.run * speed.clock + (speed.clock + 1) * kSecond);
  show(anchor_moment_ + passed * speed.run / speed.clock);
  if (active_ && isAtEnd()) pause();
}

}  // namespace syncline::ui
