// SPDX-License-Identifier: Apache-2.0
#include "ui/session/run_findings.h"

#include <utility>

#include "record/run_record.h"
#include "ui/session/network_run.h"

namespace syncline::ui {
namespace {

constexpr int kPeriodMs = 1000;

}  // namespace

RunFindings::RunFindings(NetworkRun& run, QObject* parent) : QObject(parent), run_(run) {
  timer_.setInterval(kPeriodMs);
  connect(&timer_, &QTimer::timeout, this, &RunFindings::refresh);
  connect(&run, &NetworkRun::recordChanged, this, [this] {
    findings_.clear();
    timer_.start();
    Q_EMIT findingsChanged();
  });
  connect(&run, &NetworkRun::phaseChanged, this, [this] {
    if (run_.phase() != NetworkRun::Phase::kOffline) return;
    timer_.stop();
    refresh();
  });
  connect(&run, &NetworkRun::samplesArrived, this, [this] { news_ = true; });
  connect(&run, &NetworkRun::snapshotChanged, this, [this] { news_ = true; });
  connect(&run, &NetworkRun::eventArrived, this, [this] { news_ = true; });
}

void RunFindings::refresh() {
  if (run_.record() == nullptr || !std::exchange(news_, false)) return;
  auto findings = run_.record()->findings();
  if (findings == findings_) return;
  findings_ = std::move(findings);
  Q_EMIT findingsChanged();
}

}  // namespace syncline::ui
