// SPDX-License-Identifier: Apache-2.0
#include "ui/session/live_session.h"

namespace syncline::ui {

LiveSession::LiveSession(NetworkRun& run, QObject* parent) : QObject(parent), run_(&run) { listen(); }

void LiveSession::listen() {
  connect(run_, &NetworkRun::phaseChanged, this, &LiveSession::phaseChanged);
  connect(run_, &NetworkRun::recordChanged, this, &LiveSession::recordChanged);
  connect(run_, &NetworkRun::applyingChanged, this, &LiveSession::applyingChanged);
  connect(run_, &NetworkRun::applied, this, &LiveSession::applied);
  connect(run_, &NetworkRun::snapshotChanged, this, &LiveSession::snapshotChanged);
  connect(run_, &NetworkRun::samplesArrived, this, &LiveSession::samplesArrived);
  connect(run_, &NetworkRun::eventArrived, this, &LiveSession::eventArrived);
  connect(run_, &NetworkRun::drained, this, &LiveSession::drained);
}

void LiveSession::show(NetworkRun& run) {
  if (run_ == &run) return;
  disconnect(run_, nullptr, this, nullptr);
  run_ = &run;
  run_->setAutoAdvance(auto_advance_);
  listen();
}

void LiveSession::tellShown() {
  Q_EMIT recordChanged();
  Q_EMIT phaseChanged();
  Q_EMIT snapshotChanged();
}

void LiveSession::setAutoAdvance(bool on) {
  auto_advance_ = on;
  run_->setAutoAdvance(on);
}

}  // namespace syncline::ui
