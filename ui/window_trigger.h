// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace syncline {
struct TriggerEpisode;
}  // namespace syncline

namespace syncline::ui {

class LiveStrip;
class RecordingCommands;
class TriggerMonitor;
class TriggerPanel;

/// Ties the trigger to its panel and to the plots: what it finds moves them as its mode says.
class WindowTrigger final : public QObject {
  Q_OBJECT

 public:
  /// All but the last outlive it.
  WindowTrigger(TriggerMonitor& monitor, TriggerPanel& panel, LiveStrip& strip, RecordingCommands& recordings,
                QObject* parent);

 private:
  void show(const TriggerEpisode& episode, bool freeze);
  void showLevel();
  void moveLevel(double level);

  TriggerMonitor& monitor_;
  LiveStrip& strip_;
};

}  // namespace syncline::ui
