// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QInputDialog>
#include <QMenu>

#include "ui/dialogs/limits_dialog.h"
#include "ui/panels/free_view.h"
#include "ui/panels/live_strip.h"
#include "ui/text/typed_value.h"
#include "ui/text/units.h"

namespace syncline::ui {

QString LiveStrip::figures() const {
  QStringList lines{TracePanel::figureHeads().join(u'\t')};
  for (const auto* panel : shownPanels()) {
    if (panel->isVisibleTo(this)) lines << panel->figures();
  }
  return lines.join(u'\n') + u'\n';
}

/// The first cursor stays, the other one goes so far from it.
void LiveStrip::askForDistance() {
  if (!cursors_.at(CursorSet::kA)) cursors_.set(CursorSet::kA, view_.begin() + view_.span() / 3);
  const auto before = cursors_.both() ? cursors_.delta() : view_.span() / 3;
  QInputDialog dialog(this);
  dialog.setObjectName(QStringLiteral("cursorDistanceDialog"));
  dialog.setWindowTitle(tr("Distance of the Cursors"));
  dialog.setLabelText(tr("From A to B, such as 12.5 ms, 250 us, -1 s, or 50 Hz:"));
  dialog.setTextValue(timeText(before));
  while (dialog.exec() == QDialog::Accepted) {
    if (const auto distance = typedDistance(dialog.textValue())) {
      cursors_.set(CursorSet::kB, *cursors_.at(CursorSet::kA) + *distance);
      return;
    }
    dialog.setLabelText(tr("That is no time. A number with ns, us, ms, s or Hz:"));
  }
}

void LiveStrip::askForLimit(TracePanel& panel) {
  const auto signal = panel.limitSignal();
  if (!signal) return;
  QInputDialog dialog(this);
  dialog.setObjectName(QStringLiteral("plotLimitDialog"));
  dialog.setWindowTitle(tr("Limit"));
  dialog.setLabelText(tr("Limit in the project, such as 127 ns or 4 us. The sync window takes the nearest 2ⁿ − 1 ns."));
  dialog.setTextValue(timeText(static_cast<Nanoseconds>(panel.plot()->limit())));
  while (dialog.exec() == QDialog::Accepted) {
    const auto limit = typedTime(dialog.textValue());
    if (limit && *limit > 0) return Q_EMIT limitWanted(*signal, static_cast<double>(*limit));
    dialog.setLabelText(tr("That is no limit. A number above zero with ns, us or ms:"));
  }
}

void LiveStrip::addCursorActions(QMenu& menu, Nanoseconds time) {
  menu.addAction(tr("Cursor A here"), this, [this, time] { cursors_.set(CursorSet::kA, time); });
  menu.addAction(tr("Cursor B here"), this, [this, time] { cursors_.set(CursorSet::kB, time); });
  auto* distance = menu.addAction(tr("Distance of the cursors…"), this, &LiveStrip::askForDistance);
  distance->setObjectName(QStringLiteral("actionCursorDistance"));
  distance->setEnabled(hasSamples());
  auto* held = menu.addAction(tr("Cursors stay on the screen"), this, [this](bool on) { cursors_.setHeld(on); });
  held->setObjectName(QStringLiteral("actionCursorsHeld"));
  held->setCheckable(true);
  held->setChecked(cursors_.held());
  menu.addAction(tr("Remove cursors"), this, [this] { cursors_.clear(); })->setEnabled(cursors_.any());
}

/// Of all plots: how moments are told.
void LiveStrip::addAxisActions(QMenu& menu) {
  using Notation = TimeView::Notation;
  auto* times = menu.addMenu(tr("Time axis"));
  times->setObjectName(QStringLiteral("timeAxisMenu"));
  auto* group = new QActionGroup(times);
  for (const auto& [notation, text] :
       {std::pair{Notation::kBeforeNow, tr("Before now, or since the start")},
        std::pair{Notation::kSinceStart, tr("Since the start")}, std::pair{Notation::kUtc, tr("Time of day (UTC)")},
        std::pair{Notation::kCycle, tr("Number of the cycle")},
        std::pair{Notation::kDcTime, tr("System time of the reference clock")}}) {
    auto* action = times->addAction(text, this, [this, notation = notation] { view_.setNotation(notation); });
    action->setCheckable(true);
    action->setChecked(view_.notation() == notation);
    group->addAction(action);
  }
}

/// Of one plot.
void LiveStrip::addSlaveCounts(QMenu& menu, TracePanel& panel) {
  if (panel.slavesShown() == 0) return;
  auto* counts = menu.addMenu(tr("Slaves that are drawn"));
  counts->setObjectName(QStringLiteral("slavesShownMenu"));
  auto* group = new QActionGroup(counts);
  for (int count = 1; count <= TracePanel::kMostSlaves; ++count) {
    auto* action = counts->addAction(count == 1 ? tr("The worst one") : tr("The worst %1").arg(count), &panel,
                                     [this, &panel, count] {
                                       panel.setSlavesShown(count);
                                       Q_EMIT slavesShownChosen(panel.objectName(), count);
                                     });
    action->setCheckable(true);
    action->setChecked(panel.slavesShown() == count);
    group->addAction(action);
  }
}

void LiveStrip::addPlotActions(QMenu& menu, TracePanel& panel) {
  const auto& left = panel.plot()->axis(TracePlot::kLeft);
  auto* scales = menu.addMenu(tr("Value scale of this plot"));
  scales->setObjectName(QStringLiteral("valueScaleMenu"));
  auto* group = new QActionGroup(scales);
  for (const auto& [scale, text] :
       {std::pair{ValueScale::kLinear, tr("Linear")}, std::pair{ValueScale::kSignedLog, tr("Signed logarithmic")},
        std::pair{ValueScale::kLog, tr("Logarithmic")}}) {
    auto* action = scales->addAction(text, &panel, [&panel, scale = scale] { panel.setScale(scale); });
    action->setCheckable(true);
    action->setChecked(left.scale() == scale);
    group->addAction(action);
  }
  addSlaveCounts(menu, panel);
  auto* limits = menu.addAction(tr("Value limits of this plot…"), &panel, [&panel] {
    LimitsDialog dialog(panel, panel.window());
    dialog.exec();
  });
  limits->setObjectName(QStringLiteral("actionValueLimits"));
  auto* limit = menu.addAction(tr("Limit in the project…"), &panel, [this, &panel] { askForLimit(panel); });
  limit->setObjectName(QStringLiteral("actionPlotLimit"));
  limit->setEnabled(panel.plot()->limitMovable());
  auto* own = menu.addAction(tr("Own time axis of this plot"), &panel, [&panel](bool on) { panel.setOwnTime(on); });
  own->setObjectName(QStringLiteral("actionOwnTime"));
  own->setCheckable(true);
  own->setChecked(panel.plot()->hasOwnTime());
}

/// Of what lies over the plots, and of the replay.
void LiveStrip::addRecordingActions(QMenu& menu, Nanoseconds time) {
  if (const auto& overlay = panels_.front()->overlay(); overlay.record != nullptr) {
    const auto cursor = cursors_.at(CursorSet::kA);
    auto* lay = menu.addAction(tr("Lay this moment of %1 on cursor A").arg(overlay.other), this,
                               [this, by = cursor.value_or(time) - time] { Q_EMIT overlayMoved(by); });
    lay->setObjectName(QStringLiteral("actionOverlayOnCursor"));
    lay->setEnabled(cursor.has_value());
  }
  if (!recorded_) return;
  auto* moment = menu.addAction(tr("Replay from here"), this, [this, time] { Q_EMIT momentWanted(time); });
  moment->setObjectName(QStringLiteral("actionReplayHere"));
  moment->setEnabled(hasSamples());
}

void LiveStrip::openMenu(const QPoint& global, Nanoseconds time, TracePanel* panel) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("liveStripMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addCursorActions(*menu, time);
  menu->addSeparator();
  auto* note = menu->addAction(tr("Note here…"), this, [this, time] { Q_EMIT noteWanted(notePlace(time)); });
  note->setObjectName(QStringLiteral("actionNoteHere"));
  note->setEnabled(hasSamples());
  addRecordingActions(*menu, time);
  menu->addSeparator();
  auto* view = panel == nullptr ? &view_ : panel->plot()->timeView();
  menu->addAction(tr("Show everything"), view, &TimeView::showAll);
  menu->addAction(tr("Fit values"), this, [this] {
    for (auto* one : shownPanels()) one->plot()->fitValues();
  });
  auto* hold = menu->addAction(tr("Keep the value axes as they are"), this, [this](bool on) {
    for (auto* one : shownPanels()) {
      for (const auto side : {TracePlot::kLeft, TracePlot::kRight}) {
        auto& axis = one->plot()->axis(side);
        on ? axis.fix({axis.low(), axis.high()}) : axis.fit();
      }
      one->plot()->markDirty();
    }
  });
  const auto panels = shownPanels();
  hold->setCheckable(true);
  hold->setEnabled(!panels.empty());
  hold->setChecked(!panels.empty() && panels.front()->plot()->axis(TracePlot::kLeft).isFixed());
  addAxisActions(*menu);
  if (panel != nullptr) addPlotActions(*menu, *panel);
  menu->addSeparator();
  menu->addAction(tr("Export range as CSV…"), this, [this] { exportCsv(); });
  auto* export_picture = menu->addAction(tr("Export picture…"), this, [this] { exportPicture(); });
  export_picture->setObjectName(QStringLiteral("actionExportPicture"));
  menu->addAction(tr("Copy picture"), this, [this] { copyPicture(); });
  if (body_ == Body::kPlots || body_ == Body::kFree) {
    auto* copy = menu->addAction(tr("Copy figures"), this, [this] { QApplication::clipboard()->setText(figures()); });
    copy->setObjectName(QStringLiteral("actionCopyPlotFigures"));
  }
  menu->popup(global);
}

}  // namespace syncline::ui
