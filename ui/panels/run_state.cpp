// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/run_state.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/session/network_run.h"
#include "ui/text/glossary.h"
#include "ui/text/sync_text.h"

namespace syncline::ui {
namespace {

QString phrase(const char* text) { return QCoreApplication::translate("RunState", text); }

bool allAsWanted(const Snapshot& snapshot) {
  return snapshot.state == snapshot.requested && std::ranges::all_of(snapshot.slaves, [&](const SlaveStatus& slave) {
           return slave.present && al_state_of(slave.al_status) == snapshot.requested;
         });
}

}  // namespace

StateText phaseText(const NetworkRun& run) {
  switch (run.phase()) {
    case NetworkRun::Phase::kOffline:
      return {theme::Tone::kNeutral, phrase(QT_TRANSLATE_NOOP("RunState", "Offline"))};
    case NetworkRun::Phase::kStarting:
      return {theme::Tone::kBusy, phrase(QT_TRANSLATE_NOOP("RunState", "Starting"))};
    case NetworkRun::Phase::kSilent:
      return {theme::Tone::kBad, phrase(QT_TRANSLATE_NOOP("RunState", "No answer"))};
    case NetworkRun::Phase::kStopping:
      return {theme::Tone::kBusy, phrase(QT_TRANSLATE_NOOP("RunState", "Stopping"))};
    case NetworkRun::Phase::kOnline:
      break;
  }
  return {run.snapshot().link_up ? theme::Tone::kGood : theme::Tone::kBad,
          phrase(QT_TRANSLATE_NOOP("RunState", "Online"))};
}

StateText runState(const NetworkRun& run) {
  if (run.phase() == NetworkRun::Phase::kOffline) return {};
  if (run.phase() != NetworkRun::Phase::kOnline) return phaseText(run);
  const auto& snapshot = run.snapshot();
  if (!snapshot.link_up) return {theme::Tone::kBad, phrase(QT_TRANSLATE_NOOP("RunState", "no link"))};
  const bool as_wanted = allAsWanted(snapshot);
  StateText state{as_wanted ? theme::Tone::kGood : theme::Tone::kWarning, stateName(snapshot.state)};
  // Without the obstacle: that is told where the network is looked at.
  const auto add = [&state](SyncState sync, const char* what) {
    const auto tone = syncTone(sync);
    if (tone != theme::Tone::kBad && tone != theme::Tone::kWarning) return;
    state.tone = std::max(state.tone, tone);
    state.text += QStringLiteral(", ") + phrase(what).arg(syncStateText(sync));
  };
  if (snapshot.dc.enabled) add(snapshot.dc.state, QT_TRANSLATE_NOOP("RunState", "DC: %1"));
  if (snapshot.dcm.mode != DcmMode::kOff) add(snapshot.dcm.state, QT_TRANSLATE_NOOP("RunState", "DCM: %1"));
  // Whoever forgets them here finds nobody who tells him: the page that releases them is the other network's.
  if (snapshot.forced_bits > 0) {
    state.tone = std::max(state.tone, theme::Tone::kWarning);
    state.text += QStringLiteral(", ") + phrase(QT_TRANSLATE_NOOP("RunState", "outputs forced"));
  }
  return state;
}

QString networkText(const QString& name, const NetworkRun& run) {
  const auto state = runState(run).text;
  return state.isEmpty() ? name : phrase(QT_TRANSLATE_NOOP("RunState", "%1: %2")).arg(name, state);
}

}  // namespace syncline::ui
