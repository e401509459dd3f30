// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/machine_draft.h"

#include <QFileInfo>
#include <utility>

#include "config/slave_edits.h"
#include "recover/recover_project.h"
#include "ui/dialogs/slave_commands.h"
#include "ui/session/eni_machine.h"
#include "ui/text/error_text.h"
#include "ui/text/link_text.h"

namespace syncline::ui {
namespace {

/// Nothing of a draft is kept on the disk, and it has no machine to run.
Environment draftOf(Environment environment) {
  environment.recovery_folder.clear();
  environment.settings_file.clear();
  environment.eeprom_repairs = {};
  return environment;
}

}  // namespace

MachineDraft::MachineDraft(Workspace& window, QObject* parent)
    : QObject(parent), window_(window), draft_(draftOf(window.environment())) {
  draft_.setExpert(window.expert());
  auto& scan = draft_.scan();
  connect(&scan, &ScanController::progress, this,
          [this](int done, int found) { Q_EMIT told(tr("Reading slave %1 of %2").arg(done).arg(found), false); });
  connect(&scan, &ScanController::finished, this, [this](const QString& link, const ScanOutcome& outcome) {
    scanning_ = false;
    looked_at_ = outcome.looked_only ? static_cast<int>(outcome.running) : 0;
    take(outcome.built.project);
    Q_EMIT told(tr("%n slave(s) found on %1", nullptr, static_cast<int>(project().slaves.size()))
                    .arg(linkName(link, draft_.environment().demo_link)),
                false);
    Q_EMIT scanChanged();
  });
  connect(&scan, &ScanController::failed, this, [this](const QString&, const Error& error) {
    scanning_ = false;
    if (error.code == ErrorCode::kCancelled) {
      Q_EMIT told(tr("The scan was cancelled; the slaves are those of before."), false);
    } else {
      tellError(error);
    }
    Q_EMIT scanChanged();
  });
}

void MachineDraft::scan(const QString& link) {
  if (link.isEmpty() || scanning_) return;
  const bool in_work = window_.live().phase() != LiveSession::Phase::kOffline && link == window_.link();
  if (in_work || window_.runs().userOf(link) >= 0) {
    Q_EMIT told(tr("The machine of the window runs on this bus. Go offline first, or choose another bus."), true);
    return;
  }
  scanning_ = true;
  looked_at_ = 0;
  Q_EMIT told(tr("Looking for slaves…"), false);
  Q_EMIT scanChanged();
  draft_.scan().start(link);
}

void MachineDraft::scanFully() {
  if (link().isEmpty() || scanning_) return;
  scanning_ = true;
  Q_EMIT scanChanged();
  draft_.scan().start(link(), ScanController::Depth::kTouch);
}

void MachineDraft::cancelScan() { draft_.scan().cancel(); }

/// Slaves come; the master stays as it was set, but for a reference clock that was one of the slaves before.
void MachineDraft::take(Project project) {
  const auto& before = this->project();
  if (before != Project{}) {
    project.master = before.master;
    project.master.dc.reference_clock.reset();
    project.name = before.name;
  }
  draft_.document().take(Machine{{}, {std::move(project)}}, {}, false);
}

void MachineDraft::readEni(const QString& path) {
  const auto generation = draft_.document().generation();
  const auto status = readEniMachine(path, catalogue(), this, [this, path, generation](RecoveredProject recovered) {
    if (draft_.document().generation() != generation) return;  // other slaves were taken since
    master_is_given_ = true;
    draft_.document().take(Machine{{}, {std::move(recovered.project)}}, {}, false);
    draft_.eni().setDialect(recovered.dialect);
    Q_EMIT told(tr("A project was made of %1; exported again, %n command(s) would differ.", nullptr,
                   static_cast<int>(recovered.differences.size()))
                    .arg(QFileInfo(path).fileName()),
                false);
  });
  if (!status) tellError(status.error());
}

void MachineDraft::readProject(const QString& path) {
  auto machine = ProjectDocument::read(path);
  if (!machine) return tellError(machine.error());
  master_is_given_ = true;
  draft_.document().take(std::move(*machine), {}, false);
  Q_EMIT told(
      tr("%n slave(s) as in %1", nullptr, static_cast<int>(project().slaves.size())).arg(QFileInfo(path).fileName()),
      false);
}

void MachineDraft::add(const eni::CatalogueEntry& device) {
  const auto generation = draft_.document().generation();
  catalogue().read(device, this, [this, generation](const Result<DeviceDescription>& read) {
    if (draft_.document().generation() != generation) return;  // other slaves were taken since
    if (!read) return tellError(read.error());
    EditedSlave added = tl::unexpected(WiringObstacle::kNoSuchSlave);
    const auto status = draft_.document().edit(tr("Add a slave"), [&](Project& project) -> Status {
      added = add_slave(project, *read, {});
      return added ? Status{} : Status(fail(ErrorCode::kConfiguration));
    });
    Q_EMIT told(status ? tr("%1 was added.").arg(QString::fromStdString(read->type)) : obstacleText(added.error()),
                !status);
  });
}

void MachineDraft::remove(int slave) {
  static_cast<void>(draft_.document().edit(tr("Remove a slave"), [slave](Project& project) -> Status {
    return remove_slave(project, static_cast<std::size_t>(slave)) ? Status{} : Status(fail(ErrorCode::kConfiguration));
  }));
}

void MachineDraft::tellError(const Error& error) { Q_EMIT told(errorText(error), true); }

}  // namespace syncline::ui
