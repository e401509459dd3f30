// SPDX-License-Identifier: Apache-2.0
#include "ui/session/run_findings.h"

#include "ui/session/live_session.h"

namespace syncline::ui {
namespace {

constexpr int kPeriodMs = 1000;

}  // namespace

RunFindings::RunFindings(LiveSession& live, QObject* parent) : QObject(parent), live_(live) {
  timer_.setInterval(kPeriodMs);
  connect(&timer_, &QTimer::timeout, this, &RunFindings::refresh);
  connect(&live, &LiveSession::phaseChanged, this, [this] {
    if (live_.phase() == LiveSession::Phase::kStarting) begin();
    if (live_.phase() != LiveSession::Phase::kOffline) return;
    timer_.stop();
    refresh();
  });
  connect(&live, &LiveSession::samplesArrived, this, [this](const std::vector<CycleSample>& samples) {
    if (recorder_) recorder_->add(samples);
    news_ = true;
  });
  connect(&live, &LiveSession::snapshotChanged, this, [this] {
    if (!recorder_ || !live_.snapshot().online) return;
    last_ = live_.snapshot();
    recorder_->add(last_);
    news_ = true;
  });
  connect(&live, &LiveSession::eventArrived, this, [this](const Event& event) {
    if (recorder_) recorder_->add(event);
    news_ = true;
  });
}

void RunFindings::begin() {
  recorder_.emplace(live_.config());
  last_ = {};
  findings_.clear();
  timer_.start();
  Q_EMIT findingsChanged();
}

void RunFindings::refresh() {
  // Judged is what was in OP: on the way there everything is unfinished.
  if (!recorder_ || !std::exchange(news_, false)) return;
  const auto report = recorder_->finish(last_);
  if (!report.history.reached_op) return;
  auto findings = diagnose(report);
  if (findings == findings_) return;
  findings_ = std::move(findings);
  Q_EMIT findingsChanged();
}

}  // namespace syncline::ui
