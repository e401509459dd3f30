// SPDX-License-Identifier: Apache-2.0
#include "ui/session/workspace.h"

#include <algorithm>
#include <utility>

#include "findings/fold.h"
#include "ui/text/event_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/recorded_text.h"

namespace syncline::ui {
namespace {

const QString kLastLink = QStringLiteral("link");

}  // namespace

QString Workspace::usualLink() const { return link_.isEmpty() ? memory_.value(kLastLink).toString() : link_; }

Workspace::Workspace(Environment environment, QObject* parent)
    : QObject(parent),
      environment_(std::move(environment)),
      memory_(environment_.settings_file),
      templates_(environment_.templates_folder),
      autosave_(document_, environment_.recovery_folder),
      configuration_(document_),
      eni_(document_),
      scan_(environment_.scan_bus, environment_.describe_slaves, environment_.esi_folders),
      catalogue_(environment_.esi_folders),
      eeprom_repair_(environment_.eeprom_repairs),
      live_(environment_.open_master),
      requests_(live_),
      running_slaves_(document_, live_),
      watched_(document_, memory_),
      run_difference_(document_, configuration_, live_),
      run_findings_(live_),
      disk_(live_, run_findings_, run_difference_, environment_) {
  network_.setProject(document_.project());
  cables_.setProject(document_.project());
  connect(&document_, &ProjectDocument::projectChanged, this, [this] {
    network_.setProject(document_.project());
    cables_.setProject(document_.project());
    network_.setConfiguration(configuration_.config());
  });
  connect(&configuration_, &ConfigurationMonitor::compiled, this, [this] {
    network_.setConfiguration(configuration_.config());
    showFindings();
  });
  connect(&live_, &LiveSession::snapshotChanged, this, [this] {
    network_.setSnapshot(live_.snapshot(), running_slaves_.positions());
    cables_.setSnapshot(live_.snapshot(), running_slaves_.positions());
  });
  connect(&live_, &LiveSession::eventArrived, this, [this](const Event& event) {
    if (auto message = messageOf(event, live_.record()->config())) {
      message->slave = running_slaves_.slaveOf(event.slave);
      message->run = run_;
      // A simulated machine's virtual clock is no time of day.
      if (live_.isVirtual()) message->time = QDateTime::currentDateTime();
      messages_.append(std::move(*message));
    }
  });
  connect(&live_, &LiveSession::recordChanged, this, [this] { ++run_; });
  connect(&live_, &LiveSession::samplesArrived, this, [this] {
    if (std::exchange(begun_run_, run_) != run_) messages_.setRunBegin(run_, live_.record()->overview().begin);
  });
  connect(&run_findings_, &RunFindings::findingsChanged, this, [this] { showRunFindings(); });
  connect(&recording_, &OpenedRecording::changed, this, &Workspace::showRecording);
  connect(&recording_, &OpenedRecording::changed, this, &Workspace::mayEditSlavesChanged);
  connect(&live_, &LiveSession::phaseChanged, this, &Workspace::mayEditSlavesChanged);
  connect(this, &Workspace::mayEditSlavesChanged, this, [this] { network_.setFixed(!mayEditSlaves()); });
  connect(&autosave_, &Autosave::failed, this,
          [this](const Error& error) { report(error, Severity::kWarning, tr("Unsaved work is not kept")); });
  connect(&scan_, &ScanController::eventArrived, this, [this](const Event& event) {
    if (auto message = messageOf(event, document_.project())) {
      message->time = QDateTime::currentDateTime();
      message->moment = 0;
      messages_.append(std::move(*message));
    }
  });
  connect(&scan_, &ScanController::finished, this, &Workspace::tellOfScan);
  connect(&scan_, &ScanController::failed, this, [this](const QString&, const Error& error) {
    report(error, error.code == ErrorCode::kCancelled ? Severity::kNote : Severity::kError, tr("Scan"));
  });
}

void Workspace::setExpert(bool expert) {
  if (expert == std::exchange(expert_, expert)) return;
  Q_EMIT expertChanged();
}

void Workspace::setLink(const QString& link) {
  if (link_ == link) return;
  link_ = link;
  memory_.setValue(kLastLink, link);
  Q_EMIT linkChanged();
}

const RunRecord* Workspace::shownRecord() const {
  return recording_.isOpen() ? recording_.run().record.get() : live_.record();
}

/// Its events and findings in place of those of the run, which come back when it is closed.
void Workspace::showRecording() {
  if (recording_.isOpen()) {
    messages_.showOther(recording_.messages());
    messages_.setRunBegin(kRecordedRun, recording_.run().record->overview().begin);
  } else {
    messages_.showOwn();
  }
  showFindings();
  showRunFindings();
}

QString Workspace::whySlavesStay() const {
  if (live_.phase() != LiveSession::Phase::kOffline)
    return tr("The machine is running: go offline to change its slaves.");
  if (recording_.isOpen())
    return tr("A recording is shown: close it to change the slaves of the project (File, Close Recording).");
  return {};
}

Status Workspace::goOnline() {
  if (recording_.isOpen())
    return fail(ErrorCode::kNotSupported, "online", "a recording is shown: close it first (File, Close Recording)");
  const auto& compiled = configuration_.current();
  if (!compiled) return tl::unexpected(compiled.error());
  const auto worst = std::ranges::find(compiled->findings, Severity::kError, &Finding::severity);
  if (worst != compiled->findings.end()) return fail(ErrorCode::kConfiguration, worst->place.key, describe(*worst));
  return live_.goOnline(link_, compiled->config);
}

void Workspace::report(const Error& error, Severity severity, const QString& source) {
  messages_.append(messageOf(error, severity, source));
}

void Workspace::inform(const QString& source, const QString& text) {
  messages_.append({QDateTime::currentDateTime(), Severity::kNote, source, text, -1, {}});
}

std::vector<Finding> Workspace::shownFindings() const {
  return recording_.isOpen() ? recording_.run().record->findings() : run_findings_.findings();
}

/// What many slaves have alike is one row, at the first of them.
void Workspace::showRunFindings() {
  std::vector<Finding> rows;
  for (auto& [finding, slaves] : folded(shownFindings())) rows.push_back(std::move(finding));
  findings_.setFindings(rows);
}

/// Of the project: beside a recording, which has slaves of its own, there is none.
void Workspace::showFindings() {
  if (recording_.isOpen()) return messages_.setFindings({});
  std::vector<Message> lines;
  const auto& result = configuration_.result();
  if (result) {
    for (const auto& [finding, slaves] : folded(result->findings)) {
      lines.push_back(messageOf(finding, document_.project()));
      lines.back().finding = std::make_shared<const Finding>(finding);
      lines.back().found_at.assign(slaves.begin(), slaves.end());
      if (slaves.size() > 1) lines.back().source = slavesText(slaves);
    }
  } else if (!document_.project().slaves.empty()) {
    lines.push_back(messageOf(result.error(), Severity::kError, tr("Configuration")));
  }
  std::ranges::stable_sort(lines, std::ranges::greater{}, &Message::severity);
  messages_.setFindings(std::move(lines));
}

void Workspace::tellOfScan(const QString& link, const ScanOutcome& outcome) {
  setLink(link);
  for (const auto& warning : outcome.built.warnings) {
    auto line = messageOf(warning, outcome.built.project);
    line.time = QDateTime::currentDateTime();
    line.severity = Severity::kWarning;
    line.source = tr("Scan");
    messages_.append(std::move(line));
  }
  const auto count = static_cast<int>(outcome.built.project.slaves.size());
  inform(tr("Scan"), tr("%n slave(s) found on %1", nullptr, count).arg(link));
}

}  // namespace syncline::ui
