// SPDX-License-Identifier: Apache-2.0
#include "ui/session/live_session.h"

#include <chrono>
#include <thread>
#include <utility>

#include "master/master_service.h"
#include "ui/session/virtual_pacer.h"

namespace syncline::ui {
namespace {

constexpr std::chrono::milliseconds kTickInterval{33};
constexpr qint64 kStopTimeoutMs = 3000;

}  // namespace

LiveSession::LiveSession(LinkOpener opener, QObject* parent) : QObject(parent), opener_(std::move(opener)) {
  tick_.setInterval(kTickInterval);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this, &LiveSession::tick);
}

LiveSession::~LiveSession() {
  pacer_.reset();
  thread_.reset();
  if (service_) service_->shut_down();
  service_.reset();
}

bool LiveSession::isVirtual() const { return clock_ && clock_->is_virtual(); }

std::uint64_t LiveSession::droppedSamples() const { return service_ ? service_->channels().samples.overruns() : 0; }

Status LiveSession::goOnline(const QString& link, NetworkConfig config) {
  if (phase_ != Phase::kOffline) shutDown();
  auto connection = opener_(link);
  if (!connection) return tl::unexpected(connection.error());
  clock_ = std::move(connection->clock);
  service_ = std::make_unique<MasterService>(std::move(connection->link), *clock_);
  link_ = link;
  config_ = std::move(config);
  snapshot_ = Snapshot{};
  service_->channels().commands.push(GoOnlineCommand{config_, AlState::kOp});
  setPhase(Phase::kStarting);
  if (!clock_->is_virtual()) {
    thread_ = std::make_unique<MasterThread>(*service_);
  } else if (auto_advance_) {
    pacer_ = std::make_unique<VirtualPacer>(*service_);
  }
  tick_.start();
  return {};
}

void LiveSession::goOffline() {
  if (phase_ == Phase::kOffline || phase_ == Phase::kStopping) return;
  if (phase_ == Phase::kStarting) service_->channels().cancel.store(true);
  service_->channels().commands.push(GoOfflineCommand{});
  stopping_since_.start();
  setPhase(Phase::kStopping);
  if (!thread_ && !pacer_) {
    while (service_->step() && service_->online()) {
    }
    drain();
    if (phase_ == Phase::kStopping) close();
  }
}

void LiveSession::shutDown() {
  if (phase_ == Phase::kOffline) return;
  goOffline();
  if (phase_ == Phase::kOffline) return;
  while (phase_ == Phase::kStopping && stopping_since_.elapsed() < kStopTimeoutMs) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    drain();
  }
  if (phase_ != Phase::kOffline) close();
}

void LiveSession::requestState(AlState state) {
  if (service_ && phase_ == Phase::kOnline) service_->channels().commands.push(RequestStateCommand{state});
}

void LiveSession::clearStatistics() {
  if (service_) service_->channels().commands.push(ClearStatisticsCommand{});
}

void LiveSession::advance(Nanoseconds duration) {
  if (!service_ || !isVirtual() || pacer_) return;
  service_->run_for(duration);
  drain();
}

void LiveSession::tick() {
  drain();
  if (phase_ == Phase::kStopping && stopping_since_.elapsed() > kStopTimeoutMs) close();
}

void LiveSession::drain() {
  auto& channels = service_->channels();
  const auto events = channels.events.drain();
  samples_.clear();
  channels.samples.pop(samples_);
  const bool fresh = channels.snapshot.read(snapshot_);
  if (!samples_.empty()) Q_EMIT samplesArrived(samples_);
  if (fresh) Q_EMIT snapshotChanged();
  for (const auto& event : events) {
    handle(event);
    if (!service_) return;  // the event ended the session
  }
}

void LiveSession::handle(const Event& event) {
  Q_EMIT eventArrived(event);
  switch (event.kind) {
    case EventKind::kOnline:
      if (phase_ == Phase::kStarting) setPhase(Phase::kOnline);
      break;
    case EventKind::kOffline:
      close();
      break;
    default:
      break;
  }
}

void LiveSession::close() {
  tick_.stop();
  pacer_.reset();
  thread_.reset();
  service_->shut_down();
  service_.reset();
  clock_.reset();
  snapshot_ = Snapshot{};
  setPhase(Phase::kOffline);
  Q_EMIT snapshotChanged();
}

void LiveSession::setPhase(Phase phase) {
  if (phase_ == phase) return;
  phase_ = phase;
  Q_EMIT phaseChanged();
}

}  // namespace syncline::ui
