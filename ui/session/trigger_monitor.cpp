// SPDX-License-Identifier: Apache-2.0
#include "ui/session/trigger_monitor.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "record/run_record.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

constexpr int kTriggerTickMs = 50;
constexpr unsigned kLooksAFinding = 10;
constexpr Nanoseconds kPortionCycles = 1'000'000;  // a tick: some milliseconds of work

const QString kTriggerKey = QStringLiteral("trigger/%1");

int kept(const WindowMemory& memory, const char* name, int usual, int most) {
  const auto value = memory.value(kTriggerKey.arg(QLatin1String(name)));
  const int number = value.isValid() ? value.toInt() : usual;
  return number < 0 || number > most ? usual : number;
}

double keptNumber(const WindowMemory& memory, const char* name, double usual) {
  const auto value = memory.value(kTriggerKey.arg(QLatin1String(name)));
  return value.isValid() ? value.toDouble() : usual;
}

Trigger recalled(const WindowMemory& memory) {
  Trigger trigger;
  trigger.kind = static_cast<Trigger::Kind>(kept(memory, "kind", 0, 3));
  trigger.mode = static_cast<Trigger::Mode>(kept(memory, "mode", 1, 2));
  trigger.edge = static_cast<Trigger::Edge>(kept(memory, "edge", 0, 2));
  const auto key = memory.value(kTriggerKey.arg(QLatin1String("signal"))).toString().toStdString();
  const bool of_slave = memory.value(kTriggerKey.arg(QLatin1String("ofSlave"))).toBool();
  trigger.variable = memory.value(kTriggerKey.arg(QLatin1String("variable"))).toString().toStdString();
  using Scope = SignalInfo::Scope;
  const auto* signal = find_signal(key, of_slave                   ? Scope::kSlave
                                        : trigger.variable.empty() ? Scope::kBus
                                                                   : Scope::kVariable);
  if (signal != nullptr && signal->form != SignalInfo::Form::kCell) trigger.signal = signal->id;
  trigger.slave = kept(memory, "slave", -1, 65535);
  trigger.magnitude = kept(memory, "magnitude", 0, 1) == 1;
  trigger.enters = kept(memory, "enters", 0, 1) == 1;
  trigger.level = keptNumber(memory, "level", trigger.level);
  trigger.low = keptNumber(memory, "low", trigger.low);
  trigger.high = keptNumber(memory, "high", trigger.high);
  trigger.code = memory.value(kTriggerKey.arg(QLatin1String("code"))).toString().toStdString();
  trigger.hold_off = static_cast<Nanoseconds>(keptNumber(memory, "holdOff", static_cast<double>(trigger.hold_off)));
  trigger.pre = static_cast<Nanoseconds>(keptNumber(memory, "pre", static_cast<double>(trigger.pre)));
  trigger.post = static_cast<Nanoseconds>(keptNumber(memory, "post", static_cast<double>(trigger.post)));
  return trigger;
}

void keep(WindowMemory& memory, const Trigger& trigger) {
  const auto put = [&memory](const char* name, const QVariant& value) {
    memory.setValue(kTriggerKey.arg(QLatin1String(name)), value);
  };
  const auto& signal = info(trigger.signal);
  put("kind", static_cast<int>(trigger.kind));
  put("mode", static_cast<int>(trigger.mode));
  put("edge", static_cast<int>(trigger.edge));
  put("signal", QString::fromUtf8(signal.key.data(), static_cast<qsizetype>(signal.key.size())));
  put("ofSlave", signal.scope == SignalInfo::Scope::kSlave);
  put("slave", trigger.slave);
  const bool of_variable = signal.scope == SignalInfo::Scope::kVariable;
  put("variable", of_variable ? QString::fromStdString(trigger.variable) : QString());
  put("magnitude", trigger.magnitude ? 1 : 0);
  put("enters", trigger.enters ? 1 : 0);
  put("level", trigger.level);
  put("low", trigger.low);
  put("high", trigger.high);
  put("code", QString::fromStdString(trigger.code));
  put("holdOff", static_cast<double>(trigger.hold_off));
  put("pre", static_cast<double>(trigger.pre));
  put("post", static_cast<double>(trigger.post));
}

}  // namespace

