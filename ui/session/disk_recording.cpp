// SPDX-License-Identifier: Apache-2.0
#include "ui/session/disk_recording.h"

#include <QDateTime>
#include <QFileInfo>
#include <QMetaObject>
#include <algorithm>
#include <utility>

#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "ui/session/live_session.h"
#include "ui/session/run_difference.h"
#include "ui/session/run_findings.h"

namespace syncline::ui {

DiskRecording::DiskRecording(LiveSession& live, const RunFindings& findings, const RunDifference& running,
                             const Environment& environment, QObject* parent)
    : QObject(parent),
      live_(live),
      findings_(findings),
      running_(running),
      environment_(environment),
      recent_(kMemoryBudget) {
  connectRun();
}

DiskRecording::~DiskRecording() { finish(); }

void DiskRecording::connectRun() {
  connect(&live_, &LiveSession::recordChanged, this, [this] { recent_.clear(); });
  connect(&live_, &LiveSession::samplesArrived, this, [this](const std::vector<CycleSample>& samples) {
    recent_.add(samples);
    if (recorder_) recorder_->add(samples);
  });
  connect(&live_, &LiveSession::snapshotChanged, this, [this] {
    if (recorder_) recorder_->add(live_.snapshot());
  });
  connect(&live_, &LiveSession::eventArrived, this, [this](const Event& event) {
    if (!recorder_ || !environment_.record_event) return;
    if (auto recorded = environment_.record_event(event)) recorder_->add(std::move(*recorded));
  });
  connect(&findings_, &RunFindings::findingsChanged, this, [this] {
    if (recorder_) recorder_->tell(recorded(findings_.findings()));
  });
  connect(&live_, &LiveSession::phaseChanged, this, [this] {
    if (live_.phase() == LiveSession::Phase::kOffline) stop();
    Q_EMIT changed();
  });
}

Result<RecordingAbout> DiskRecording::about() const {
  const auto* run = live_.record();
  if (run == nullptr) return fail(ErrorCode::kFileNotWritable, {}, "no machine has run yet: go online first");
  auto result = about_run(run->config());
  result.program = "syncline " + environment_.version.toStdString();
  result.link = live_.link().toStdString();
  // On the virtual clock every run is alike, and so is its file.
  if (!live_.isVirtual()) {
    result.begun = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  }
  result.documents.push_back({"project", "project.syncline", eni::write_project(running_.running())});
  result.documents.push_back({"configuration", "configuration.eni.xml", eni::write_eni(run->config())});
  return result;
}

Status DiskRecording::start(const QString& path) {
  if (recorder_ != nullptr) return {};
  const auto what = about();
  if (!what) return tl::unexpected(what.error());
  wait();
  Recorder::Options options;
  options.by_clock = !live_.isVirtual();
  options.wait_for_disk = live_.isVirtual();
  stop_.reset();
  auto recorder = Recorder::start(path.toStdString(), *what, options, [this](const Recorder::Stop& stop) {
    QMetaObject::invokeMethod(
        this, [this, stop] { onStopped(stop); }, Qt::QueuedConnection);
  });
  if (!recorder) return tl::unexpected(recorder.error());
  recorder_ = std::move(*recorder);
  path_ = path;
  begun_ = live_.record()->samples().empty() ? 0 : live_.record()->samples().last_time();
  recorder_->tell(recorded(findings_.findings()));
  Q_EMIT changed();
  return {};
}

/// The recorder has ended by itself.
void DiskRecording::onStopped(const Recorder::Stop& stop) {
  if (recorder_ == nullptr) return;
  stop_ = stop;
  this->stop();
}

void DiskRecording::stop() {
  if (recorder_ == nullptr) return;
  wait();
  const auto& run = live_.record();
  const bool ended = live_.phase() == LiveSession::Phase::kOffline;
  finisher_ = std::thread([this, path = path_, ended, recorder = std::shared_ptr<Recorder>(std::move(recorder_)),
                           findings = recorded(run == nullptr ? std::vector<Finding>{} : run->findings())] {
    const auto status = recorder->finish(ended ? "end of the run" : "stopped by the user", findings);
    QMetaObject::invokeMethod(
        this, [this, path, status] { onFinished(path, status); }, Qt::QueuedConnection);
  });
  Q_EMIT changed();
}

void DiskRecording::onFinished(const QString& path, const Status& status) {
  if (finisher_.joinable()) finisher_.join();
  std::optional<Error> error;
  if (!status) error = status.error();
  if (stop_ && stop_->error) error = stop_->error;
  Q_EMIT ended(path, stop_ ? QString::fromStdString(stop_->why) : QString(), error);
  Q_EMIT changed();
}

void DiskRecording::wait() {
  if (finisher_.joinable()) finisher_.join();
}

void DiskRecording::finish() {
  stop();
  wait();
  if (saver_.joinable()) saver_.join();
}

Nanoseconds DiskRecording::duration() const {
  if (recorder_ == nullptr || live_.record() == nullptr || live_.record()->samples().empty()) return 0;
  const auto& samples = live_.record()->samples();
  return samples.last_time() - std::max(begun_, samples.first_time());
}

qint64 DiskRecording::bytes() const {
  return path_.isEmpty() ? 0 : QFileInfo(path_).size() + QFileInfo(path_ + QStringLiteral("-wal")).size();
}

Nanoseconds DiskRecording::memoryReach() const {
  return live_.record() == nullptr ? 0 : recent_.reach(live_.record()->limits().cycle_time);
}

Status DiskRecording::saveLast(Nanoseconds duration, const QString& path) {
  auto what = about();
  if (!what) return tl::unexpected(what.error());
  if (recent_.span() == 0) return fail(ErrorCode::kFileNotWritable, {}, "no cycle has run yet: go online first");
  if (saving_) return fail(ErrorCode::kFileNotWritable, {}, "another stretch is being written; try again in a moment");
  if (saver_.joinable()) saver_.join();
  const auto& record = *live_.record();
  auto run = std::make_shared<RecentRun>();
  run->about = std::move(*what);
  run->from = std::max(record.samples().last_time() - duration, recent_.begin());
  run->samples = recent_.since(run->from);
  run->held = held_copy(record);
  for (const auto& event : record.events()) {
    if (event.time < run->from || !environment_.record_event) continue;
    if (auto words = environment_.record_event(event)) run->events.push_back(std::move(*words));
  }
  run->findings = recorded(record.findings());
  saving_ = true;
  saver_ = std::thread([this, run, path] {
    const auto status = save_recent(path.toStdString(), *run);
    QMetaObject::invokeMethod(
        this,
        [this, path, status] {
          saving_ = false;
          Q_EMIT saved(path, status ? std::nullopt : std::optional(status.error()));
        },
        Qt::QueuedConnection);
  });
  return {};
}

}  // namespace syncline::ui
