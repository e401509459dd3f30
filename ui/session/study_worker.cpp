// SPDX-License-Identifier: Apache-2.0
#include "ui/session/study_worker.h"

#include "ui/session/post.h"

#include <utility>

namespace syncline::ui {

StudyWorker::~StudyWorker() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void StudyWorker::start(EvenSamples samples, Nanoseconds longest, double unit) {
  if (busy_) return;
  if (thread_.joinable()) thread_.join();
  busy_ = true;
  stop_ = false;
  thread_ = std::thread([this, longest, unit, samples = std::move(samples)]() mutable {
    samples.finish(longest);
    std::shared_ptr<const SignalStudy> study = std::make_shared<SignalStudy>(study_of(samples, unit, &stop_));
    post(*this, [this, study = std::move(study)] {
      busy_ = false;
      if (!stop_) Q_EMIT finished(study);
    });
  });
}

}  // namespace syncline::ui
