// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <thread>

#include "trace/signal_study.h"

namespace syncline::ui {

/// Makes the study of a signal in a thread of its own, one at a time.
class StudyWorker final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~StudyWorker() override;

  /// Until finished() or, of one that was dropped, until its thread has ended.
  [[nodiscard]] bool isBusy() const { return busy_; }
  /// Only when it is not busy. `longest`, `unit`: as EvenSamples::finish() and study_of() take them.
  void start(EvenSamples samples, Nanoseconds longest, double unit);
  /// What is being made is not wanted: finished() is not told of it.
  void drop() { stop_ = true; }

 Q_SIGNALS:
  void finished(std::shared_ptr<const SignalStudy> study);

 private:
  std::thread thread_;
  std::atomic<bool> stop_ = false;
  bool busy_ = false;
};

}  // namespace syncline::ui
