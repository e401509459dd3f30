// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/trace_panel.h"

#include <qwt_text.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <set>

#include "record/run_record.h"
#include "trace/untold.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/gap_item.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/signal_source.h"
#include "ui/text/joined_text.h"
#include "ui/text/quality_text.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/spoken_value.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr double kCursorQuantile = 0.999;

/// In the language's form, without what parts thousands: a spreadsheet takes it as a number.
QString spreadsheetText(double value) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  const double shown = std::round(value * 1000) / 1000 + 0.0;  // + 0.0: no "-0"
  auto text = locale.toString(shown, 'f', shown == std::floor(shown) ? 0 : 3);
  while (shown != std::floor(shown) && text.endsWith(u'0')) text.chop(1);
  return text;
}

}  // namespace

const SampleStore& TracePanel::store() const { return source_->samples(); }

TracePanel::TracePanel(const QString& title, const TracePlot::Options& options, TimeView* view, CursorSet* cursors,
                       QWidget* parent)
    : QWidget(parent),
      shared_(view),
      view_(view),
      cursors_(cursors),
      head_(new QHBoxLayout),
      heading_(new QLabel(title)),
      readout_(new ValueLabel),
      legend_(new LegendBar),
      plot_(new TracePlot(options, view, cursors)) {
  auto bold = font();
  bold.setWeight(QFont::DemiBold);
  heading_->setFont(bold);
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  // A long read-out must not widen the panel.
  readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  readout_->setFont(legend_->font());
  head_->setSpacing(8);
  head_->addWidget(heading_);
  head_->addWidget(readout_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(head_);
  layout->addWidget(legend_);
  layout->addWidget(plot_, 1);
  heading_->setBuddy(plot_);
  legend_->setAbout([this](const LegendBar::Entry& entry) { return aboutEntry(entry); });
  setTitle(title);
}

void TracePanel::addToHead(QWidget* widget) { head_->addWidget(widget); }

void TracePanel::setScale(ValueScale scale) {
  for (const auto side : {TracePlot::kLeft, TracePlot::kRight}) plot_->axis(side).setScale(scale);
  plot_->markDirty();
}

void TracePanel::setLimits(TracePlot::Side side, const std::optional<AxisLimits>& limits) {
  limits ? plot_->axis(side).fix(*limits) : plot_->axis(side).fit();
  plot_->markDirty();
}

void TracePanel::setOwnTime(bool own) {
  if (own == plot_->hasOwnTime()) return;
  if (own) own_.copy(*shared_);
  view_ = own ? &own_ : shared_;
  plot_->setTimeView(view_, own);
  refreshText(true);
}

void TracePanel::followTime() {
  if (plot_->hasOwnTime()) own_.follow(*shared_);
}

void TracePanel::setTitle(const QString& title) {
  heading_->setText(title);
  plot_->setAccessibleName(title);
  legend_->setAccessibleName(tr("Legend: %1").arg(title));
  readout_->setAccessibleName(tr("Figures: %1").arg(title));
}

void TracePanel::setSource(const RunRecord* source) {
  source_ = source;
  const auto* samples = source == nullptr ? nullptr : &source->samples();
  plot_->gaps().setSeries(samples == nullptr ? nullptr : &samples->series(answered_signal(*samples)),
                          samples == nullptr ? 0 : samples->longest_gap(Signal::kRoundTrip));
  attach();
  colorItems();
  plot_->fitValues();
  refreshText(true);
}

void TracePanel::setOverlay(const Overlay& overlay) {
  const bool other = overlay.record != overlay_.record;
  overlay_ = overlay;
  for (auto* item : overlay_items_) item->setShift(overlay_.shift);
  attachOverlay();
  if (other) plot_->fitValues();
  plot_->markDirty();
  refreshText(false);
}

SeriesItem* TracePanel::addOverlayItem(SeriesItem::Shape shape) {
  auto* item = plot_->addItem({}, shape);
  item->setVisible(false);
  overlay_items_.push_back(item);
  return item;
}

void TracePanel::drawOverlay(SeriesItem& item, const QString& name, Signal signal, std::size_t slave) const {
  const auto* record = overlay_.record;
  const bool drawn =
      record != nullptr && isThere(*record, {signal, slave}) && !record->samples().series(signal, slave).empty();
  item.setSeries(drawn ? &record->samples().series(signal, slave) : nullptr);
  item.setVisible(drawn);
  if (!drawn) return;
  item.setTitle(tr("%1 (%2)").arg(name, overlay_.other));
  item.setHeldBy(record->samples().held(signal, slave));
  item.setMaxGap(record->samples().longest_gap(signal));
  item.setSource({signal, slave});
}

LegendBar::Entry TracePanel::overlayEntry(const SeriesItem& item, const QString& name, Nanoseconds time) const {
  auto result = entry(item, time);
  result.of_overlay = true;
  result.name = tr("%1 (%2)").arg(name, overlay_.other);
  result.short_name = overlay_.other;
  return result;
}

void TracePanel::nameOwn(LegendBar::Entry& entry) const {
  if (overlay_.record == nullptr) return;
  entry.name = tr("%1 (%2)").arg(entry.name, overlay_.own);
  if (entry.short_name.isEmpty()) entry.short_name = overlay_.own;
}

void TracePanel::setPickedSlave(int position) {
  picked_ = position;
  refreshText(true);
}

QString TracePanel::readout() const { return readout_->text(); }
QString TracePanel::title() const { return heading_->text(); }

void TracePanel::refreshText(bool choose_now) {
  if (!hasSource() || store().empty()) {
    legend_->setEntries({});
    readout_->clear();
    return sayValue(*plot_, {});
  }
  renew();
  if (choose_now) choose();
  const auto time = cursors_->pointer().value_or(std::min(view_->end(), view_->last()));
  legend_->setEntries(entries(time));
  const auto text = cursors_->both() ? betweenCursors() : summary(time);
  if (text != readout_->text()) {
    readout_->setText(text);
  }
  sayValue(*plot_, joinedSentences({legend_->text(), text, limitWords()}));
}

/// Whether what is held against the limit keeps it in the range shown.
QString TracePanel::limitWords() const {
  const auto signal = limitSignal();
  if (!signal || plot_->limit() <= 0) return {};
  const auto limit = timeText(static_cast<Nanoseconds>(plot_->limit()));
  std::set<const MinMaxSeries*> drawn;
  for (const SeriesItem* item : plot_->items()) {
    if (item->isVisible()) drawn.insert(item->series());
  }
  double worst = -1;
  for (std::size_t slave = 0; slave < std::max<std::size_t>(store().slave_count(), 1); ++slave) {
    if (!isThere(*source_, {*signal, slave})) continue;
    const auto& series = seriesOf(*source_, {*signal, slave});
    const auto extent = drawn.contains(&series) ? series.extent(view_->begin(), view_->end() + 1) : std::nullopt;
    if (extent)
      worst = std::max({worst, std::abs(static_cast<double>(extent->min)), std::abs(static_cast<double>(extent->max))});
  }
  if (worst < 0) return {};
  return worst > plot_->limit() ? tr("the limit of %1 is exceeded").arg(limit)
                                : tr("the limit of %1 is kept").arg(limit);
}

QString TracePanel::betweenCursors() {
  const auto* item = primary();
  if (item == nullptr || item->series() == nullptr) return {};
  const auto begin = std::min(*cursors_->at(CursorSet::kA), *cursors_->at(CursorSet::kB));
  // Every sample between the cursors is visited: only again when that can change something.
  const auto* other = primaryOfOverlay();
  if (other != nullptr && other->series() == nullptr) other = nullptr;
  const Measured key{item->series(),
                     begin,
                     cursors_->delta(),
                     item->series()->count(begin, begin + std::llabs(cursors_->delta()) + 1),
                     other == nullptr ? nullptr : other->series(),
                     overlay_.shift};
  if (key == measured_) return measured_text_;
  measured_ = key;
  measured_text_ = measure(*item, begin);
  if (other != nullptr)
    measured_text_ = tr("%1: %2   %3: %4").arg(overlay_.own, measured_text_, overlay_.other, measure(*other, begin));
  if (const auto more = remark(begin, begin + std::llabs(cursors_->delta()) + 1); !more.isEmpty())
    measured_text_ += QStringLiteral("   ") + more;
  return measured_text_;
}

TracePanel::OfStretch TracePanel::stretch(const SeriesItem& item, Nanoseconds begin, Nanoseconds end) const {
  OfStretch found;
  const bool whole = unitText(item) == QLatin1String("ns");
  item.series()->for_each(begin - item.shift(), end - item.shift(), [&](Nanoseconds, float value) {
    if (std::isnan(value)) return;
    found.statistics.add(static_cast<double>(value));
    if (whole) found.magnitudes.add(std::llabs(std::llround(static_cast<double>(value))));
  });
  return found;
}

QString TracePanel::measure(const SeriesItem& item, Nanoseconds begin) const {
  const auto [statistics, magnitudes] = stretch(item, begin, begin + std::llabs(cursors_->delta()) + 1);
  const auto a = item.valueAt(*cursors_->at(CursorSet::kA));
  const auto b = item.valueAt(*cursors_->at(CursorSet::kB));
  if (!a || !b) return tr("no samples at A or B");
  const auto text = tr("B−A %1").arg(itemText(item, static_cast<double>(b->value) - static_cast<double>(a->value)));
  if (statistics.count() == 0) return text;
  const auto figures = tr("   min %1   max %2   mean %3")
                           .arg(itemText(item, statistics.min()), itemText(item, statistics.max()),
                                itemText(item, statistics.mean()) + spread(statistics));
  if (magnitudes.count() == 0) return text + figures;
  return text + figures + tr("   p99.9 %1").arg(timeText(magnitudes.percentile(kCursorQuantile)));
}

QString TracePanel::spread(const Statistics& statistics) const {
  const auto half = statistics.mean_half_width();
  const auto text = half ? spreadText(*half) : QString();
  return text.isEmpty() ? text : QStringLiteral(" \u00B1 ") + text;
}

QString TracePanel::itemText(const SeriesItem&, double value) const { return valueText(value); }

QStringList TracePanel::figureHeads() {
  return {tr("Signal"),  tr("Unit"), tr("At A"),  tr("At B"),    tr("B−A"),      tr("Smallest"),
          tr("Largest"), tr("Mean"), tr("p99.9"), tr("Samples"), tr("Mean 95 %")};
}

QStringList TracePanel::figures() const {
  QStringList lines;
  if (!hasSource()) return lines;
  const bool between = cursors_->both();
  auto begin = view_->begin();
  auto end = view_->end() + 1;
  if (between) {
    begin = std::min(*cursors_->at(CursorSet::kA), *cursors_->at(CursorSet::kB));
    end = begin + std::llabs(cursors_->delta()) + 1;
  }
  for (const auto* item : plot_->items()) {
    if (!item->isVisible() || item->series() == nullptr) continue;
    const auto [statistics, magnitudes] = stretch(*item, begin, end);
    const auto at = [&](CursorSet::Which which) {
      const auto time = cursors_->at(which);
      return time ? item->valueAt(*time) : std::nullopt;
    };
    const auto a = at(CursorSet::kA);
    const auto b = at(CursorSet::kB);
    const auto shown = [&](bool known, double value) { return known ? spreadsheetText(value) : QString(); };
    const auto of = [](const auto& reading) { return reading ? static_cast<double>(reading->value) : 0; };
    const bool any = statistics.count() > 0;
    const auto half = statistics.mean_half_width();
    const bool estimated = half && !spreadText(*half).isEmpty();
    lines << QStringList{item->title().text(),
                         unitText(*item),
                         shown(a.has_value(), of(a)),
                         shown(b.has_value(), of(b)),
                         shown(a && b, of(b) - of(a)),
                         shown(any, any ? statistics.min() : 0),
                         shown(any, any ? statistics.max() : 0),
                         shown(any, any ? statistics.mean() : 0),
                         shown(magnitudes.count() > 0, static_cast<double>(magnitudes.percentile(kCursorQuantile))),
                         QString::number(statistics.count()),
                         shown(estimated, half.value_or(0))}
                 .join(u'\t');
  }
  return lines;
}

LegendBar::Entry TracePanel::entry(const SeriesItem& item, Nanoseconds time) const {
  LegendBar::Entry entry{item.title().text(), {},   QStringLiteral("\u2013"), item.color(), item.shape(),
                         item.source(),       false};
  if (item.series() == nullptr) return entry;
  if (const auto reading = item.valueAt(time)) entry.value = itemText(item, static_cast<double>(reading->value));
  return entry;
}

LegendBar::Entry TracePanel::slaveEntry(const SeriesItem& item, int position, Nanoseconds time) const {
  auto result = entry(item, time);
  result.short_name = u'#' + QString::number(position);
  result.name = result.short_name + u' ' + result.name;
  return result;
}

QString TracePanel::slaveName(int position) const {
  return QString::fromStdString(source_->slave_name(static_cast<std::size_t>(position)));
}

void TracePanel::draw(SeriesItem& item, Signal signal, std::size_t slave) const {
  // The same one again would forget what is drawn.
  if (const auto* series = &store().series(signal, slave); item.series() != series) item.setSeries(series);
  item.setHeldBy(store().held(signal, slave));
  item.setMaxGap(store().longest_gap(signal));
  item.setSource({signal, slave});
}

QString TracePanel::aboutEntry(const LegendBar::Entry& entry) const {
  const auto* record = entry.of_overlay ? overlay_.record : source_;
  if (record == nullptr || !entry.source || !isThere(*record, *entry.source)) return {};
  const auto time = cursors_->pointer().value_or(std::min(view_->end(), view_->last()));
  return qualityText(quality_of(record->samples(), entry.source->signal, entry.source->slave,
                                entry.of_overlay ? time - overlay_.shift : time));
}

void TracePanel::showWantedLimits(const std::optional<RunLimits>& wanted) {
  const auto signal = limitSignal();
  const bool known = wanted && signal;
  plot_->setLimitMovable(known);
  const double limit = known ? limitOf(*wanted, *signal) : 0;
  if (limit == 0 || limit == plot_->limit()) return plot_->setWantedLimit(0, {});
  plot_->setWantedLimit(limit, tr("project \u00B1%1").arg(timeText(static_cast<Nanoseconds>(limit))));
}

void TracePanel::showTriggerLevel(Signal signal, std::size_t slave, std::optional<double> level) {
  bool drawn = false;
  auto side = TracePlot::kLeft;
  if (source_ != nullptr && isThere(*source_, {signal, slave})) {
    const auto* series = &seriesOf(*source_, {signal, slave});
    for (const auto* item : plot_->items()) {
      if (!item->isVisible() || item->series() != series) continue;
      drawn = true;
      side = item->yAxis() == plot_->axis(TracePlot::kRight).id() ? TracePlot::kRight : TracePlot::kLeft;
    }
  }
  plot_->setTriggerLevel(drawn ? level : std::nullopt, side);
}

void TracePanel::applyTheme() {
  auto palette = readout_->palette();
  palette.setColor(QPalette::WindowText, theme::mutedText(this->palette()));
  readout_->setPalette(palette);
  plot_->applyTheme();
  if (source_ != nullptr) colorItems();
  for (auto* item : overlay_items_) item->setColor(plot_colors::overlay(this->palette()));
  refreshText(false);
  legend_->update();
}

}  // namespace syncline::ui
