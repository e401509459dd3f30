// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/trace_panel.h"

#include <qwt_text.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "trace/statistics.h"
#include "trace/untold.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/signal_source.h"
#include "ui/text/joined_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {

TracePanel::TracePanel(const QString& title, const TracePlot::Options& options, TimeView* view, CursorSet* cursors,
                       QWidget* parent)
    : QWidget(parent),
      view_(view),
      cursors_(cursors),
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
  auto* head = new QHBoxLayout;
  head->setSpacing(8);
  head->addWidget(heading_);
  head->addWidget(readout_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(head);
  layout->addWidget(legend_);
  layout->addWidget(plot_, 1);
  heading_->setBuddy(plot_);
  setTitle(title);
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

void TracePanel::drawOverlay(SeriesItem& item, Signal signal, std::size_t slave) const {
  const auto* record = overlay_.record;
  const bool drawn =
      record != nullptr && isThere(*record, {signal, slave}) && !record->samples().series(signal, slave).empty();
  item.setSeries(drawn ? &record->samples().series(signal, slave) : nullptr);
  item.setVisible(drawn);
  if (!drawn) return;
  item.setHeldBy(record->samples().held(signal, slave));
  item.setMaxGap(record->samples().longest_gap(signal));
}

LegendBar::Entry TracePanel::overlayEntry(const SeriesItem& item, const QString& name, Nanoseconds time) const {
  auto result = entry(item, time);
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
    return;
  }
  if (choose_now) choose();
  const auto time = cursors_->pointer().value_or(std::min(view_->end(), view_->last()));
  legend_->setEntries(entries(time));
  const auto text = cursors_->both() ? betweenCursors() : summary(time);
  if (text != readout_->text()) {
    readout_->setText(text);
  }
  plot_->setAccessibleDescription(joinedSentences({legend_->text(), text}));
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
  return measured_text_;
}

QString TracePanel::measure(const SeriesItem& item, Nanoseconds begin) const {
  Statistics statistics;
  const auto own = begin - item.shift();
  item.series()->for_each(own, own + std::llabs(cursors_->delta()) + 1, [&](Nanoseconds, float value) {
    if (!std::isnan(value)) statistics.add(static_cast<double>(value));
  });
  const auto a = item.valueAt(*cursors_->at(CursorSet::kA));
  const auto b = item.valueAt(*cursors_->at(CursorSet::kB));
  if (!a || !b) return tr("no samples at A or B");
  const auto text = tr("B−A %1").arg(valueText(static_cast<double>(b->value) - static_cast<double>(a->value)));
  if (statistics.count() == 0) return text;
  return text + tr("   min %1   max %2   mean %3")
                    .arg(valueText(statistics.min()), valueText(statistics.max()), valueText(statistics.mean()));
}

LegendBar::Entry TracePanel::entry(const SeriesItem& item, Nanoseconds time) const {
  LegendBar::Entry entry{item.title().text(), {}, QStringLiteral("\u2013"), item.color(), item.shape()};
  if (item.series() == nullptr) return entry;
  if (const auto reading = item.valueAt(time)) entry.value = valueText(static_cast<double>(reading->value));
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
  item.setSeries(&store().series(signal, slave));
  item.setHeldBy(store().held(signal, slave));
  item.setMaxGap(store().longest_gap(signal));
}

void TracePanel::showTriggerLevel(Signal signal, std::size_t slave, std::optional<double> level) {
  bool drawn = false;
  if (source_ != nullptr && isThere(*source_, {signal, slave})) {
    const auto* series = &seriesOf(*source_, {signal, slave});
    for (const auto* item : plot_->items()) drawn = drawn || (item->isVisible() && item->series() == series);
  }
  plot_->setTriggerLevel(drawn ? level : std::nullopt);
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
