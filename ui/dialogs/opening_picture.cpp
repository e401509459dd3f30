// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/opening_picture.h"

#include <qwt_text.h>

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "trace/cycle_gap.h"
#include "ui/plots/legend_bar.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/trace_plot.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kTickMs = 33;

}  // namespace

OpeningPicture::OpeningPicture(const OpenedRecording::Outline& outline, QWidget* parent) : QWidget(parent) {
  named(this, "openingPicture", tr("First picture of the recording"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(14);
  curves_.reserve(2);
  // The words are those of the plots that come.
  const auto& limits = outline.limits;
  auto& deviation = add(QCoreApplication::translate("DeviationPanel", "DC deviation"),
                        QCoreApplication::translate("DeviationPanel", "Deviation"), "openingDeviationPlot");
  addCurve(deviation, Signal::kDeviation, QCoreApplication::translate("DeviationPanel", "largest"), limits.cycle_time);
  if (limits.deviation_ns > 0) {
    deviation.plot->setLimit(
        limits.deviation_ns,
        QCoreApplication::translate("DeviationPanel", "limit \u00B1%1").arg(timeText(limits.deviation_ns)));
  }
  auto& error = add(QCoreApplication::translate("DcmPanel", "DCM error"),
                    QCoreApplication::translate("DcmPanel", "Error"), "openingDcmPlot");
  addCurve(error, Signal::kDcmError, QCoreApplication::translate("DcmPanel", "raw"), limits.cycle_time);
  addCurve(error, Signal::kDcmErrorFiltered, QCoreApplication::translate("DcmPanel", "filtered"), limits.cycle_time);
  if (limits.dcm_error_ns > 0) {
    error.plot->setLimit(
        static_cast<double>(limits.dcm_error_ns),
        QCoreApplication::translate("DcmPanel", "filtered \u00B1%1").arg(timeText(limits.dcm_error_ns)));
  }
  view_.setFollowable(false);
  view_.setBounds(outline.first, outline.last);
  view_.showAll();
  applyTheme();
  connect(&tick_, &QTimer::timeout, this, &OpeningPicture::refresh);
  tick_.start(kTickMs);
}

OpeningPicture::~OpeningPicture() = default;

OpeningPicture::Curves& OpeningPicture::add(const QString& title, const QString& quantity, const char* name) {
  auto& curves = curves_.emplace_back();
  auto* heading = new QLabel(title);
  auto bold = font();
  bold.setWeight(QFont::DemiBold);
  heading->setFont(bold);
  curves.legend = new LegendBar;
  curves.legend->setAccessibleName(title);
  curves.plot = named(new TracePlot({quantity, TracePlot::Quantity::kTime, 20, false}, &view_, &cursors_), name, title);
  auto* column = new QVBoxLayout;
  column->setSpacing(2);
  column->addWidget(heading);
  column->addWidget(curves.legend);
  column->addWidget(curves.plot, 1);
  static_cast<QHBoxLayout*>(layout())->addLayout(column, 1);
  return curves;
}

void OpeningPicture::addCurve(Curves& curves, Signal signal, const QString& title, Nanoseconds cycle_time) {
  const auto shape = signal == Signal::kDcmErrorFiltered ? SeriesItem::Shape::kLine : SeriesItem::Shape::kEnvelope;
  auto* item = curves.plot->addItem(title, shape);
  item->setMaxGap(longest_cycle_gap(cycle_time));
  curves.signals.push_back(signal);
  curves.items.push_back(item);
}

void OpeningPicture::applyTheme() {
  for (auto& curves : curves_) {
    std::vector<LegendBar::Entry> entries;
    for (auto* item : curves.items) {
      const bool broad = item->shape() == SeriesItem::Shape::kEnvelope;
      item->setColor(broad ? plot_colors::envelope(palette()) : plot_colors::trace(palette(), 1));
      entries.push_back({item->title().text(), {}, {}, item->color(), item->shape()});
    }
    curves.legend->setEntries(std::move(entries));
    curves.plot->applyTheme();
  }
}

void OpeningPicture::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyTheme();
}

void OpeningPicture::take(const std::vector<FirstPicture>& pictures) {
  for (const auto& picture : pictures) {
    const auto curves = std::ranges::find(curves_, picture.signals, &Curves::signals);
    if (curves == curves_.end() || picture.columns.size() != curves->items.size()) continue;
    for (std::size_t i = 0; i < curves->items.size(); ++i)
      curves->items[i]->setColumns(picture.columns[i], picture.width);
    curves->plot->markDirty();
  }
  refresh();
}

void OpeningPicture::refresh() {
  std::vector<ColumnGrid> grids;
  for (const auto& curves : curves_) {
    curves.plot->refresh();
    grids.push_back(curves.plot->grid());
  }
  const bool laid_out = std::ranges::all_of(grids, [](const ColumnGrid& grid) { return grid.columns > 0; });
  if (!laid_out || grids == asked_) return;
  asked_ = grids;
  std::vector<FirstPicture> pictures;
  for (std::size_t i = 0; i < curves_.size(); ++i)
    pictures.push_back({curves_[i].signals, grids[i].origin, grids[i].end(), grids[i].width});
  Q_EMIT wanted(pictures);
}

}  // namespace syncline::ui
