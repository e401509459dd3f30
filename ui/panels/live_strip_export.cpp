// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>

#include "support/whole_file.h"
#include "ui/panels/cycle_view.h"
#include "ui/panels/distribution_view.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/picture_file.h"
#include "ui/panels/slaves_view.h"
#include "ui/panels/stability_view.h"
#include "ui/plots/series_csv.h"
#include "ui/text/error_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

void tellUnwritten(QWidget* parent, const Status& status) {
  if (!status) QMessageBox::warning(parent, LiveStrip::tr("Export"), errorText(status.error()));
}

}  // namespace

std::string LiveStrip::csv() const {
  if (body_ == Body::kDistribution) return distribution_->csv();
  if (body_ == Body::kStability) return stability_->csv();
  if (body_ == Body::kSlaves) return slaves_->csv();
  if (body_ == Body::kCycle) return cycle_->csv();
  return csv(view_.begin(), view_.end());
}

std::string LiveStrip::csv(Nanoseconds from, Nanoseconds to) const {
  std::vector<CsvColumn> columns;
  if (record_ == nullptr) return series_csv(columns, {}, 0, 0, 0);
  const auto& samples = record_->samples();
  using Scope = SignalInfo::Scope;
  for (const auto& signal : signals()) {
    // Made for all slaves at once it would take as much room as everything else; the distribution saves it.
    if (signal.form == SignalInfo::Form::kCell || signal.form == SignalInfo::Form::kDerived) continue;
    const auto count = signal.scope == Scope::kSlave      ? samples.slave_count()
                       : signal.scope == Scope::kVariable ? samples.watched().variables().size()
                                                          : 1;
    for (std::size_t number = 0; number < count; ++number) {
      const auto& series = samples.series(signal.id, number);
      if (series.empty()) continue;
      auto name = std::string(signal.key);
      if (signal.scope == Scope::kSlave) name += " " + record_->slave_name(number);
      if (signal.scope == Scope::kVariable) name = samples.watched().variables()[number].name;
      columns.push_back({std::move(name), &series});
    }
  }
  const auto cycle = [&samples](Nanoseconds time) { return samples.cycle_at(time); };
  return series_csv(columns, cycle, view_.origin(), from, to + 1);
}

Picture LiveStrip::picture() {
  const auto title = tr("Syncline, %1, cycle %2")
                         .arg(utcRangeText(view_.begin(), view_.end()),
                              cycleText(record_ == nullptr ? 0 : record_->limits().cycle_time));
  return captioned(*body(), title, [this](QPainter& painter, const QPoint& place) {
    auto* shown = body();
    const auto colours = shown->palette();
    shown->setPalette(picturePalette());
    for (auto* panel : all_panels_) panel->applyTheme();
    if (body_ == Body::kDistribution) distribution_->refresh();
    if (body_ == Body::kStability) stability_->refresh();
    if (body_ == Body::kSlaves) slaves_->refresh();
    if (body_ == Body::kCycle) cycle_->refresh();
    shown->render(&painter, place, {}, QWidget::DrawChildren);
    shown->setPalette(colours);
    for (auto* panel : all_panels_) panel->applyTheme();
  });
}

void LiveStrip::exportCsv() {
  const auto path = QFileDialog::getSaveFileName(this, tr("Export the range shown"), QStringLiteral("syncline.csv"),
                                                 tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  tellUnwritten(this, write_whole_file(path.toStdString(), csv()));
}

void LiveStrip::exportRange(Nanoseconds from, Nanoseconds to) {
  const auto path = QFileDialog::getSaveFileName(this, tr("Export the episode"), QStringLiteral("episode.csv"),
                                                 tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  tellUnwritten(this, write_whole_file(path.toStdString(), csv(from, to)));
}

void LiveStrip::exportPicture() {
  ui::exportPicture(this, tr("Export the plots"), QStringLiteral("syncline.png"), [this] { return picture(); });
}

void LiveStrip::copyPicture() { ui::copyPicture(picture()); }

void LiveStrip::openMenu(const QPoint& global, Nanoseconds time) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Cursor A here"), this, [this, time] { cursors_.set(CursorSet::kA, time); });
  menu->addAction(tr("Cursor B here"), this, [this, time] { cursors_.set(CursorSet::kB, time); });
  menu->addAction(tr("Remove cursors"), this, [this] { cursors_.clear(); })->setEnabled(cursors_.any());
  menu->addSeparator();
  auto* note = menu->addAction(tr("Note here…"), this, [this, time] { Q_EMIT noteWanted(notePlace(time)); });
  note->setObjectName(QStringLiteral("actionNoteHere"));
  note->setEnabled(hasSamples());
  if (const auto& overlay = panels_.front()->overlay(); overlay.record != nullptr) {
    const auto cursor = cursors_.at(CursorSet::kA);
    auto* lay = menu->addAction(tr("Lay this moment of %1 on cursor A").arg(overlay.other), this,
                                [this, by = cursor.value_or(time) - time] { Q_EMIT overlayMoved(by); });
    lay->setObjectName(QStringLiteral("actionOverlayOnCursor"));
    lay->setEnabled(cursor.has_value());
  }
  if (recorded_) {
    auto* moment = menu->addAction(tr("Replay from here"), this, [this, time] { Q_EMIT momentWanted(time); });
    moment->setObjectName(QStringLiteral("actionReplayHere"));
    moment->setEnabled(hasSamples());
  }
  menu->addSeparator();
  menu->addAction(tr("Show everything"), this, [this] { view_.showAll(); });
  menu->addAction(tr("Fit values"), this, [this] {
    for (auto* panel : all_panels_) panel->plot()->fitValues();
  });
  auto* hold = menu->addAction(tr("Keep the value axes as they are"), this, [this](bool on) {
    for (auto* panel : all_panels_) {
      const auto& range = panel->plot()->valueRange();
      on ? panel->plot()->fixValues(range.low(), range.high()) : panel->plot()->fitValues();
    }
  });
  hold->setCheckable(true);
  hold->setChecked(panels_.front()->plot()->valueRange().isFixed());
  menu->addSeparator();
  menu->addAction(tr("Export range as CSV…"), this, [this] { exportCsv(); });
  auto* export_picture = menu->addAction(tr("Export picture…"), this, [this] { exportPicture(); });
  export_picture->setObjectName(QStringLiteral("actionExportPicture"));
  menu->addAction(tr("Copy picture"), this, [this] { copyPicture(); });
  menu->popup(global);
}

}  // namespace syncline::ui
