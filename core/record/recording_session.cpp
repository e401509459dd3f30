// SPDX-License-Identifier: Apache-2.0
#include "record/recording_session.h"

#include <algorithm>
#include <utility>

#include "channels/event.h"
#include "record/recorded_event.h"
#include "record/recorder.h"
#include "record/run_note.h"
#include "record/run_record.h"
#include "record/trigger_document.h"

namespace syncline {

RecordedDocument project_document(std::string name, std::string body) {
  return {"project", std::move(name), std::move(body)};
}

void add_source(RecordingAbout& about, RecordingSource source) {
  about.program = std::move(source.program);
  about.link = std::move(source.link);
  about.documents.push_back(project_document(std::move(source.project_name), std::move(source.project_body)));
  about.documents.push_back({"configuration", "configuration.eni.xml", std::move(source.eni)});
}

Result<std::unique_ptr<RecordingSession>> RecordingSession::start(Request request, const RecordingAbout& about,
                                                                  std::function<void(const RecordingStop&)> on_stopped,
                                                                  Nanoseconds begun) {
  request.bounds.by_clock = !request.virtual_time;
  auto recorder = Recorder::start(request.path, about, request.bounds, std::move(on_stopped));
  if (!recorder) return tl::unexpected(recorder.error());
  std::unique_ptr<RecordingSession> session(new RecordingSession(begun));
  session->recorder_ = std::move(*recorder);
  return session;
}

RecordingSession::RecordingSession(Nanoseconds begun) : begun_(begun) {}

RecordingSession::~RecordingSession() = default;

void RecordingSession::add(std::span<const CycleSample> samples) {
  if (first_ == 0 && !samples.empty()) first_ = samples.front().send_time;
  recorder_->add(samples);
}

void RecordingSession::add(const Snapshot& snapshot) { recorder_->add(snapshot); }

void RecordingSession::add(const Event& event) {
  if (auto words = recorded_event(event)) recorder_->add(std::move(*words));
}

void RecordingSession::add(const RunNote& note) { recorder_->add(note); }

void RecordingSession::tell(RecordedDocument document) { recorder_->tell(std::move(document)); }

void RecordingSession::tell(std::vector<WatchedVariable> list) { recorder_->tell(std::move(list)); }

void RecordingSession::begin(const RunRecord& run) {
  told_ = run.standing();
  tell_findings(run);
}

void RecordingSession::follow(const RunRecord& run) {
  tell_standing(run);
  tell_triggers(run, false);
}

void RecordingSession::tell_findings(const RunRecord& run) { recorder_->tell(recorded(run.findings(told_from()))); }

std::vector<RecordedFinding> RecordingSession::close(const RunRecord& run) {
  tell_standing(run);
  tell_triggers(run, true);
  return recorded(run.findings(told_from()));
}

void RecordingSession::tell_standing(const RunRecord& run) {
  const auto standing = run.standing();
  if (standing == told_) return;
  told_ = standing;
  recorder_->tell(standing);
}

/// A restless one finds more with every cycle: once a second is enough, and at the end.
void RecordingSession::tell_triggers(const RunRecord& run, bool at_end) {
  const auto now = run.samples().last_time();
  if (!triggers_new_ || (!at_end && now - triggers_told_ < kSecond)) return;
  triggers_new_ = false;
  triggers_told_ = now;
  recorder_->tell(trigger_document(run.triggers()));
}

std::uint64_t RecordingSession::lost_samples() const { return recorder_->lost_samples(); }

Status RecordingSession::finish(const std::string& why, std::span<const RecordedFinding> findings) {
  return recorder_->finish(why, findings);
}

Nanoseconds RecordingSession::duration(const RunRecord& run) const {
  const auto& samples = run.samples();
  return samples.empty() ? 0 : samples.last_time() - std::max(begun_, samples.first_time());
}

}  // namespace syncline
