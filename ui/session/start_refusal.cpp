// SPDX-License-Identifier: Apache-2.0
#include "ui/session/start_refusal.h"

#include <utility>

#include "channels/event.h"
#include "record/run_record.h"
#include "ui/text/event_text.h"

namespace syncline::ui {

StartRefusal::StartRefusal(LiveSession& live, QObject* parent) : QObject(parent), live_(live), run_(&live.run()) {
  connect(&live_, &LiveSession::phaseChanged, this, &StartRefusal::follow);
  connect(&live_, &LiveSession::eventArrived, this, &StartRefusal::take);
}

/// Whoever ends a start himself ends it by way of stopping.
void StartRefusal::follow() {
  const auto before = std::exchange(phase_, live_.phase());
  const bool same_run = std::exchange(run_, &live_.run()) == &live_.run();
  if (same_run && before == LiveSession::Phase::kStarting && phase_ == LiveSession::Phase::kOffline) {
    refused_ = true;
    Q_EMIT changed();
    return;
  }
  if (same_run && phase_ == LiveSession::Phase::kOffline) return;
  if (phase_ == LiveSession::Phase::kStarting) {
    slaves_.clear();
    reason_.reset();
  }
  forget();
}

void StartRefusal::take(const Event& event) {
  if (live_.phase() != LiveSession::Phase::kStarting || live_.record() == nullptr) return;
  auto message = messageOf(event, live_.record()->config());
  if (!message || message->severity != Severity::kError) return;
  if (message->slave >= 0) slaves_.insert(message->slave);
  if (!reason_) reason_ = std::move(message);
}

void StartRefusal::forget() {
  if (std::exchange(refused_, false)) Q_EMIT changed();
}

}  // namespace syncline::ui
