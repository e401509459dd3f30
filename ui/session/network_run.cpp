// SPDX-License-Identifier: Apache-2.0
#include "ui/session/network_run.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>

#include "reasons/because.h"
#include "ui/session/master_end.h"

namespace syncline::ui {
namespace {

constexpr std::chrono::milliseconds kTickInterval{33};
/// A thread that has been waited for long enough gets this much more when it is told to end.
constexpr std::chrono::milliseconds kLastWait{300};

}  // namespace

NetworkRun::NetworkRun(MasterOpener opener, QObject* parent) : QObject(parent), opener_(std::move(opener)) {
  tick_.setInterval(kTickInterval);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this, &NetworkRun::tick);
}

NetworkRun::~NetworkRun() {
  if (master_) endMaster(std::move(master_), patience_.stop);
}

bool NetworkRun::isVirtual() const { return master_ && master_->is_virtual(); }

std::uint64_t NetworkRun::droppedSamples() const { return master_ ? master_->channels().samples.overruns() : 0; }

std::shared_ptr<FrameRing> NetworkRun::frames() const { return master_ ? master_->channels().frames : nullptr; }

RequestDesk* NetworkRun::requests() const { return master_ ? &master_->channels().requests : nullptr; }

Status NetworkRun::goOnline(const QString& link, RunOrigin origin) {
  if (phase_ != Phase::kOffline) shutDown();
  auto master = opener_(link, origin.project);
  if (!master) return tl::unexpected(master.error());
  master_ = std::move(*master);
  given_up_ = false;
  link_ = link;
  origin_ = std::move(origin);
  auto record = std::make_unique<RunRecord>(origin_.config);
  if (const auto variables = watchedOf(origin_.config, watched_); !variables.empty()) (void)record->watch(variables);
  const auto before = std::exchange(record_, std::move(record));
  Q_EMIT recordChanged();
  snapshot_ = Snapshot{};
  image_ = ImageContents{};
  if (!record_->watched().lists().empty()) send(record_->watched().command());
  send(GoOnlineCommand{record_->config(), AlState::kOp});
  setPhase(Phase::kStarting);
  if (!master_->is_virtual() || auto_advance_) master_->start();
  heard_at_.start();
  tick_.start();
  return {};
}

void NetworkRun::goOffline() {
  if (phase_ == Phase::kOffline || phase_ == Phase::kStopping) return;
  if (phase_ == Phase::kStarting || phase_ == Phase::kSilent) master_->channels().cancel.store(true);
  send(GoOfflineCommand{});
  stopping_since_.start();
  setPhase(Phase::kStopping);
  if (!master_->started()) {
    while (master_->step() && master_->online()) {
    }
    drain();
    if (phase_ == Phase::kStopping) close(patience_.stop);
  }
}

void NetworkRun::shutDown() {
  if (phase_ == Phase::kOffline) return;
  goOffline();
  if (phase_ == Phase::kOffline) return;
  while (phase_ == Phase::kStopping && !stopping_since_.hasExpired(patience_.stop.count())) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    drain();
  }
  if (phase_ != Phase::kOffline) close(kLastWait);
}

void NetworkRun::requestState(AlState state) {
  if (master_ && phase_ == Phase::kOnline) send(RequestStateCommand{state});
}

void NetworkRun::clearStatistics() {
  if (master_) send(ClearStatisticsCommand{});
}

void NetworkRun::arm() {
  if (record_) record_->arm();
}

void NetworkRun::apply(RunOrigin origin) {
  if (!master_ || applying_) return;
  const auto id = master_->channels().commands.ask(ConfigureDcmCommand{origin.project.master.dc.dcm});
  if (!id) return tellDeaf();
  applying_ = {*id, std::move(origin)};
  Q_EMIT applyingChanged();
}

void NetworkRun::takeAnswers() {
  while (const auto answer = master_->channels().commands.take_answer()) {
    if (!applying_ || applying_->id != answer->id) continue;
    auto given = std::move(applying_->origin);
    applying_.reset();
    Q_EMIT applyingChanged();
    if (answer->refused) continue;
    origin_ = std::move(given);
    Q_EMIT applied();
  }
}

const ImageContents* NetworkRun::image() {
  if (!master_) return nullptr;
  (void)master_->channels().image.read(image_);
  return image_.time == 0 ? nullptr : &image_;
}

void NetworkRun::forceOutput(std::uint32_t bit_offset, std::uint32_t bit_size, std::uint64_t value) {
  if (master_) send(ForceOutputCommand{bit_offset, bit_size, value});
}

