// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/status_panel.h"

#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QStatusBar>
#include <QStorageInfo>
#include <algorithm>
#include <utility>

#include "trace/slaves_standing.h"
#include "ui/panels/run_state.h"
#include "ui/session/workspace.h"
#include "ui/text/black_box_text.h"
#include "ui/text/glossary.h"
#include "ui/text/link_text.h"
#include "ui/text/recorded_text.h"
#include "ui/text/sync_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr int kLeastCharacters = 10;  // of the long fields in a narrow window; the others are whole

}  // namespace

StatusPanel::StatusPanel(Workspace& workspace, QStatusBar& bar) : QObject(&bar), workspace_(workspace) {
  bar.setSizeGripEnabled(false);
  bar.setContentsMargins(6, 0, 6, 0);
  phase_ = addState(bar, "statusPhase", tr("Connection"), tr("Whether the master runs, and the link carries frames"));
  link_ = addField(bar, "statusLink", tr("Link"), tr("What the bus is connected through"));
  slaves_ = addField(bar, "statusSlaves", tr("Slaves"), tr("Slaves in the master's state, of all configured"));
  recording_ = addState(bar, "statusRecording", tr("Recording"), {});
  black_box_ = addState(bar, "statusBlackBox", tr("Black box"), {});
  forced_ = addState(bar, "statusForced", tr("Forced outputs"),
                     tr("Outputs that somebody holds at a value by hand: the page Variables releases them"));
  others_ = addState(bar, "statusOthers", tr("Other networks"), {});
  auto* gap = new QLabel;
  bar.addWidget(gap, 1);
  dc_ = addState(bar, "statusDc", tr("Slaves in sync"),
                 tr("Sync window of register 0x092C over all slaves that follow the reference clock"));
  dcm_ = addState(bar, "statusDcm", tr("Master in sync"),
                  tr("Master synchronisation: error against its limit, late frames, cycles left out"));
  drift_ = addField(bar, "statusDrift", tr("Drift"), tr("Reference clock's rate against the host's"));
  cycle_ = addField(bar, "statusCycle", tr("Cycle time"), tr("Bus cycle"));
  losses_ = addField(bar, "statusLosses", tr("Lost frames, late frames, cycles left out"),
                     tr("Frames that did not come back, or came after their cycle; cycles that the host came too late "
                        "for; samples the display could not take"));
  for (auto* label : {link_, losses_}) static_cast<ValueLabel*>(label)->setLeastCharacters(kLeastCharacters);
  connect(&workspace.live(), &LiveSession::snapshotChanged, this, &StatusPanel::refresh);
  connect(&workspace.live(), &LiveSession::phaseChanged, this, &StatusPanel::refresh);
  connect(&workspace.runs(), &NetworkRuns::phaseChanged, this, &StatusPanel::showOthers);
  connect(&workspace.runs(), &NetworkRuns::snapshotChanged, this, &StatusPanel::showOthers);
  connect(&workspace.document(), &ProjectDocument::networksChanged, this, &StatusPanel::showOthers);
  connect(&workspace.recording(), &OpenedRecording::changed, this, &StatusPanel::refresh);
  connect(&workspace.replay(), &RecordingReplay::moved, this, &StatusPanel::refresh);
  connect(&workspace.runs(), &NetworkRuns::diskChanged, this, &StatusPanel::refresh);
  connect(&workspace.runs(), &NetworkRuns::linkChanged, this, &StatusPanel::refresh);
  connect(&workspace.document(), &ProjectDocument::projectChanged, this, &StatusPanel::refresh);
  refresh();
  showOthers();
}

QLabel* StatusPanel::addField(QStatusBar& bar, const char* object_name, const QString& accessible,
                              const QString& tool_tip) {
  auto* label = named(new ValueLabel, object_name, accessible);
  label->setToolTip(tool_tip);
  label->setContentsMargins(6, 0, 6, 0);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  bar.addWidget(label);
  return label;
}

