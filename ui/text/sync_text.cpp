// SPDX-License-Identifier: Apache-2.0
#include "ui/text/sync_text.h"

#include <QCoreApplication>

#include "trace/slaves_standing.h"
#include "ui/text/glossary.h"

namespace syncline::ui {
namespace {

QString offline() { return QCoreApplication::translate("Sync", "Offline"); }

}  // namespace

theme::Tone syncTone(SyncState state) {
  switch (state) {
    case SyncState::kInSync:
      return theme::Tone::kGood;
    case SyncState::kOutOfSync:
      return theme::Tone::kBad;
    case SyncState::kBusy:
      return theme::Tone::kBusy;
    case SyncState::kUnknown:
      return theme::Tone::kWarning;
    case SyncState::kNotMonitored:
    case SyncState::kNotReady:
      break;
  }
  return theme::Tone::kNeutral;
}

StateText slavesSync(const Snapshot& snapshot) {
  if (!snapshot.online) return {theme::Tone::kNeutral, offline()};
  if (!snapshot.dc.enabled) return {theme::Tone::kNeutral, QCoreApplication::translate("Sync", "DC off")};
  return {syncTone(snapshot.dc.state), syncStateText(snapshot.dc.state)};
}

StateText withSilent(StateText verdict, const std::optional<SlavesStanding>& standing) {
  if (!standing || standing->silent_followers == 0) return verdict;
  const auto count = static_cast<int>(standing->silent_followers);
  return {theme::Tone::kBad,
          QCoreApplication::translate("Sync", "%n of %1 do(es) not answer", nullptr, count).arg(standing->followers)};
}

StateText masterSync(const Snapshot& snapshot) {
  if (!snapshot.online) return {theme::Tone::kNeutral, offline()};
  if (snapshot.dcm.mode == DcmMode::kOff) return {theme::Tone::kNeutral, dcmModeText(DcmMode::kOff)};
  const auto text = syncStateText(snapshot.dcm.state);
  // On the way to in sync the obstacle is the way itself.
  if (snapshot.dcm.state != SyncState::kOutOfSync || snapshot.dcm.obstacle == dc::SyncObstacle::kNone) {
    return {syncTone(snapshot.dcm.state), text};
  }
  return {syncTone(snapshot.dcm.state),
          QCoreApplication::translate("Sync", "%1: %2").arg(text, obstacleText(snapshot.dcm.obstacle))};
}

}  // namespace syncline::ui