void NetworkRun::releaseOutput(std::uint32_t bit_offset, std::uint32_t bit_size) {
  if (master_) send(ReleaseOutputCommand{bit_offset, bit_size});
}

void NetworkRun::releaseAllOutputs() {
  if (master_) send(ReleaseAllOutputsCommand{});
}

Status NetworkRun::watch(std::vector<VariableName> names) {
  watched_ = std::move(names);
  if (!master_) return {};
  const auto variables = watchedOf(record_->config(), watched_);
  if (variables == record_->watched().latest()) return {};
  if (!record_->watch(variables)) {
    return fail(ErrorCode::kNotSupported, "variables",
                because("a run holds {count} different ones: go offline and online again to watch others",
                        WatchLists::kMostVariables));
  }
  send(record_->watched().command());
  Q_EMIT watchChanged(variables);
  return {};
}

void NetworkRun::send(MasterCommand command) {
  if (!master_->channels().commands.push(std::move(command))) tellDeaf();
}

/// A master that has stopped listening is told like whatever else goes wrong with it.
void NetworkRun::tellDeaf() {
  Q_EMIT eventArrived({snapshot_.time, -1, events::Failure{Error{ErrorCode::kTimeout, "master"}}});
}

void NetworkRun::advance(Nanoseconds duration) {
  if (!isVirtual() || master_->started()) return;
  master_->run_for(duration);
  drain();
}

void NetworkRun::tick() {
  hearHeart();
  if (master_) drain();
  if (phase_ == Phase::kStopping && stopping_since_.hasExpired(patience_.stop.count())) close(kLastWait);
}

/// Of a master with a thread of its own: where the window lets time pass, nothing can hang but the window.
void NetworkRun::hearHeart() {
  if (!master_->started() || phase_ == Phase::kStopping) return;
  const auto beats = master_->channels().heartbeat.load(std::memory_order_relaxed);
  if (std::exchange(heard_, beats) != beats) {
    heard_at_.restart();
    if (phase_ != Phase::kSilent) return;
    setPhase(phase_before_silence_);
    Q_EMIT signSeen(Sign::kAlive);
  } else if (phase_ != Phase::kSilent && heard_at_.hasExpired(patience_.silence.count())) {
    fallSilent();
  }
}

/// Nothing that it told is shown as if it were so now.
void NetworkRun::fallSilent() {
  phase_before_silence_ = phase_;
  snapshot_ = Snapshot{};
  image_ = ImageContents{};
  setPhase(Phase::kSilent);
  Q_EMIT snapshotChanged();
  Q_EMIT signSeen(Sign::kSilent);
}

void NetworkRun::drain() {
  auto& channels = master_->channels();
  const auto events = channels.events.drain();
  samples_.clear();
  channels.samples.pop(samples_);
  const bool fresh = channels.snapshot.read(snapshot_);
  record_->add(samples_);
  // Before the snapshot, which shows what came of them.
  for (const auto& event : events) record_->add(event);
  if (fresh) record_->add(snapshot_);
  takeAnswers();
  if (!samples_.empty()) Q_EMIT samplesArrived(samples_);
  if (fresh) Q_EMIT snapshotChanged();
  for (const auto& event : events) {
    handle(event);
    if (!master_) return;  // the event ended the session
  }
  Q_EMIT drained();
}

void NetworkRun::handle(const Event& event) {
  Q_EMIT eventArrived(event);
  if (event.is<events::Online>() && phase_ == Phase::kStarting) setPhase(Phase::kOnline);
  if (event.is<events::Offline>()) close(patience_.stop);
}

void NetworkRun::addNote(const RunNote& note) {
  if (record_ == nullptr) return;
  record_->add(note);
  Q_EMIT noteAdded(note);
}

void NetworkRun::keepTrigger(const KeptTrigger& kept) {
  if (record_ == nullptr) return;
  record_->keep(kept);
  Q_EMIT triggerKept();
}

/// The window waits for no thread any longer than that.
void NetworkRun::close(std::chrono::milliseconds patience) {
  tick_.stop();
  applying_.reset();
  given_up_ = !endMaster(std::move(master_), patience);
  snapshot_ = Snapshot{};
  setPhase(Phase::kOffline);
  Q_EMIT snapshotChanged();
  if (given_up_) Q_EMIT signSeen(Sign::kGivenUp);
}

void NetworkRun::setPhase(Phase phase) {
  if (phase_ == phase) return;
  phase_ = phase;
  Q_EMIT phaseChanged();
}

}  // namespace syncline::ui
