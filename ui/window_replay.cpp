// SPDX-License-Identifier: Apache-2.0
#include "ui/window_replay.h"

#include <utility>

#include "ui/panels/findings_panel.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overview_panel.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

WindowReplay::WindowReplay(Workspace& workspace, LiveStrip& strip, OverviewPanel& overview, FindingsPanel& findings,
                           QObject* parent)
    : QObject(parent), workspace_(workspace), strip_(strip), overview_(overview), findings_(findings) {
  auto& replay = workspace_.replay();
  connect(&replay, &RecordingReplay::moved, this, &WindowReplay::showMoment);
  connect(&replay, &RecordingReplay::changed, this, &WindowReplay::showFound);
  connect(&strip_, &LiveStrip::momentWanted, &replay, &RecordingReplay::seek);
  connect(&strip_, &LiveStrip::escaped, &replay, &RecordingReplay::leave);
}

void WindowReplay::showMoment(bool back) {
  const auto& replay = workspace_.replay();
  if (back) workspace_.trigger().setBack();
  strip_.showMoment(back);
  showFound();
  // While it plays it has a tick of its own: faster cannot be read.
  if (!replay.isPlaying()) overview_.refresh();
}

/// Of moments before the end nothing is found yet.
void WindowReplay::showFound() {
  const auto& replay = workspace_.replay();
  const bool untold = replay.isActive() && !replay.isAtEnd();
  if (untold == std::exchange(untold_, untold)) return;
  findings_.setUntold(untold);
  overview_.setFindings(workspace_.shownFindings());
}

}  // namespace syncline::ui
