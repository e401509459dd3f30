// SPDX-License-Identifier: Apache-2.0
#include "record/run_session.h"

#include <future>
#include <system_error>
#include <thread>
#include <utility>

#include "channels/master_channels.h"
#include "config/network_config.h"
#include "support/attempt.h"

namespace syncline {
namespace {

bool end_beside(std::unique_ptr<BackgroundMaster> master, std::chrono::milliseconds patience) {
  if (!master->started()) return true;
  std::promise<void> told;
  const auto ended = told.get_future();
  // Nobody joins it: a thread that hangs is not waited for by another one that then hangs, too.
  try {
    std::thread([master = std::move(master), told = std::move(told)]() mutable {
      master.reset();
      told.set_value();
    }).detach();
  } catch (const std::system_error&) {
    return true;  // the system gives no thread: the master has ended here, with what was to be that thread's
  }
  return ended.wait_for(patience) == std::future_status::ready;
}

}  // namespace

RunSession::~RunSession() {
  if (master_) attempt([this] { return end(patience_.stop); });
}

void RunSession::take(std::unique_ptr<BackgroundMaster> master) {
  master_ = std::move(master);
  snapshot_ = Snapshot{};
  over_ = false;
}

MasterChannels& RunSession::channels() const { return master_->channels(); }

bool RunSession::send(MasterCommand command) { return channels().commands.push(std::move(command)); }

bool RunSession::go_online(const NetworkConfig& config, AlState target, const WatchCommand& watch) {
  bool taken = watch.count == 0 || send(watch);
  taken = send(GoOnlineCommand{config, target}) && taken;
  phase_ = Phase::kStarting;
  return taken;
}

void RunSession::start() {
  master_->start();
  heard_at_ = WallClock::now();
}

/// The snapshot first: whatever it shows the results of is then among the rest.
RunNews& RunSession::drain() {
  news_.snapshot = channels().snapshot.read(snapshot_) ? &snapshot_ : nullptr;
  news_.samples.clear();
  channels().samples.pop(news_.samples);
  news_.events = channels().events.drain();
  return news_;
}

void RunSession::follow(const Event& event) {
  if (event.is<events::Online>() && phase_ == Phase::kStarting) phase_ = Phase::kOnline;
  if (event.is<events::Offline>()) over_ = true;
}

/// Where its owner lets time pass, nothing can hang but the owner.
std::optional<RunSession::Sign> RunSession::listen() {
  if (!master_->started() || phase_ == Phase::kStopping) return std::nullopt;
  const auto now = WallClock::now();
  const auto beats = channels().heartbeat.load(std::memory_order_relaxed);
  if (std::exchange(heard_, beats) != beats) {
    heard_at_ = now;
    if (phase_ != Phase::kSilent) return std::nullopt;
    phase_ = phase_before_silence_;
    return Sign::kAlive;
  }
  if (phase_ == Phase::kSilent || now - heard_at_ <= patience_.silence) return std::nullopt;
  phase_before_silence_ = std::exchange(phase_, Phase::kSilent);
  snapshot_ = Snapshot{};
  return Sign::kSilent;
}

bool RunSession::go_offline(bool cancel) {
  if (cancel) channels().cancel.store(true);
  stopping_since_ = WallClock::now();
  phase_ = Phase::kStopping;
  return send(GoOfflineCommand{});
}

void RunSession::run_down() {
  if (master_->started()) return;
  while (master_->step() && master_->online()) {
  }
}

bool RunSession::is_overdue() const {
  return phase_ == Phase::kStopping && WallClock::now() - stopping_since_ > patience_.stop;
}

bool RunSession::end(std::chrono::milliseconds patience) {
  const bool ended = end_beside(std::move(master_), patience);
  snapshot_ = Snapshot{};
  phase_ = Phase::kOffline;
  return ended;
}

}  // namespace syncline