TriggerMonitor::TriggerMonitor(WindowMemory& memory, QObject* parent)
    : QObject(parent), memory_(memory), trigger_(recalled(memory)) {
  tick_.setInterval(kTriggerTickMs);
  connect(&tick_, &QTimer::timeout, this, &TriggerMonitor::look);
}

void TriggerMonitor::setRecord(const RunRecord* record, bool recorded) {
  record_ = record;
  recorded_ = recorded;
  names_.clear();
  watch_.reset();
  earlier_.clear();
  kept_.reset();
  if (own_) trigger_ = *std::exchange(own_, std::nullopt);
  if (!armed_) showKept();
  Q_EMIT recordChanged();
  if (armed_) {
    const auto* kept = keptOfRecord();
    const auto names = kept == nullptr ? std::map<Nanoseconds, std::string>() : kept->names;
    begin(std::numeric_limits<Nanoseconds>::min());
    names_ = names;
  }
  Q_EMIT changed();
}

void TriggerMonitor::showKept() {
  if (record_ == nullptr || record_->triggers().empty()) return;
  const auto* kept = keptOfRecord();
  if (kept == nullptr && !recorded_) return;
  if (kept == nullptr) {
    kept = &record_->triggers().back();
    own_ = std::exchange(trigger_, kept->trigger);
  }
  kept_ = *kept;
  names_ = kept_->names;
}

const KeptTrigger* TriggerMonitor::keptOfRecord() const {
  if (record_ == nullptr) return nullptr;
  const auto found = std::ranges::find_if(
      record_->triggers(), [this](const KeptTrigger& one) { return finds_the_same(one.trigger, trigger_); });
  return found == record_->triggers().end() ? nullptr : &*found;
}

void TriggerMonitor::setTrigger(const Trigger& trigger) {
  if (trigger == trigger_) return;
  const bool same = finds_the_same(trigger_, trigger);
  trigger_ = trigger;
  own_.reset();
  if (!same) {
    kept_.reset();
    names_.clear();
  }
  keep(memory_, trigger_);
  if (armed_) {
    arm();
  } else {
    watch_.reset();
    if (const auto* kept = recorded_ ? nullptr : keptOfRecord()) {
      kept_ = *kept;
      names_ = kept->names;
    }
  }
  Q_EMIT triggerChanged();
  Q_EMIT changed();
}

void TriggerMonitor::arm() {
  armed_ = true;
  const auto names = kept_ ? std::exchange(kept_, std::nullopt)->names : std::map<Nanoseconds, std::string>();
  const bool from_now = record_ != nullptr && !recorded_ && !record_->samples().empty();
  // What a run had before is not looked at again, and stays.
  const auto* kept = from_now ? keptOfRecord() : nullptr;
  const auto before = kept == nullptr ? KeptTrigger{} : *kept;
  earlier_ = before.episodes;
  begin(from_now ? record_->samples().last_time() + 1 : std::numeric_limits<Nanoseconds>::min());
  // What is found again has the name that it had.
  names_ = recorded_ ? names : before.names;
  Q_EMIT changed();
}

void TriggerMonitor::setBack() {
  if (!armed_) return;
  const auto names = names_;
  begin(std::numeric_limits<Nanoseconds>::min());
  names_ = names;
}

void TriggerMonitor::begin(Nanoseconds from) {
  watch_ = std::make_unique<TriggerWatch>(trigger_, from);
  names_.clear();
  heard_ = 0;
  looks_ = 0;
  told_ = 0;
  whole_ = false;
  gatherEpisodes();
  tick_.start();
  look();
  Q_EMIT changed();
}

void TriggerMonitor::disarm() {
  armed_ = false;
  tick_.stop();
  Q_EMIT changed();
}

const std::vector<TriggerEpisode>& TriggerMonitor::episodes() const {
  static const std::vector<TriggerEpisode> kNone;
  if (watch_) return episodes_;
  return kept_ ? kept_->episodes : kNone;
}

