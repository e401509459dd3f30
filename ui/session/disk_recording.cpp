// SPDX-License-Identifier: Apache-2.0
#include "ui/session/disk_recording.h"

#include <QFileInfo>
#include <algorithm>
#include <iterator>
#include <utility>

#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "reasons/because.h"
#include "record/trigger_document.h"
#include "ui/files/held_file.h"
#include "ui/session/network_run.h"
#include "ui/session/post.h"
#include "ui/session/run_findings.h"

namespace syncline::ui {

namespace {

std::size_t mibBytes(int mib) { return static_cast<std::size_t>(mib) << 20U; }

}  // namespace

DiskRecording::DiskRecording(NetworkRun& run, const RunFindings& findings, const Environment& environment,
                             QObject* parent)
    : QObject(parent), run_(run), findings_(findings), environment_(environment), recent_(mibBytes(kUsualMemoryMib)) {
  connectRun();
}

DiskRecording::~DiskRecording() { finish(); }

void DiskRecording::connectRun() {
  connect(&run_, &NetworkRun::recordChanged, this, [this] { recent_.clear(); });
  connect(&run_, &NetworkRun::samplesArrived, this, [this](const std::vector<CycleSample>& samples) {
    recent_.add(samples);
    if (!recorder_) return;
    if (first_ == 0 && !samples.empty()) first_ = samples.front().send_time;
    recorder_->add(samples);
    tellStanding();
    tellTriggers(false);
  });
  connect(&run_, &NetworkRun::watchChanged, this, [this](const std::vector<WatchedVariable>& variables) {
    if (recorder_) recorder_->tell(variables);
  });
  connect(&run_, &NetworkRun::snapshotChanged, this, [this] {
    if (recorder_) recorder_->add(run_.snapshot());
  });
  connect(&run_, &NetworkRun::eventArrived, this, [this](const Event& event) {
    if (!recorder_ || !environment_.record_event) return;
    if (auto recorded = environment_.record_event(event)) recorder_->add(std::move(*recorded));
  });
  connect(&run_, &NetworkRun::noteAdded, this, [this](const RunNote& note) {
    if (recorder_) recorder_->add(note);
  });
  connect(&run_, &NetworkRun::triggerKept, this, [this] { triggers_new_ = true; });
  connect(&findings_, &RunFindings::findingsChanged, this, [this] {
    if (recorder_) recorder_->tell(found());
  });
  connect(&run_, &NetworkRun::applied, this, [this] {
    if (recorder_) recorder_->tell(project());
  });
  connect(&run_, &NetworkRun::phaseChanged, this, [this] {
    if (run_.phase() == NetworkRun::Phase::kOffline) stop();
    if (run_.phase() == NetworkRun::Phase::kStarting) views_.reset();
    Q_EMIT changed();
  });
}

void DiskRecording::setViews(const std::vector<MonitorView>& views) { views_ = views; }

/// What runs, with what was applied to it since.
RecordedDocument DiskRecording::project() const {
  const auto& [origin, path, config] = run_.origin();
  auto project = origin;
  if (views_) project.views = *views_;
  return {"project", path.isEmpty() ? "project.syncline" : QFileInfo(path).fileName().toStdString(),
          eni::write_project(project)};
}

RecordingAbout DiskRecording::about() const {
  const auto& run = *run_.record();
  auto result = about_run(run);
  result.program = "syncline " + environment_.version.toStdString();
  result.link = run_.link().toStdString();
  result.documents.push_back(project());
  result.documents.push_back({"configuration", "configuration.eni.xml", eni::write_eni(run.config())});
  if (!run.triggers().empty()) result.documents.push_back(trigger_document(run.triggers()));
  return result;
}

/// A restless one finds more with every cycle: once a second is enough, and at the end.
void DiskRecording::tellTriggers(bool at_end) {
  const auto now = run_.record()->samples().last_time();
  if (!triggers_new_ || (!at_end && now - triggers_told_ < kSecond)) return;
  triggers_new_ = false;
  triggers_told_ = now;
  recorder_->tell(trigger_document(run_.record()->triggers()));
}

/// With the moments of the file that is written, which may have begun in the middle of the run.
std::vector<RecordedFinding> DiskRecording::found() const {
  return recorded(run_.record()->findings(first_ != 0 ? first_ : begun_));
}

void DiskRecording::tellStanding() {
  const auto standing = run_.record()->standing();
  if (standing == told_) return;
  told_ = standing;
  recorder_->tell(standing);
}

Status DiskRecording::start(const QString& path) {
  if (recorder_ != nullptr) return {};
  const auto phase = run_.phase();
  if (phase != NetworkRun::Phase::kStarting && phase != NetworkRun::Phase::kOnline)
    return fail(ErrorCode::kFileNotWritable, {}, because("no machine runs: go online first"));
  const int number = number_ + 1;
  Recorder::Options options;
  options.by_clock = !run_.isVirtual();
  options.wait_for_disk = run_.isVirtual();
  auto recorder = Recorder::start(path.toStdString(), about(), options, [this, number](const Recorder::Stop& stop) {
    post(*this, [this, number, stop] { onStopped(number, stop); });
  });
  if (!recorder) return tl::unexpected(recorder.error());
  recorder_ = std::move(*recorder);
  number_ = number;
  path_ = path;
  file_.hold(path);
  begun_ = run_.record()->samples().empty() ? 0 : run_.record()->samples().last_time();
  told_ = run_.record()->standing();
  first_ = 0;
  recorder_->tell(found());
  Q_EMIT changed();
  return {};
}

/// The recorder has ended by itself; by now it may be another one that records.
void DiskRecording::onStopped(int number, const Recorder::Stop& stop) {
  if (recorder_ != nullptr && number == number_) this->stop();
  if (const auto ending = ending_.find(number); ending != ending_.end()) ending->second.stop = stop;
}

void DiskRecording::stop() {
  if (recorder_ == nullptr) return;
  tellStanding();
  if (views_) recorder_->tell(project());
  tellTriggers(true);
  const bool ended = run_.phase() == NetworkRun::Phase::kOffline;
  auto& ending = ending_[number_];
  ending.path = path_;
  ending.thread = std::thread(
      [this, number = number_, ended, recorder = std::shared_ptr<Recorder>(std::move(recorder_)), findings = found()] {
        const auto status = recorder->finish(ended ? "end of the run" : "stopped by the user", findings);
        post(*this, [this, number, status] { onFinished(number, status); });
      });
  Q_EMIT changed();
}

void DiskRecording::onFinished(int number, const Status& status) {
  const auto found = ending_.find(number);
  if (found == ending_.end()) return;
  found->second.thread.join();
  const auto [path, stop] = std::pair(found->second.path, found->second.stop);
  ending_.erase(found);
  if (recorder_ == nullptr && ending_.empty()) file_.hold({});
  std::optional<Error> error;
  if (!status) error = status.error();
  if (stop && stop->error) error = stop->error;
  Q_EMIT ended(path, stop ? QString::fromStdString(stop->why) : QString(), error);
  Q_EMIT changed();
}

void DiskRecording::finish() {
  stop();
  for (auto& [number, ending] : ending_) {
    if (ending.thread.joinable()) ending.thread.join();
  }
  if (saver_.joinable()) saver_.join();
}

Nanoseconds DiskRecording::duration() const {
  if (recorder_ == nullptr || run_.record() == nullptr || run_.record()->samples().empty()) return 0;
  const auto& samples = run_.record()->samples();
  return samples.last_time() - std::max(begun_, samples.first_time());
}

qint64 DiskRecording::bytes() const {
  return path_.isEmpty() ? 0 : QFileInfo(path_).size() + QFileInfo(path_ + QStringLiteral("-wal")).size();
}

Nanoseconds DiskRecording::memoryReach() const {
  return run_.record() == nullptr ? 0 : recent_.reach(run_.record()->limits().cycle_time);
}

Nanoseconds DiskRecording::memoryReach(int mib) const {
  return static_cast<Nanoseconds>(static_cast<double>(memoryReach()) * mib / memoryMib());
}

void DiskRecording::setMemoryMib(int mib) {
  recent_.set_budget(mibBytes(mib));
  Q_EMIT changed();
}

Status DiskRecording::saveLast(Nanoseconds duration, const QString& path) {
  if (recent_.span() == 0)
    return fail(ErrorCode::kFileNotWritable, {}, because("no cycle has run yet: go online first"));
  return saveRange(run_.record()->samples().last_time() - duration, INT64_MAX - 1, path);
}

Status DiskRecording::saveRange(Nanoseconds from, Nanoseconds to, const QString& path) {
  if (recent_.span() == 0 || to < recent_.begin())
    return fail(ErrorCode::kFileNotWritable, {}, because("no cycle of it is in memory any more"));
  if (saving_)
    return fail(ErrorCode::kFileNotWritable, {}, because("another stretch is being written; try again in a moment"));
  if (saver_.joinable()) saver_.join();
  const auto& record = *run_.record();
  auto run = std::make_shared<RecentRun>();
  run->about = about();
  run->from = std::max(from, recent_.begin());
  run->to = to;
  run->samples = recent_.since(run->from);
  run->held = held_copy(record, to);
  std::vector<Event> events;
  std::ranges::copy_if(record.events(), std::back_inserter(events),
                       [from = run->from, to](const Event& event) { return event.time >= from && event.time <= to; });
  run->findings = recorded(record.findings(run->from));
  std::ranges::copy_if(record.notes(), std::back_inserter(run->notes),
                       [from = run->from, to](const RunNote& note) { return note.time >= from && note.time <= to; });
  saving_ = true;
  saver_ = std::thread([this, run, path, events = std::move(events), words_of = environment_.record_event] {
    for (const auto& event : events) {
      if (auto words = words_of ? words_of(event) : std::nullopt) run->events.push_back(std::move(*words));
    }
    const auto status = save_recent(path.toStdString(), *run);
    post(*this, [this, path, status] {
      saving_ = false;
      Q_EMIT saved(path, status ? std::nullopt : std::optional(status.error()));
    });
  });
  return {};
}

}  // namespace syncline::ui