Pill* StatusPanel::addState(QStatusBar& bar, const char* object_name, const QString& accessible,
                            const QString& tool_tip) {
  auto* pill = named(new Pill, object_name, accessible);
  pill->setToolTip(tool_tip);
  bar.addWidget(pill);
  return pill;
}

void StatusPanel::refresh() {
  const bool recorded = workspace_.recording().isOpen();
  recorded ? showRecorded() : showLive();
  forced_->setVisible(!recorded && workspace_.live().snapshot().forced_bits > 0);
  showRecording();
  showBlackBox();
}

/// What the recording says at the moment that is shown; what it does not tell is a dash.
void StatusPanel::showRecorded() {
  const auto& record = *workspace_.recording().run().record;
  const auto& overview = record.overview();
  phase_->setState(theme::Tone::kBusy, tr("Recording"));
  const auto path = workspace_.recording().path();
  link_->setText(QFileInfo(path).fileName());
  link_->setToolTip(path);
  const auto standing = slaves_standing(record.config(), record.samples(), overview);
  if (standing) {
    slaves_->setText(tr("Slaves %1/%2 %3").arg(standing->in_op).arg(standing->slaves).arg(stateName(AlState::kOp)));
  } else {
    const auto count = record.config().slaves.size();
    slaves_->setText(count == 0 ? tr("Slaves %1").arg(noText()) : tr("%n slave(s)", nullptr, static_cast<int>(count)));
  }
  showSlavesSync({syncTone(overview.slaves.state), syncStateText(overview.slaves.state)}, standing);
  dcm_->setState(syncTone(overview.master.state), tr("DCM: %1").arg(syncStateText(overview.master.state)));
  const auto told = [&](Signal signal) { return record.samples().value(signal, overview.end); };
  const auto drift = told(Signal::kDrift);
  drift_->setText(tr("Drift %1").arg(drift ? ppmText(static_cast<double>(drift->value)) : noText()));
  const auto cycle = record.limits().cycle_time;
  cycle_->setText(tr("Cycle %1").arg(cycle > 0 ? cycleText(cycle) : noText()));
  const auto count = [&](Signal signal) {
    const auto reading = told(signal);
    return reading ? countText(static_cast<std::uint64_t>(reading->value)) : noText();
  };
  showLosses(count(Signal::kLostFrames), count(Signal::kLateFrames), count(Signal::kLeftOutCycles), {});
}

void StatusPanel::showSlavesSync(StateText verdict, const std::optional<SlavesStanding>& standing) {
  const auto dc = withSilent(std::move(verdict), standing);
  dc_->setState(dc.tone, tr("DC: %1").arg(dc.text));
}

void StatusPanel::showLive() {
  const auto& live = workspace_.live();
  const auto& snapshot = live.snapshot();
  const auto& project = workspace_.document().project();
  const auto phase = phaseText(workspace_.live().run());
  phase_->setState(phase.tone, phase.text);
  const auto link = workspace_.link();
  link_->setText(link.isEmpty() ? tr("No link chosen") : linkName(link, workspace_.environment().demo_link));
  link_->setToolTip(link.isEmpty() ? tr("A link is chosen when scanning or going online") : link);
  if (snapshot.online) {
    const auto in_state = std::ranges::count_if(snapshot.slaves, [&](const SlaveStatus& slave) {
      return slave.present && al_state_of(slave.al_status) == snapshot.requested;
    });
    slaves_->setText(
        tr("Slaves %1/%2 %3").arg(in_state).arg(snapshot.slaves.size()).arg(stateName(snapshot.requested)));
  } else {
    slaves_->setText(tr("%n slave(s)", nullptr, static_cast<int>(project.slaves.size())));
  }
  const auto* record = live.record();
  const auto standing = record != nullptr && snapshot.online
                            ? slaves_standing(record->config(), record->samples(), record->overview())
                            : std::nullopt;
  showSlavesSync(slavesSync(snapshot), standing);
  const auto dcm = masterSync(snapshot);
  dcm_->setState(dcm.tone, tr("DCM: %1").arg(dcm.text));
  const bool drifting = snapshot.online && snapshot.dcm.mode != DcmMode::kOff;
  drift_->setText(tr("Drift %1").arg(drifting ? ppmText(snapshot.dcm.drift_ppm) : QStringLiteral("\u2013")));
  cycle_->setText(tr("Cycle %1").arg(cycleText(snapshot.online ? snapshot.cycle_time : project.master.cycle_time)));
  const auto dropped = live.droppedSamples();
  showLosses(countText(snapshot.lost_frames), countText(snapshot.late_frames), countText(snapshot.skipped_cycles),
             dropped > 0 ? countText(dropped) : QString());
  forced_->setState(theme::Tone::kWarning, tr("%n bit(s) forced", nullptr, static_cast<int>(snapshot.forced_bits)));
}

