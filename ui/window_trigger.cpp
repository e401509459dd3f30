// SPDX-License-Identifier: Apache-2.0
#include "ui/window_trigger.h"

#include <algorithm>
#include <optional>

#include "record/run_record.h"
#include "ui/dialogs/recording_commands.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/trigger_panel.h"
#include "ui/session/trigger_monitor.h"

namespace syncline::ui {

WindowTrigger::WindowTrigger(TriggerMonitor& monitor, TriggerPanel& panel, LiveStrip& strip,
                             RecordingCommands& recordings, QObject* parent)
    : QObject(parent), monitor_(monitor), strip_(strip) {
  connect(&panel, &TriggerPanel::episodeWanted, this, [this](const TriggerEpisode& episode) { show(episode, false); });
  connect(&panel, &TriggerPanel::csvWanted, &strip, &LiveStrip::exportRange);
  connect(&panel, &TriggerPanel::saveWanted, &recordings, &RecordingCommands::saveRange);
  connect(&monitor, &TriggerMonitor::changed, this, &WindowTrigger::showLevel);
  connect(&strip, &LiveStrip::triggerLevelDragged, this, &WindowTrigger::moveLevel);
  connect(&monitor, &TriggerMonitor::completed, this, [this](const TriggerEpisode& episode) {
    // A recording that opens, and a run that comes up, are looked at as they are; the list has what was found in them.
    const auto* record = monitor_.record();
    if (monitor_.isRecorded() || record == nullptr || !record->overview().armed ||
        episode.time < *record->overview().armed)
      return;
    const auto mode = monitor_.trigger().mode;
    if (mode != Trigger::Mode::kAutomatic) show(episode, mode == Trigger::Mode::kSingle);
  });
}

void WindowTrigger::show(const TriggerEpisode& episode, bool freeze) {
  strip_.showRange(episode.from, episode.to, episode.time, freeze);
}

void WindowTrigger::showLevel() {
  const auto& trigger = monitor_.trigger();
  const bool level = monitor_.isArmed() && trigger.kind == Trigger::Kind::kLevel;
  auto place = static_cast<std::size_t>(std::max(trigger.slave, 0));
  if (trigger.signal == Signal::kVariable && monitor_.record() != nullptr) {
    const auto& there = monitor_.record()->watched().variables();
    place =
        static_cast<std::size_t>(std::ranges::find(there, trigger.variable, &WatchedVariable::name) - there.begin());
  }
  strip_.setTriggerLevel({trigger.signal, place, level ? std::optional(trigger.level) : std::nullopt});
}

void WindowTrigger::moveLevel(double level) {
  auto trigger = monitor_.trigger();
  trigger.level = level;
  monitor_.setTrigger(trigger);
}

}  // namespace syncline::ui