QString TriggerMonitor::name(const TriggerEpisode& episode) const {
  const auto found = names_.find(episode.time);
  return found == names_.end() ? QString() : QString::fromStdString(found->second);
}

void TriggerMonitor::setName(const TriggerEpisode& episode, const QString& name) {
  names_[episode.time] = name.toStdString();
  tellFound();
}

/// What was found before in the same run, and is not looked at again, stays.
void TriggerMonitor::tellFound() {
  if (recorded_ || record_ == nullptr || episodes().empty()) return;
  KeptTrigger kept{trigger_, {}, {}};
  if (const auto* same = keptOfRecord()) {
    std::ranges::copy_if(same->episodes, std::back_inserter(kept.episodes),
                         [first = episodes().front().time](const TriggerEpisode& one) { return one.time < first; });
    kept.names = same->names;
  }
  kept.episodes.insert(kept.episodes.end(), episodes().begin(), episodes().end());
  if (const auto all = kept.episodes.size(); all > TriggerWatch::kMostEpisodes)
    kept.episodes.erase(kept.episodes.begin(),
                        kept.episodes.begin() + static_cast<std::ptrdiff_t>(all - TriggerWatch::kMostEpisodes));
  for (const auto& [time, name] : names_) kept.names[time] = name;
  Q_EMIT found(kept);
}

void TriggerMonitor::hearEvents() {
  const auto& told = record_->events();
  const auto all = record_->forgotten_events() + told.size();
  const auto fresh = std::min<std::uint64_t>(all - std::min(heard_, all), told.size());
  for (auto event = told.end() - static_cast<std::ptrdiff_t>(fresh); event != told.end(); ++event)
    watch_->hear(*event, record_->samples());
  heard_ = all;
}

/// What is found follows from all figures of the run: it is not asked for at every tick.
void TriggerMonitor::hearFindings() {
  if (trigger_.kind != Trigger::Kind::kFinding || looks_++ % kLooksAFinding != 0) return;
  watch_->hear(record_->findings(), record_->samples());
}

void TriggerMonitor::look() {
  if (!armed_ || !watch_ || record_ == nullptr || record_->samples().empty()) return;
  const auto before = stateText();
  const auto count = watch_->count();
  const auto left_out = leftOut();
  hearEvents();
  hearFindings();
  whole_ = watch_->look(record_->samples(), kPortionCycles * std::max<Nanoseconds>(record_->limits().cycle_time, 1));
  gatherEpisodes();
  tellCompleted(whole_);
  if (count != watch_->count() || left_out != leftOut()) tellFound();
  if (count != watch_->count() || left_out != leftOut() || before != stateText()) Q_EMIT changed();
}

void TriggerMonitor::gatherEpisodes() {
  episodes_ = earlier_;
  episodes_.insert(episodes_.end(), watch_->episodes().begin(), watch_->episodes().end());
  if (const auto all = episodes_.size(); all > TriggerWatch::kMostEpisodes)
    episodes_.erase(episodes_.begin(),
                    episodes_.begin() + static_cast<std::ptrdiff_t>(all - TriggerWatch::kMostEpisodes));
}

void TriggerMonitor::tellCompleted(bool whole) {
  if (!whole || told_ == watch_->count()) return;
  const auto newest = episodes().back();
  if (!isWhole() && record_->samples().last_time() < newest.to) return;
  told_ = watch_->count();
  Q_EMIT completed(newest);
}

QString TriggerMonitor::stateText() const {
  if (!armed_ || !watch_) return tr("not armed");
  if (record_ == nullptr || record_->samples().empty()) return tr("armed: waits for a run");
  using State = TriggerWatch::State;
  if (isWhole()) return whole_ ? tr("all of the recording was looked at") : tr("looks through the recording");
  switch (watch_->state(record_->samples().first_time(), record_->samples().last_time())) {
    case State::kFilling:
      return tr("fills the time before the trigger");
    case State::kWaiting:
      return tr("waits for the trigger");
    case State::kTriggered:
      return tr("triggered");
    case State::kHoldingOff:
      return tr("holds off");
    case State::kDone:
      return tr("done: triggered once");
  }
  return {};
}

}  // namespace syncline::ui
