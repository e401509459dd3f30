// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace syncline::ui {

class FindingsPanel;
class LiveStrip;
class OverviewPanel;
class Workspace;

/// Brings the moment of a recording that is replayed into the plots, the overview, the findings and the trigger.
class WindowReplay final : public QObject {
  Q_OBJECT

 public:
  WindowReplay(Workspace& workspace, LiveStrip& strip, OverviewPanel& overview, FindingsPanel& findings,
               QObject* parent);

 private:
  void showMoment(bool back);
  void showFound();

  Workspace& workspace_;
  LiveStrip& strip_;
  OverviewPanel& overview_;
  FindingsPanel& findings_;
  bool untold_ = false;
};

}  // namespace syncline::ui
