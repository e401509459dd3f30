// SPDX-License-Identifier: Apache-2.0
#include "ui/session/network_run.h"

#include <chrono>
#include <thread>
#include <utility>

#include "channels/master_channels.h"
#include "reasons/because.h"
#include "record/run_record.h"

namespace syncline::ui {
namespace {

constexpr std::chrono::milliseconds kTickInterval{33};
/// A thread that has been waited for long enough gets this much more when it is told to end.
constexpr std::chrono::milliseconds kLastWait{300};

}  // namespace

/// Given to the master, who has not answered yet.
struct NetworkRun::Applying {
  CommandId id = 0;
  RunOrigin origin;
};

NetworkRun::NetworkRun(MasterOpener opener, QObject* parent) : QObject(parent), opener_(std::move(opener)) {
  tick_.setInterval(kTickInterval);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this, &NetworkRun::tick);
}

NetworkRun::~NetworkRun() = default;

std::uint64_t NetworkRun::droppedSamples() const {
  return session_.master() ? session_.channels().samples.overruns() : 0;
}

std::shared_ptr<FrameRing> NetworkRun::frames() const {
  return session_.master() ? session_.channels().frames : nullptr;
}

RequestDesk* NetworkRun::requests() const { return session_.master() ? &session_.channels().requests : nullptr; }

Status NetworkRun::goOnline(const QString& link, RunOrigin origin) {
  if (phase() != Phase::kOffline) shutDown();
  auto master = opener_(link, origin.project);
  if (!master) return tl::unexpected(master.error());
  session_.take(std::move(*master));
  given_up_ = false;
  link_ = link;
  origin_ = std::move(origin);
  auto record = std::make_unique<RunRecord>(origin_.config);
  record->set_link(link.toStdString());
  if (const auto variables = watchedOf(origin_.config, watched_); !variables.empty()) (void)record->watch(variables);
  const auto before = std::exchange(record_, std::move(record));
  Q_EMIT recordChanged();
  image_ = ImageContents{};
  const auto watch = record_->watched().lists().empty() ? WatchCommand{} : record_->watched().command();
  if (!session_.go_online(record_->config(), AlState::kOp, watch)) tellDeaf();
  tellPhase();
  if (!isVirtual() || auto_advance_) session_.start();
  tick_.start();
  return {};
}

void NetworkRun::goOffline() {
  if (phase() == Phase::kOffline || phase() == Phase::kStopping) return;
  if (!session_.go_offline(phase() == Phase::kStarting || phase() == Phase::kSilent)) tellDeaf();
  tellPhase();
  if (session_.master()->started()) return;
  session_.run_down();
  drain();
  if (phase() == Phase::kStopping) close(session_.patience().stop);
}

void NetworkRun::shutDown() {
  if (phase() == Phase::kOffline) return;
  goOffline();
  if (phase() == Phase::kOffline) return;
  while (phase() == Phase::kStopping && !session_.is_overdue()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    drain();
  }
  if (phase() != Phase::kOffline) close(kLastWait);
}

void NetworkRun::requestState(AlState state) {
  if (session_.master() && phase() == Phase::kOnline) send(RequestStateCommand{state});
}

void NetworkRun::clearStatistics() {
  if (session_.master()) send(ClearStatisticsCommand{});
}

void NetworkRun::arm() {
  if (record_) record_->arm();
}

void NetworkRun::apply(RunOrigin origin) {
  if (!session_.master() || applying_) return;
  const auto id = session_.channels().commands.ask(ConfigureDcmCommand{origin.project.master.dc.dcm});
  if (!id) return tellDeaf();
  applying_ = std::make_unique<Applying>(Applying{*id, std::move(origin)});
  Q_EMIT applyingChanged();
}

void NetworkRun::takeAnswers() {
  while (const auto answer = session_.channels().commands.take_answer()) {
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
  if (!session_.master()) return nullptr;
  (void)session_.channels().image.read(image_);
  return image_.time == 0 ? nullptr : &image_;
}

void NetworkRun::forceOutput(std::uint32_t bit_offset, std::uint32_t bit_size, std::uint64_t value) {
  if (session_.master()) send(ForceOutputCommand{bit_offset, bit_size, value});
}

void NetworkRun::releaseOutput(std::uint32_t bit_offset, std::uint32_t bit_size) {
  if (session_.master()) send(ReleaseOutputCommand{bit_offset, bit_size});
}

void NetworkRun::releaseAllOutputs() {
  if (session_.master()) send(ReleaseAllOutputsCommand{});
}

Status NetworkRun::watch(std::vector<VariableName> names) {
  watched_ = std::move(names);
  if (!session_.master()) return {};
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
  if (!session_.send(std::move(command))) tellDeaf();
}

/// A master that has stopped listening is told like whatever else goes wrong with it.
void NetworkRun::tellDeaf() {
  Q_EMIT eventArrived({snapshot().time, -1, events::Failure{Error{ErrorCode::kTimeout, "master"}}});
}

void NetworkRun::advance(Nanoseconds duration) {
  if (!isVirtual() || session_.master()->started()) return;
  session_.master()->run_for(duration);
  drain();
}

void NetworkRun::tick() {
  hearHeart();
  if (session_.master()) drain();
  if (session_.is_overdue()) close(kLastWait);
}

/// Nothing that a silent one told is shown as if it were so now.
void NetworkRun::hearHeart() {
  const auto sign = session_.listen();
  if (!sign) return;
  if (*sign == Sign::kSilent) image_ = ImageContents{};
  tellPhase();
  if (*sign == Sign::kSilent) Q_EMIT snapshotChanged();
  Q_EMIT signSeen(*sign);
}

void NetworkRun::drain() {
  auto& news = session_.drain();
  news.feed(*record_);
  takeAnswers();
  if (!news.samples.empty()) Q_EMIT samplesArrived(news.samples);
  if (news.snapshot != nullptr) Q_EMIT snapshotChanged();
  // Whoever hears of them may drain again.
  const auto events = std::exchange(news.events, {});
  for (const auto& event : events) {
    Q_EMIT eventArrived(event);
    session_.follow(event);
    tellPhase();
    if (session_.over()) close(session_.patience().stop);
    if (!session_.master()) return;  // the event ended the session
  }
  Q_EMIT drained();
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
  given_up_ = !session_.end(patience);
  tellPhase();
  Q_EMIT snapshotChanged();
  if (given_up_) Q_EMIT signSeen(Sign::kGivenUp);
}

void NetworkRun::tellPhase() {
  if (std::exchange(told_phase_, phase()) != phase()) Q_EMIT phaseChanged();
}

}  // namespace syncline::ui
