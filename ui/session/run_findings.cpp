// SPDX-License-Identifier: Apache-2.0
#include "ui/session/run_findings.h"

#include <utility>

#include "ui/session/live_session.h"

namespace syncline::ui {
namespace {

constexpr int kPeriodMs = 1000;

}  // namespace

RunFindings::RunFindings(LiveSession& live, QObject* parent) : QObject(parent), live_(live) {
  timer_.setInterval(kPeriodMs);
  connect(&timer_, &QTimer::timeout, this, &RunFindings::refresh);
  connect(&live, &LiveSession::recordChanged, this, [this] {
    findings_.clear();
    timer_.start();
    Q_EMIT findingsChanged();
  });
  connect(&live, &LiveSession::phaseChanged, this, [this] {
    if (live_.phase() != LiveSession::Phase::kOffline) return;
    timer_.stop();
    refresh();
  });
  connect(&live, &LiveSession::samplesArrived, this, [this] { news_ = true; });
  connect(&live, &LiveSession::snapshotChanged, this, [this] { news_ = true; });
  connect(&live, &LiveSession::eventArrived, this, [this] { news_ = true; });
}

void RunFindings::refresh() {
  if (live_.record() == nullptr || !std::exchange(news_, false)) return;
  auto findings = live_.record()->findings();
  if (findings == findings_) return;
  findings_ = std::move(findings);
  Q_EMIT findingsChanged();
}

}  // namespace syncline::ui
