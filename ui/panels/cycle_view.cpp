// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/cycle_view.h"

#include <fmt/format.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "dc/sync0_arrival.h"
#include "record/run_record.h"
#include "trace/arrival_bathtub.h"
#include "ui/editors/choice_edit.h"
#include "ui/plots/bathtub_plot.h"
#include "ui/plots/cycle_plot.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/time_view.h"
#include "ui/session/calc_and_copy.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spoken_value.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr unsigned kArrivalsEvery = 6;  // ticks: faster cannot be read

std::optional<Nanoseconds> calcAndCopyOf(const RunRecord& record, std::size_t slave) {
  const auto& told = record.snapshot().slaves;
  return calcAndCopy(record.config().slaves[slave].identity, slave < told.size() ? &told[slave].evidence : nullptr);
}

/// From SYNC0 until outputs come where the frames pass the reference clock the set value in front of the grid; nothing
/// where nobody holds them there.
std::optional<Nanoseconds> nominalArrival(const RunRecord& record, std::size_t slave) {
  const auto& snapshot = record.snapshot();
  const auto& sync0 = record.samples().sync0(slave);
  const bool held = snapshot.dcm.mode != DcmMode::kOff && !snapshot.dcm.control_off && snapshot.dcm.set_value_ns > 0;
  if (!held || sync0.period <= 0 || slave >= snapshot.slaves.size() || !snapshot.slaves[slave].dc_enabled)
    return std::nullopt;
  const auto& status = snapshot.slaves[slave];
  const dc::Sync0Grid grid{sync0.shift + status.evidence.sync0.off_ns, sync0.period};
  return sync0.period -
         dc::nominal_margin(snapshot.dcm.set_value_ns, grid, status.propagation_delay_ns, sync0.wire) % sync0.period;
}

}  // namespace

