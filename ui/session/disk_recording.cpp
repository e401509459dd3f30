// SPDX-License-Identifier: Apache-2.0
#include "ui/session/disk_recording.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "reasons/because.h"
#include "record/recent_run.h"
#include "record/recording_session.h"
#include "record/run_record.h"
#include "record/trigger_document.h"
#include "sqlite/database_files.h"
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
    if (!session_) return;
    session_->add(samples);
    session_->follow(*run_.record());
  });
  connect(&run_, &NetworkRun::watchChanged, this, [this](const std::vector<WatchedVariable>& variables) {
    if (session_) session_->tell(variables);
  });
  connect(&run_, &NetworkRun::snapshotChanged, this, [this] {
    if (session_) session_->add(run_.snapshot());
  });
  connect(&run_, &NetworkRun::eventArrived, this, [this](const Event& event) {
    if (session_) session_->add(event);
  });
  connect(&run_, &NetworkRun::noteAdded, this, [this](const RunNote& note) {
    if (session_) session_->add(note);
  });
  connect(&run_, &NetworkRun::triggerKept, this, [this] {
    if (session_) session_->note_triggers();
  });
  connect(&findings_, &RunFindings::findingsChanged, this, [this] {
    if (session_) session_->tell_findings(*run_.record());
  });
  connect(&run_, &NetworkRun::applied, this, [this] {
    if (session_) session_->tell(project());
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
  return project_document(path.isEmpty() ? "project.syncline" : QFileInfo(path).fileName().toStdString(),
                          eni::write_project(project));
}

RecordingAbout DiskRecording::about() const {
  const auto& run = *run_.record();
  auto result = about_run(run);
  auto document = project();
  add_source(result, {.program = "syncline " + environment_.version.toStdString(),
                      .link = run_.link().toStdString(),
                      .project_name = std::move(document.name),
                      .project_body = std::move(document.body),
                      .eni = eni::write_eni(run.config())});
  if (!run.triggers().empty()) result.documents.push_back(trigger_document(run.triggers()));
  return result;
}

Status DiskRecording::start(const QString& path) {
  if (session_ != nullptr) return {};
  const auto phase = run_.phase();
  if (phase != NetworkRun::Phase::kStarting && phase != NetworkRun::Phase::kOnline)
    return fail(ErrorCode::kFileNotWritable, {}, because("no machine runs: go online first"));
  const int number = number_ + 1;
  const auto& run = *run_.record();
  const auto stopped = [this, number](const RecordingStop& stop) {
    post(*this, [this, number, stop] { onStopped(number, stop); });
  };
  auto session = RecordingSession::start(
      {.path = path.toStdString(), .virtual_time = run_.isVirtual(), .bounds = {.wait_for_disk = run_.isVirtual()}},
      about(), stopped, run.samples().empty() ? 0 : run.samples().last_time());
  if (!session) return tl::unexpected(session.error());
  session_ = std::move(*session);
  number_ = number;
  path_ = path;
  file_.hold(path);
  session_->begin(run);
  Q_EMIT changed();
  return {};
}

/// The recorder has ended by itself; by now it may be another one that records.
void DiskRecording::onStopped(int number, const RecordingStop& stop) {
  if (session_ != nullptr && number == number_) this->stop();
  if (const auto ending = ending_.find(number); ending != ending_.end()) ending->second.stop = stop;
}

void DiskRecording::stop() {
  if (session_ == nullptr) return;
  if (views_) session_->tell(project());
  auto findings = session_->close(*run_.record());
  const bool ended = run_.phase() == NetworkRun::Phase::kOffline;
  auto& ending = ending_[number_];
  ending.path = path_;
  ending.thread =
      std::thread([this, number = number_, ended, session = std::shared_ptr<RecordingSession>(std::move(session_)),
                   findings = std::move(findings)] {
        const auto status = session->finish(ended ? "end of the run" : "stopped by the user", findings);
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
  if (session_ == nullptr && ending_.empty()) file_.hold({});
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
  return session_ == nullptr || run_.record() == nullptr ? 0 : session_->duration(*run_.record());
}

qint64 DiskRecording::bytes() const {
  return path_.isEmpty() ? 0 : static_cast<qint64>(database_bytes(path_.toStdString()));
}

std::uint64_t DiskRecording::lostSamples() const { return session_ ? session_->lost_samples() : 0; }

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
  auto run = std::make_shared<RecentRun>(take_recent(*run_.record(), recent_, about(), from, to));
  saving_ = true;
  saver_ = std::thread([this, run, path] {
    const auto status = save_recent(path.toStdString(), *run);
    post(*this, [this, path, status] {
      saving_ = false;
      Q_EMIT saved(path, status ? std::nullopt : std::optional(status.error()));
    });
  });
  return {};
}

}  // namespace syncline::ui
