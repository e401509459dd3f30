// SPDX-License-Identifier: Apache-2.0
#include "ui/session/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "findings/error_text.h"
#include "findings/fold.h"
#include "reasons/because.h"
#include "settings/settings_table.h"
#include "ui/text/event_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/link_text.h"
#include "ui/text/recorded_text.h"
#include "ui/text/setting_text.h"

namespace syncline::ui {
namespace {

const QString kLastLink = QStringLiteral("link");
const QString kBlackBoxOn = QStringLiteral("blackBox/on"), kBlackBoxFolder = QStringLiteral("blackBox/folder"),
              kBlackBoxMib = QStringLiteral("blackBox/mib"), kMemoryMib = QStringLiteral("recording/memoryMib");

BlackBoxWish rememberedWish(const WindowMemory& memory) {
  BlackBoxWish wish;
  wish.folder = memory.value(kBlackBoxFolder).toString();
  wish.on = memory.value(kBlackBoxOn).toBool() && !wish.folder.isEmpty();
  const auto mib = memory.value(kBlackBoxMib).toInt();
  if (mib >= 1 && mib <= BlackBoxWish::kMostMib) wish.mib = mib;
  return wish;
}

}  // namespace

QString Workspace::usualLink() const { return link().isEmpty() ? memory_.value(kLastLink).toString() : link(); }

Workspace::Workspace(Environment environment, QObject* parent)
    : QObject(parent),
      environment_(std::move(environment)),
      memory_(environment_.settings_file),
      templates_(environment_.templates_folder),
      runs_(document_, environment_),
      autosave_(document_, environment_.recovery_folder),
      configuration_(document_),
      eni_(document_),
      scan_(environment_.scan_bus, environment_.describe_slaves, environment_.esi_folders),
      catalogue_(environment_.esi_folders),
      eeprom_repair_(environment_.eeprom_repairs),
      requests_(live()),
      running_slaves_(document_, live()),
      watched_(document_, memory_),
      variables_(document_, memory_),
      run_difference_(document_, configuration_, live()),
      start_refusal_(live()) {
  runs_.setBlackBox(rememberedWish(memory_));
  if (const int mib = memory_.value(kMemoryMib).toInt(); mib >= 1 && mib <= DiskRecording::kMostMemoryMib)
    runs_.setMemoryMib(mib);
  showNetworks();
  cables_.setProject(document_.project());
  connect(&document_, &ProjectDocument::viewsChanged, this,
          [this] { runs_.current().disk.setViews(document_.views()); });
  connect(&document_, &ProjectDocument::projectChanged, this, [this] {
    // Of another network, or of another machine, all are told: which one is in work is a part of the tree.
    if (document_.network() == network_.network() && document_.networks().size() == network_.networkCount()) {
      network_.setProject(document_.project());
    } else {
      showNetworks();
    }
    cables_.setProject(document_.project());
    network_.setConfiguration(document_.network(), configuration_.config());
  });
  // Other slaves than those that did not start: perhaps mended.
  connect(&document_, &ProjectDocument::slavesReplaced, &start_refusal_, &StartRefusal::forget);
  connect(&configuration_, &ConfigurationMonitor::compiled, this, [this] {
    network_.setConfiguration(document_.network(), configuration_.config());
    showFindings();
  });
  for (const auto signal : {&EniPreview::changed, &EniPreview::progressed})
    connect(&eni_, signal, this, &Workspace::showEniFindings);
  connect(&live(), &LiveSession::snapshotChanged, this, [this] {
    network_.setSnapshot(document_.network(), live().snapshot(), running_slaves_.positions());
    cables_.setSnapshot(live().snapshot(), running_slaves_.positions());
  });
  for (const auto signal : {&ProjectDocument::taken, &ProjectDocument::networksChanged})
    connect(&document_, signal, this, &Workspace::showNetworks);
  connect(&runs_, &NetworkRuns::snapshotChanged, this, &Workspace::showOther);
  connect(&variables_, &VariableWatch::changed, this, [this] {
    if (const auto status = runs_.watch(variables_.names()); !status)
      report(status.error(), Severity::kWarning, tr("Monitor"));
    trigger_.tellVariables();
  });
  connect(&runs_, &NetworkRuns::eventArrived, this, &Workspace::appendEvent);
  connect(&runs_, &NetworkRuns::signSeen, this, &Workspace::appendSign);
  connect(&runs_, &NetworkRuns::noteAdded, this, &Workspace::appendNote);
  connect(&trigger_, &TriggerMonitor::found, this,
          [this](const KeptTrigger& kept) { runs_.current().run.keepTrigger(kept); });
  connect(&runs_, &NetworkRuns::begun, this, [this](int run, qint64 moment) { messages_.setRunBegin(run, moment); });
  connect(&runs_, &NetworkRuns::dcmLogBegan, this,
          [this](const QString& path) { inform(tr("Controller log"), tr("Written to %1").arg(path)); });
  connect(&runs_, &NetworkRuns::dcmLogEnded, this, [this](const QString& path, const std::optional<Error>& error) {
    if (error) return report(*error, Severity::kError, tr("Controller log"));
    inform(tr("Controller log"), tr("Lies in %1").arg(path));
  });
  connect(&runs_, &NetworkRuns::findingsChanged, this, [this] { showRunFindings(); });
  connect(&recording_, &OpenedRecording::changed, this, &Workspace::showRecording);
  connect(&recording_, &OpenedRecording::notesChanged, this, [this] {
    messages_.showOther(recording_.messages());
    showMoment();
  });
  connect(&replay_, &RecordingReplay::moved, this, &Workspace::showMoment);
  connect(&replay_, &RecordingReplay::failed, this,
          [this](const Error& error) { report(error, Severity::kError, tr("Replay")); });
  connect(&overlay_, &RecordingOverlay::changed, this, &Workspace::showRunFindings);
  connect(&recording_, &OpenedRecording::changed, this, &Workspace::mayEditSlavesChanged);
  connect(&live(), &LiveSession::phaseChanged, this, &Workspace::mayEditSlavesChanged);
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

void Workspace::showNetworks() {
  const auto names = document_.networks();
  std::vector<const Project*> projects;
  for (int i = 0; i < names.size(); ++i) projects.push_back(&document_.project(i));
  network_.setNetworks(names, projects, document_.network());
}

/// The states of a network that is not in work, which runs all the same.
void Workspace::showOther(int network) {
  if (network == document_.network() || network < 0 || network >= network_.networkCount()) return;
  const auto& run = runs_.of(network).run;
  if (run.record() == nullptr) return;
  network_.setSnapshot(network, run.snapshot(), positionsIn(document_.project(network), run.record()->config()));
}

void Workspace::appendEvent(int network, const Event& event) {
  if (network < 0) return;  // of a machine that was replaced
  const auto& running = runs_.of(network).run.record()->config();
  auto message = messageOf(event, running);
  if (!message) return;
  message->slave = slaveOf(document_.project(network), running, event.slave);
  appendOfRun(network, std::move(*message));
}

/// What no event tells, as it is the master that should tell it.
void Workspace::appendSign(int network, NetworkRun::Sign sign) {
  if (network < 0) return;
  Message message{QDateTime::currentDateTime(), Severity::kError, tr("Master"), {}, -1, {}};
  switch (sign) {
    case NetworkRun::Sign::kSilent:
      message.text =
          tr("The master gives no sign of life: its thread hangs, or the adapter's driver does. What the slaves do "
             "now is not known, and no values are shown until it answers again. Go offline (Shift+F5); where it does "
             "not answer then either, restart the program.");
      break;
    case NetworkRun::Sign::kAlive:
      message.severity = Severity::kNote;
      message.text = tr("The master answers again.");
      break;
    case NetworkRun::Sign::kGivenUp:
      message.text =
          tr("The master did not go offline in time and is left to itself: the slaves may still be in OP, and it may "
             "still send. Make the machine safe by other means, and restart the program before you go online again.");
      break;
  }
  appendOfRun(network, std::move(message));
}

void Workspace::appendNote(int network, const RunNote& note) {
  if (network < 0) return;
  Message message{dateTimeOf(note.time), Severity::kNote, tr("Note"), QString::fromStdString(note.text), -1, {}};
  message.moment = note.time;
  appendOfRun(network, std::move(message));
}

/// Of several networks each says which one it is of.
void Workspace::appendOfRun(int network, Message message) {
  const auto& session = runs_.of(network);
  message.run = session.number;
  if (const auto names = document_.networks(); names.size() > 1)
    message.source = tr("%1: %2").arg(names[network], message.source);
  // A simulated machine's virtual clock is no time of day.
  if (session.run.isVirtual()) message.time = QDateTime::currentDateTime();
  messages_.append(std::move(message));
}

void Workspace::setExpert(bool expert) {
  if (expert == std::exchange(expert_, expert)) return;
  Q_EMIT expertChanged();
}

void Workspace::setLink(const QString& link) {
  if (this->link() == link) return;
  memory_.setValue(kLastLink, link);
  runs_.setLink(link);
}

const RunRecord* Workspace::shownRecord() const {
  return recording_.isOpen() ? recording_.run().record.get() : runs_.current().run.record();
}

/// Its events and findings in place of those of the run, which come back when it is closed.
void Workspace::showRecording() {
  found_shown_ = true;
  if (recording_.isOpen()) {
    messages_.showOther(recording_.messages());
    messages_.setRunBegin(kRecordedRun, recording_.run().record->overview().begin);
  } else {
    messages_.showOwn();
  }
  showFindings();
}

/// What was told up to the moment of the recording that is shown, and found by then.
void Workspace::showMoment() {
  if (!recording_.isOpen()) return;
  const auto& told = recording_.messages();
  const auto until = replay_.isActive() && !replay_.isAtEnd() ? replay_.moment() : INT64_MAX;
  const auto later = std::ranges::upper_bound(told, until, {}, &Message::moment);
  messages_.showOtherUntil(told, static_cast<std::size_t>(later - told.begin()));
  const bool found = until == INT64_MAX;
  if (found != std::exchange(found_shown_, found)) showRunFindings();
}

QString Workspace::whySlavesStay() const {
  if (runs_.current().run.phase() != LiveSession::Phase::kOffline)
    return tr("The machine is running: go offline to change its slaves.");
  if (recording_.isOpen())
    return tr("A recording is shown: close it to change the slaves of the project (File, Close Recording).");
  return {};
}

Status Workspace::mayUse(const QString& link) const {
  const int other = runs_.userOf(link);
  if (other < 0) return {};
  return fail(ErrorCode::kConfiguration, link.toStdString(),
              because("the network \"{name}\" runs on it: choose another link or take that one offline",
                      document_.networks().value(other).toStdString()));
}

Status Workspace::goOnline() {
  if (recording_.isOpen())
    return fail(ErrorCode::kNotSupported, "online",
                because("a recording is shown: close it first (File, Close Recording)"));
  const auto& compiled = configuration_.current();
  if (!compiled) return tl::unexpected(compiled.error());
  const auto worst = std::ranges::find(compiled->findings, Severity::kError, &Finding::severity);
  if (worst != compiled->findings.end())
    return fail(ErrorCode::kConfiguration, worst->place.key, Reason::verbatim(describe(*worst)));
  if (auto free = mayUse(link()); !free) return free;
  return live().goOnline(link(), {document_.project(), document_.path(), compiled->config});
}

Status Workspace::putNote(const RunNote& note) {
  if (!recording_.isOpen()) {
    runs_.current().run.addNote(note);
    return {};
  }
  auto notes = recording_.run().info.notes;
  std::erase_if(notes, [&note](const RunNote& old) { return old.time == note.time; });
  if (!note.text.empty()) notes.push_back(note);
  return recording_.setNotes(std::move(notes));
}

/// An error of a setting is at its field, which has a name that people know.
void Workspace::report(const Error& error, Severity severity, const QString& source) {
  const auto& project = document_.project();
  const auto ref = settings::find(project, error.subject, false);
  if (!ref) return messages_.append(messageOf(error, severity, source));
  auto named = error;
  const int slave = ref->setting->of_slave() ? static_cast<int>(ref->place.slave) : -1;
  named.subject = QStringLiteral("%1, %2").arg(nodeName(project, slave), settingLabel(*ref->setting)).toStdString();
  auto line = messageOf(named, severity, source);
  line.slave = slave;
  line.key = QString::fromStdString(error.subject);
  messages_.append(std::move(line));
}

void Workspace::setBlackBox(const BlackBoxWish& wish) {
  memory_.setValue(kBlackBoxOn, wish.on);
  memory_.setValue(kBlackBoxFolder, wish.folder);
  memory_.setValue(kBlackBoxMib, wish.mib);
  runs_.setBlackBox(wish);
}

void Workspace::setMemoryMib(int mib) {
  memory_.setValue(kMemoryMib, mib);
  runs_.setMemoryMib(mib);
}

void Workspace::inform(const QString& source, const QString& text) {
  messages_.append({QDateTime::currentDateTime(), Severity::kNote, source, text, -1, {}});
}

std::vector<Finding> Workspace::shownFindings() const {
  return recording_.isOpen() ? recording_.run().record->findings() : runs_.current().findings.findings();
}

/// What many slaves have alike is one row, at the first of them. What is wrong with the file that lies over the
/// recording stands beside it: what is a gap there was none in its run.
void Workspace::showRunFindings() {
  auto rows = recording_.isOpen() ? std::vector<Finding>{} : project_findings_;
  for (auto& [finding, slaves] : folded(shownFindings())) rows.push_back(std::move(finding));
  if (overlay_.isOpen()) {
    for (auto finding : overlay_.run().record->findings()) {
      if (!is_about_file(finding)) continue;
      finding.place.file = overlay_.name().toStdString();
      rows.push_back(std::move(finding));
    }
  }
  std::ranges::stable_sort(rows, std::ranges::greater{}, &Finding::severity);
  findings_.setFindings(rows);
}

/// What both say of a setting the compiler says with a way to mend it.
std::vector<Finding> Workspace::findingsOfEni() const {
  auto findings = shown_check_ ? eni::findings_of_export(*shown_check_) : std::vector<Finding>{};
  const auto& result = configuration_.result();
  if (!result) return findings;
  std::erase_if(findings, [&result](const Finding& finding) {
    return !finding.place.key.empty() && std::ranges::any_of(result->findings, [&finding](const Finding& told) {
      return told.place.key == finding.place.key;
    });
  });
  return findings;
}

std::vector<Finding> Workspace::settingFindings() const {
  auto findings = findingsOfEni();
  if (const auto& result = configuration_.result())
    findings.insert(findings.begin(), result->findings.begin(), result->findings.end());
  return findings;
}

/// Of the project: beside a recording, which has slaves of its own, there is none.
void Workspace::showFindings() {
  std::vector<Message> lines;
  if (!recording_.isOpen()) lines = projectLines();
  std::ranges::stable_sort(lines, std::ranges::greater{}, &Message::severity);
  project_findings_.clear();
  for (const auto& line : lines) project_findings_.push_back(*line.finding);
  messages_.setFindings(std::move(lines));
  showRunFindings();
  Q_EMIT projectFindingsChanged();
}

std::vector<Message> Workspace::projectLines() const {
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
    auto finding = finding_of(result.error());
    finding.severity = Severity::kError;
    lines.back().finding = std::make_shared<const Finding>(std::move(finding));
  }
  for (const auto& finding : findingsOfEni()) {
    lines.push_back(messageOf(finding, document_.project()));
    lines.back().finding = std::make_shared<const Finding>(finding);
    if (finding.place.slave < 0) lines.back().source = tr("ENI");
  }
  return lines;
}

/// What the checker says of the ENI that would be exported as the project is now: while it is made anew, nothing.
void Workspace::showEniFindings() {
  const auto check = eni_.isCurrent() && !document_.project().slaves.empty() ? eni_.check() : nullptr;
  if (check == std::exchange(shown_check_, check)) return;
  showFindings();
}

void Workspace::tellOfExport(const std::vector<Finding>& wrong) {
  for (const auto& finding : wrong) {
    auto line = messageOf(finding, document_.project());
    line.time = QDateTime::currentDateTime();
    messages_.append(std::move(line));
  }
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
  inform(tr("Scan"), tr("%n slave(s) found on %1", nullptr, count).arg(linkName(link, environment().demo_link)));
}

}  // namespace syncline::ui