CycleView::CycleView(const TimeView* view, QWidget* parent)
    : QWidget(parent),
      view_(view),
      slaves_(named(new ChoiceEdit, "cycleSlave", tr("Slave whose SYNC0 period is shown"))),
      figures_(named(new ValueLabel, "cycleFigures", tr("Margins and setpoint slips"))),
      figure_(named(new QComboBox, "cycleFigure", tr("What is shown of the arrivals"))),
      plot_(named(new CyclePlot, "cyclePlot", tr("Arrivals in the SYNC0 period"))),
      bathtub_(named(new BathtubPlot, "bathtubPlot", tr("How probable late and early arrivals are"))) {
  setObjectName(QStringLiteral("cycleView"));
  setAccessibleName(tr("Cycle"));
  figures_->setLeastCharacters(4);
  slaves_->setMinimumContentsLength(18);
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  head->addWidget(slaves_);
  head->addWidget(figure_);
  head->addWidget(figures_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  layout->addWidget(bathtub_, 1);
  bathtub_->hide();
  figure_->addItems({tr("Arrivals"), tr("Bathtub")});
  figure_->setItemData(0, tr("How often outputs came when"), Qt::ToolTipRole);
  figure_->setItemData(1, tr("How probable it is that outputs come too late or too early"), Qt::ToolTipRole);
  connect(figure_, &QComboBox::currentIndexChanged, this, [this] {
    plot_->setVisible(figure() == Figure::kArrivals);
    bathtub_->setVisible(figure() == Figure::kBathtub);
    ticks_ = 0;
    if (isVisible()) refresh();
  });
  connect(slaves_, &ChoiceEdit::currentIndexChanged, this, [this] {
    ticks_ = 0;
    if (isVisible()) refresh();
  });
}

void CycleView::setRecord(const RunRecord* record) {
  record_ = record;
  ticks_ = 0;
  shown_.reset();
  const QSignalBlocker quiet(slaves_);
  slaves_->clear();
  plot_->setPicture({});
  bathtub_->setPicture({});
  figures_->clear();
  if (record == nullptr) return;
  for (std::size_t i = 0; i < record->samples().slave_count(); ++i) {
    if (record->samples().sync0(i).period > 0)
      slaves_->addItem(nameOf(*record, {Signal::kSlaveDeviation, i}), static_cast<int>(i));
  }
  slaves_->setEnabled(slaves_->count() > 0);
  if (slaves_->count() == 0) figures_->setText(tr("No slave with SYNC0 whose outputs can be followed"));
}

void CycleView::select(int slave) {
  if (const int row = slaves_->findData(slave); row >= 0) slaves_->setCurrentIndex(row);
}

int CycleView::slave() const { return slaves_->count() > 0 ? slaves_->currentData().toInt() : -1; }

void CycleView::refresh() {
  if (record_ == nullptr || slave() < 0 || ticks_++ % kArrivalsEvery != 0) return;
  const auto& samples = record_->samples();
  const auto position = static_cast<std::size_t>(slave());
  // Of a picture that stands nothing is counted again.
  const Shown shown{position, figure(), view_->begin(), view_->end(), samples.last_time()};
  if (std::optional(shown) == std::exchange(shown_, shown)) return;
  if (figure() == Figure::kArrivals) {
    showArrivals(position);
  } else {
    showBathtub(position);
  }
  const auto text = figure() == Figure::kArrivals ? figuresText() : bathtubText();
  if (text == figures_->text()) return;
  figures_->setText(text);
  sayValue(figure() == Figure::kArrivals ? static_cast<QWidget&>(*plot_) : *bathtub_, text);
}

void CycleView::setFigure(Figure figure) { figure_->setCurrentIndex(static_cast<int>(figure)); }
CycleView::Figure CycleView::figure() const { return static_cast<Figure>(figure_->currentIndex()); }
QString CycleView::words() const { return figures_->text(); }

void CycleView::showArrivals(std::size_t position) {
  const auto& samples = record_->samples();
  CyclePlot::Picture picture;
  picture.period = samples.sync0(position).period;
  picture.calc_and_copy = calcAndCopyOf(*record_, position);
  picture.nominal = nominalArrival(*record_, position);
  picture.begin = view_->begin();
  picture.end = view_->end() + 1;
  picture.figures = arrival_figures(samples.series(Signal::kArrivalPhase, position), picture.period, picture.begin,
                                    picture.end, CyclePlot::kBins);
  plot_->setPicture(std::move(picture));
}

void CycleView::showBathtub(std::size_t position) {
  const auto& samples = record_->samples();
  BathtubPlot::Picture picture;
  picture.period = samples.sync0(position).period;
  picture.calc_and_copy = calcAndCopyOf(*record_, position);
  picture.bathtub = arrival_bathtub(samples.series(Signal::kArrivalPhase, position), picture.period, view_->begin(),
                                    view_->end() + 1);
  bathtub_->setPicture(std::move(picture));
}

QString CycleView::bathtubText() const {
  const auto& picture = bathtub_->picture();
  const auto& bathtub = picture.bathtub;
  if (bathtub.count == 0) return tr("no arrivals");
  const auto rooms = [](const std::vector<ArrivalBathtub::Point>& wall) {
    QStringList said;
    for (const int decades : {3, 6, 9}) {
      const auto room = ArrivalBathtub::room(wall, std::pow(10.0, -decades));
      if (!room) continue;
      const auto text = signedTimeText(static_cast<Nanoseconds>(std::floor(room->room)));
      said << (room->extrapolated ? tr("%1 (extrapolated) in all but %2") : tr("%1 in all but %2"))
                  .arg(text, decadeText(decades));
    }
    return said.join(QStringLiteral(", "));
  };
  const auto late = rooms(bathtub.late), early = rooms(bathtub.early);
  if (late.isEmpty()) return tr("%1 arrivals: too few for a probability").arg(countText(bathtub.count));
  QStringList said;
  said << tr("room before SYNC0: %1").arg(late);
  said << tr("behind the one before: %1").arg(early);
  if (!picture.calc_and_copy) {
    said << tr("calculating and copying not known");
  } else {
    const auto need = static_cast<double>(*picture.calc_and_copy);
    const auto seldom = ArrivalBathtub::less_than(bathtub.late, need);
    const auto time = timeText(*picture.calc_and_copy);
    if (!seldom) {
      said << tr("calculating and copying (%1) always has its time, as far as can be told").arg(time);
    } else {
      const auto chance = QLocale().toString(seldom->probability, 'g', 1);
      said << (seldom->extrapolated ? tr("too late for calculating and copying (%1): %2 at most, extrapolated")
                                    : tr("too late for calculating and copying (%1): %2 at most"))
                  .arg(time, chance);
    }
  }
  return said.join(QStringLiteral(" \u00B7 "));
}

/// What counts most first: a narrow window shows the beginning.
QString CycleView::figuresText() const {
  const auto& picture = plot_->picture();
  const auto position = static_cast<std::size_t>(slave());
  const auto& figures = picture.figures;
  QStringList said;
  said << (figures.margin_min ? tr("margin at least %1").arg(timeText(*figures.margin_min)) : tr("no arrivals"));
  if (figures.margin_p999) said << tr("99.9 %: %1").arg(timeText(*figures.margin_p999));
  const auto slips = record_->samples().value(Signal::kSetpointSlips, position, view_->end());
  said << (slips ? tr("setpoint slips: %1").arg(countText(static_cast<std::uint64_t>(std::llround(slips->value))))
                 : tr("setpoint slips not known"));
  said << (picture.calc_and_copy ? tr("calculating and copying %1").arg(timeText(*picture.calc_and_copy))
                                 : tr("calculating and copying not known"));
  if (picture.nominal) said << tr("nominally %1").arg(timeText(picture.period - *picture.nominal));
  said << tr("SYNC0 %1, shift %2")
              .arg(cycleText(picture.period), signedTimeText(record_->samples().sync0(position).shift));
  return said.join(QStringLiteral(" \u00B7 "));
}

/// Both walls have the same probabilities: they are of the same arrivals.
std::string CycleView::bathtubCsv() const {
  std::string text = "probability,room_to_sync0_ns,room_behind_sync0_ns,extrapolated\n";
  const auto& bathtub = bathtub_->picture().bathtub;
  for (std::size_t i = 0; i < std::min(bathtub.late.size(), bathtub.early.size()); ++i) {
    fmt::format_to(std::back_inserter(text), "{:.4g},{:.0f},{:.0f},{}\n", bathtub.late[i].probability,
                   bathtub.late[i].room, bathtub.early[i].room, bathtub.late[i].extrapolated ? 1 : 0);
  }
  return text;
}

std::string CycleView::csv() const {
  if (figure() == Figure::kBathtub) return bathtubCsv();
  std::string text = "from_ns,to_ns,arrivals\n";
  const auto& picture = plot_->picture();
  const auto bins = static_cast<Nanoseconds>(picture.figures.bins.size());
  for (Nanoseconds i = 0; i < bins; ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", i * picture.period / bins, (i + 1) * picture.period / bins,
                   picture.figures.bins[static_cast<std::size_t>(i)].count);
  }
  return text;
}

}  // namespace syncline::ui
