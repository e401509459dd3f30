// SPDX-License-Identifier: Apache-2.0
#include "ui/session/network_runs.h"

#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "record/run_record.h"
#include "trace/sync_overview.h"
#include "ui/session/project_document.h"
#include "ui/text/link_text.h"

namespace syncline::ui {

NetworkSession::NetworkSession(const Environment& environment,
                               const std::function<QString(const NetworkSession&)>& file_name, QObject* parent)
    : QObject(parent),
      run(environment.open_master),
      findings(run),
      disk(run, findings, environment),
      frames(
          run, [this, file_name] { return file_name(*this); }, environment),
      dcm_log(run, [this, file_name] { return file_name(*this); }) {}

NetworkRuns::NetworkRuns(ProjectDocument& document, const Environment& environment)
    : document_(document), environment_(environment), sessions_{make()}, shown_(sessions_.front()->run) {
  connect(&document, &ProjectDocument::machineReplaced, this, &NetworkRuns::replaceAll);
  connect(&document, &ProjectDocument::networkRemoved, this, [this](int network) {
    const auto at = sessions_.begin() + network;
    retire(**at);
    sessions_.erase(at);
    shown_at_ = sessions_.size();  // none, until the next one is chosen
  });
  connect(&document, &ProjectDocument::taken, this, &NetworkRuns::follow);
  connect(&document, &ProjectDocument::networksChanged, this, &NetworkRuns::tell);
}

NetworkSession* NetworkRuns::make() {
  auto* session = new NetworkSession(
      environment_, [this](const NetworkSession& of) { return fileName(of); }, this);
  session->frames.setWish(black_box_);
  session->disk.setMemoryMib(memory_mib_);
  (void)session->run.watch(watched_);
  listen(*session);
  return session;
}

void NetworkRuns::listen(NetworkSession& session) {
  auto* of = &session;
  const auto shown = [this, of] { return shown_at_ < sessions_.size() && of == sessions_[shown_at_]; };
  connect(&of->run, &NetworkRun::recordChanged, this, [this, of] {
    of_run_.push_back(of);
    of->number = static_cast<int>(of_run_.size());
  });
  connect(&of->run, &NetworkRun::phaseChanged, this, [this, of] { Q_EMIT phaseChanged(indexOf(*of)); });
  connect(&of->run, &NetworkRun::snapshotChanged, this, [this, of] { Q_EMIT snapshotChanged(indexOf(*of)); });
  connect(&of->run, &NetworkRun::samplesArrived, this, [this, of] {
    if (std::exchange(of->begun, of->number) != of->number)
      Q_EMIT begun(of->number, of->run.record()->overview().begin);
  });
  connect(&of->run, &NetworkRun::eventArrived, this,
          [this, of](const Event& event) { Q_EMIT eventArrived(indexOf(*of), event); });
  connect(&of->run, &NetworkRun::signSeen, this,
          [this, of](NetworkRun::Sign sign) { Q_EMIT signSeen(indexOf(*of), sign); });
  connect(&of->run, &NetworkRun::noteAdded, this,
          [this, of](const RunNote& note) { Q_EMIT noteAdded(indexOf(*of), note); });
  connect(&of->findings, &RunFindings::findingsChanged, this, [this, shown] {
    if (shown()) Q_EMIT findingsChanged();
  });
  connect(&of->disk, &DiskRecording::changed, this, [this, shown] {
    if (shown()) Q_EMIT diskChanged();
  });
  connect(&of->frames, &FrameKeeper::changed, this, [this, shown] {
    if (shown()) Q_EMIT diskChanged();
  });
  connect(&of->frames, &FrameKeeper::ended, this, &NetworkRuns::framesKept);
  connect(&of->dcm_log, &DcmLogKeeper::began, this, &NetworkRuns::dcmLogBegan);
  connect(&of->dcm_log, &DcmLogKeeper::ended, this, &NetworkRuns::dcmLogEnded);
  connect(&of->disk, &DiskRecording::ended, this, &NetworkRuns::recordingEnded);
  connect(&of->disk, &DiskRecording::saved, this, &NetworkRuns::stretchSaved);
}

int NetworkRuns::indexOf(const NetworkSession& session) const {
  const auto found = std::ranges::find(sessions_, &session);
  return found == sessions_.end() ? -1 : static_cast<int>(found - sessions_.begin());
}

/// Whoever looks at it is told of another one before it is gone; the disk gets what is meant for it.
void NetworkRuns::retire(NetworkSession& session) {
  auto* gone = &session;
  gone->run.shutDown();
  std::ranges::replace(of_run_, gone, nullptr);
  const auto end = [gone] {
    if (!gone->disk.isWriting() && !gone->frames.isWriting() && !gone->dcm_log.isWriting()) gone->deleteLater();
  };
  connect(&gone->disk, &DiskRecording::changed, gone, end);
  connect(&gone->disk, &DiskRecording::saved, gone, end);
  connect(&gone->frames, &FrameKeeper::changed, gone, end);
  connect(&gone->dcm_log, &DcmLogKeeper::ended, gone, end);
  end();
}

/// Nothing of a machine before is shown under another one, but the link is the desk's.
void NetworkRuns::replaceAll() {
  const auto before = std::exchange(sessions_, {make()});
  sessions_.front()->link = before.front()->link;
  shown_at_ = 0;
  shown_.show(sessions_.front()->run);
  other_ = true;
  tell();
  for (auto* session : before) retire(*session);
}

void NetworkRuns::follow() {
  while (sessions_.size() < static_cast<std::size_t>(document_.networks().size())) sessions_.push_back(make());
  const auto wanted = static_cast<std::size_t>(document_.network());
  if (wanted == shown_at_) return;
  shown_at_ = wanted;
  shown_.show(current().run);
  other_ = true;
}

void NetworkRuns::tell() {
  if (!std::exchange(other_, false)) return;
  shown_.tellShown();
  Q_EMIT findingsChanged();
  Q_EMIT diskChanged();
  Q_EMIT linkChanged();
}

void NetworkRuns::setLink(const QString& link) {
  if (std::exchange(current().link, link) != link) Q_EMIT linkChanged();
}

Status NetworkRuns::watch(const std::vector<VariableName>& names) {
  watched_ = names;
  Status status;
  for (auto* session : sessions_) {
    if (auto taken = session->run.watch(names); !taken) status = std::move(taken);
  }
  return status;
}

int NetworkRuns::userOf(const QString& link) const {
  const auto uses = [&](const NetworkSession* session) {
    return session != &current() && session->run.phase() != NetworkRun::Phase::kOffline && session->run.link() == link;
  };
  if (!isAdapter(link)) return -1;
  const auto found = std::ranges::find_if(sessions_, uses);
  return found == sessions_.end() ? -1 : static_cast<int>(found - sessions_.begin());
}

int NetworkRuns::networkOf(int run) const {
  const auto at = static_cast<std::size_t>(run) - 1;
  return run <= 0 || at >= of_run_.size() || of_run_[at] == nullptr ? -1 : indexOf(*of_run_[at]);
}

void NetworkRuns::setBlackBox(const BlackBoxWish& wish) {
  black_box_ = wish;
  for (auto* session : sessions_) session->frames.setWish(wish);
}

void NetworkRuns::setMemoryMib(int mib) {
  memory_mib_ = mib;
  for (auto* session : sessions_) session->disk.setMemoryMib(mib);
}

/// The file of what runs, and which of its networks where it has several.
QString NetworkRuns::fileName(const NetworkSession& session) const {
  const QFileInfo file(session.run.origin().path);
  const auto base = file.fileName().isEmpty() ? QStringLiteral("machine") : file.completeBaseName();
  const auto names = document_.networks();
  const auto network = indexOf(session);
  return names.size() < 2 || network < 0 ? base : QStringLiteral("%1-%2").arg(base, names[network]);
}

bool NetworkRuns::any() const {
  return std::ranges::any_of(sessions_,
                             [](const auto* session) { return session->run.phase() != NetworkRun::Phase::kOffline; });
}

bool NetworkRuns::givenUp() const {
  return std::ranges::any_of(sessions_, [](const auto* session) { return session->run.givenUp(); });
}

void NetworkRuns::goOffline() {
  for (auto* session : sessions_) session->run.goOffline();
}

void NetworkRuns::shutDown() {
  goOffline();  // all at once, and then each is waited for
  for (auto* session : sessions_) session->run.shutDown();
}

void NetworkRuns::finish() {
  for (auto* session : findChildren<NetworkSession*>(Qt::FindDirectChildrenOnly)) {
    session->disk.finish();
    session->frames.finish();
    session->dcm_log.finish();
  }
}

}  // namespace syncline::ui