/// In a narrow window the figures alone, in the same order: the tool tip names them.
void StatusPanel::showLosses(const QString& lost, const QString& late, const QString& left_out,
                             const QString& dropped) {
  auto text = tr("Lost %1  Late %2  Left out %3").arg(lost, late, left_out);
  QStringList figures{lost, late, left_out};
  if (!dropped.isEmpty()) {
    text += tr("  Dropped %1").arg(dropped);
    figures << dropped;
  }
  static_cast<ValueLabel*>(losses_)->setText(text, figures.join(QStringLiteral(" / ")));
}

/// What goes on where nobody looks: with one network its state, with more how many and the gravest tone.
void StatusPanel::showOthers() {
  const auto names = workspace_.document().networks();
  QStringList lines;
  auto tone = theme::Tone::kNeutral;
  for (int i = 0; i < names.size() && i < workspace_.runs().count(); ++i) {
    const auto& run = workspace_.runs().of(i).run;
    if (i == workspace_.document().network() || run.phase() == NetworkRun::Phase::kOffline) continue;
    lines << networkText(names[i], run);
    tone = std::max(tone, runState(run).tone);
  }
  others_->setVisible(!lines.isEmpty());
  if (lines.isEmpty()) return;
  others_->setState(tone, lines.size() == 1
                              ? lines.front()
                              : tr("%n other network(s) online", nullptr, static_cast<int>(lines.size())));
  others_->setToolTip(tr("Networks that run beside the one in work:") + u'\n' + lines.join(u'\n'));
}

/// While the last frames are kept: of how much time; where they are not any more though they should, that.
void StatusPanel::showBlackBox() {
  const auto& frames = workspace_.runs().current().frames;
  const bool runs = workspace_.live().phase() != LiveSession::Phase::kOffline;
  const auto report = frames.report();
  const bool failed = runs && report.error;
  black_box_->setVisible(frames.isKeeping() || failed);
  if (black_box_->isHidden()) return;
  if (failed) {
    black_box_->setState(theme::Tone::kBad, tr("Black box ended"));
  } else {
    black_box_->setState(report.lost > 0 ? theme::Tone::kWarning : theme::Tone::kBusy,
                         tr("Black box %1").arg(spanText(report.end - report.begin)));
  }
  black_box_->setToolTip(blackBoxText(report));
}

/// While a file is written: for how long, its size, and what the disk has left.
void StatusPanel::showRecording() {
  const auto& disk = workspace_.disk();
  recording_->setVisible(disk.isRecording());
  if (!disk.isRecording()) return;
  recording_->setState(disk.lostSamples() > 0 ? theme::Tone::kWarning : theme::Tone::kBusy,
                       tr("Recording %1").arg(spanText(disk.duration())));
  // The disk is asked once a second.
  const auto second = disk.duration() / kSecond;
  if (second == shown_second_ && !recording_->toolTip().isEmpty()) return;
  shown_second_ = second;
  const QLocale locale;
  auto tip = tr("%1\n%2 written, %3 left on the disk")
                 .arg(disk.path(), locale.formattedDataSize(disk.bytes()),
                      locale.formattedDataSize(QStorageInfo(QFileInfo(disk.path()).path()).bytesAvailable()));
  if (disk.lostSamples() > 0)
    tip += tr("\n%1 cycles are missing in it: the disk was too slow").arg(countText(disk.lostSamples()));
  recording_->setToolTip(tip);
}

}  // namespace syncline::ui
