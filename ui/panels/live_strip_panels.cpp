// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/live_strip_panels.h"

#include <qwt_text.h>

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "record/run_record.h"
#include "trace/sync_overview.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/plot_colors.h"
#include "ui/text/step_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kDeviationsShown = 3;  // what fits the legend beside the estimate
constexpr std::size_t kCountersShown = 4;

}  // namespace

// ---- deviation --------------------------------------------------------------------------------

DeviationPanel::DeviationPanel(TimeView* view, CursorSet* cursors, QWidget* parent)
    : WorstSlavesPanel(tr("DC deviation"), {tr("Deviation"), TracePlot::Quantity::kTime, 20, false}, kDeviationsShown,
                       view, cursors, parent),
      largest_(plot()->addItem(tr("largest"), SeriesItem::Shape::kEnvelope)) {
  setObjectName(QStringLiteral("deviationPanel"));
  plot()->setObjectName(QStringLiteral("deviationPlot"));
  plot()->setToolTip(
      tr("Register 0x092C (System Time Difference) of the slaves that follow the reference clock. Largest: the "
         "wire-or of all of them read by BRD where nothing else is in it, else the largest of their latest "
         "readings. Lines: signed values of single slaves."));
  addCurves(SeriesItem::Shape::kLine);
  other_ = addOverlayItem(SeriesItem::Shape::kEnvelope);
}

void DeviationPanel::attachOverlay() { drawOverlay(*other_, largest_->title().text(), Signal::kDeviation); }

void DeviationPanel::attach() {
  forgetWorst();
  largest_->setSeries(nullptr);
  if (!hasSource()) return;
  draw(*largest_, Signal::kDeviation);
  const auto limit = source().limits().deviation_ns;
  plot()->setLimit(limit, limit > 0 ? tr("limit \u00B1%1").arg(timeText(limit)) : QString());
}

void DeviationPanel::choose() {
  std::vector<double> scores(store().slave_count(), -1);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const auto extent = store().series(Signal::kSlaveDeviation, i).extent(view().begin(), view().end() + 1);
    if (extent)
      scores[i] = std::max(std::abs(static_cast<double>(extent->min)), std::abs(static_cast<double>(extent->max)));
  }
  if (!chooseWorst(scores, Signal::kSlaveDeviation)) return;
  colorItems();
  plot()->markDirty();
}

void DeviationPanel::colorItems() {
  largest_->setColor(plot_colors::envelope(palette()));
  colorWorst();
}

std::vector<LegendBar::Entry> DeviationPanel::entries(Nanoseconds time) const {
  std::vector<LegendBar::Entry> result{entry(*largest_, time)};
  if (const auto reading = store().value(Signal::kDeviation, time)) {
    result.front().value = largestText(static_cast<double>(reading->value));
  }
  nameOwn(result.front());
  if (other_->isVisible()) {
    result.push_back(overlayEntry(*other_, largest_->title().text(), time));
    // A magnitude has no sign.
    if (const auto reading = other_->valueAt(time))
      result.back().value = timeText(wholeNs(static_cast<double>(reading->value)));
  }
  for (std::size_t i = 0; i < worst().size(); ++i) {
    result.push_back(slaveEntry(curve(i), worst()[i].slave, time));
  }
  return result;
}

QString DeviationPanel::summary(Nanoseconds) const {
  const auto extent = store().series(Signal::kDeviation).extent(view().begin(), view().end() + 1);
  if (!extent) return {};
  return tr("peak %1").arg(largestText(static_cast<double>(extent->max)));
}

/// A magnitude has no sign, and what is or-ed no slave need have had.
QString DeviationPanel::largestText(double value) const {
  const auto text = timeText(wholeNs(value));
  return isUpperEstimate(source(), Signal::kDeviation) ? atMostText(text) : text;
}

QString DeviationPanel::unitText(const SeriesItem&) const { return QStringLiteral("ns"); }
QString DeviationPanel::valueText(double value) const { return signedTimeText(wholeNs(value)); }
QString DeviationPanel::spreadText(double half) const { return timeText(wholeNs(std::ceil(half))); }

// ---- SM2 misses -------------------------------------------------------------------------------

Sm2Panel::Sm2Panel(TimeView* view, CursorSet* cursors, QWidget* parent)
    : WorstSlavesPanel(tr("SM2 events missed"), {tr("Events"), TracePlot::Quantity::kCount, 4, true}, kCountersShown,
                       view, cursors, parent) {
  setObjectName(QStringLiteral("sm2Panel"));
  plot()->setObjectName(QStringLiteral("sm2Plot"));
  plot()->setToolTip(tr("SM event missed counter, object 0x1C32:0B or 0x1C32:0C of the slaves that have one."));
  addCurves(SeriesItem::Shape::kStep);
  for (int i = 0; i < kMostSlaves; ++i) others_.push_back(addOverlayItem(SeriesItem::Shape::kStep));
}

void Sm2Panel::attachOverlay() {
  hideAll(others_);
  for (std::size_t i = 0; i < worst().size(); ++i)
    drawOverlay(*others_[i], curve(i).title().text(), Signal::kSm2Missed, static_cast<std::size_t>(worst()[i].slave));
}

void Sm2Panel::attach() { forgetWorst(); }

void Sm2Panel::choose() {
  std::vector<double> scores(store().slave_count(), -1);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const auto& series = store().series(Signal::kSm2Missed, i);
    if (const auto last = series.at(view().last()))
      scores[i] = rate(series, view().end()) * 1e9 + static_cast<double>(last->value);
  }
  if (!chooseWorst(scores, Signal::kSm2Missed)) return;
  attachOverlay();
  colorItems();
  plot()->markDirty();
}

void Sm2Panel::colorItems() { colorWorst(); }

double Sm2Panel::rate(const MinMaxSeries& series, Nanoseconds until) const {
  const auto now = series.at(until);
  if (!now) return 0;
  const auto begin = std::max(until - view().span(), series.first_time());
  const auto then = series.at(begin);
  if (!then || until <= begin) return 0;
  // A counter that went back was cleared: what it shows now came since.
  const double events = static_cast<double>(now->value) - static_cast<double>(then->value);
  return (events < 0 ? static_cast<double>(now->value) : events) * 1e9 / static_cast<double>(until - begin);
}

std::vector<LegendBar::Entry> Sm2Panel::entries(Nanoseconds time) const {
  std::vector<LegendBar::Entry> result;
  for (std::size_t i = 0; i < worst().size(); ++i) {
    const auto slave = worst()[i].slave;
    result.push_back(slaveEntry(curve(i), slave, time));
    nameOwn(result.back());
    if (!others_[i]->isVisible()) continue;
    const auto number = u'#' + QString::number(slave);
    result.push_back(overlayEntry(*others_[i], number, time));
    result.back().short_name = result.back().name;
  }
  return result;
}

QString Sm2Panel::summary(Nanoseconds time) const {
  double highest = 0;
  const SeriesItem* fastest = nullptr;
  for (std::size_t i = 0; i < worst().size(); ++i) {
    const auto& item = curve(i);
    if (!item.isVisible()) continue;
    const double found = rate(*item.series(), std::min(time, view().end()));
    if (fastest == nullptr || found > highest) {
      fastest = &item;
      highest = found;
    }
  }
  if (fastest == nullptr) return source().overview().missed.known ? tr("no reading") : tr("no slave has this counter");
  if (highest == 0) return QStringLiteral("0/s");  // in the range, while the legend counts all of the run
  return tr("%1: %2/s").arg(fastest->title().text(), QLocale().toString(highest, 'f', highest < 10 ? 2 : 0));
}

const SeriesItem* Sm2Panel::primary() const { return worst().empty() ? nullptr : &curve(0); }

QString Sm2Panel::valueText(double value) const {
  return QLocale().toString(value, 'f', value == std::floor(value) ? 0 : 1);
}

// ---- DCM error --------------------------------------------------------------------------------

DcmPanel::DcmPanel(TimeView* view, CursorSet* cursors, QWidget* parent)
    : TracePanel(tr("DCM error"), {tr("Error"), TracePlot::Quantity::kTime, 20, false}, view, cursors, parent),
      raw_(plot()->addItem(tr("raw"), SeriesItem::Shape::kEnvelope)),
      filtered_(plot()->addItem(tr("filtered"), SeriesItem::Shape::kLine)),
      other_(addOverlayItem(SeriesItem::Shape::kEnvelope)) {
  setObjectName(QStringLiteral("dcmPanel"));
  plot()->setObjectName(QStringLiteral("dcmPlot"));
  plot()->setToolTip(tr("Time of the frame at the reference clock minus its wanted time in the cycle."));
}

void DcmPanel::attach() {
  raw_->setSeries(nullptr);
  filtered_->setSeries(nullptr);
  if (!hasSource()) return;
  draw(*raw_, Signal::kDcmError);
  draw(*filtered_, Signal::kDcmErrorFiltered);
  showLimit();
}

/// Single late cycles are borne: what is held against the limit is the filtered error.
void DcmPanel::showLimit() {
  limits_ = source().limits();
  const auto limit = limits_.dcm_error_ns;
  plot()->setLimit(static_cast<double>(limit), limit > 0 ? tr("filtered \u00B1%1").arg(timeText(limit)) : QString());
}

void DcmPanel::renew() {
  // A master may be given other ones while it runs.
  if (hasSource() && !(limits_ == source().limits())) showLimit();
}

void DcmPanel::attachOverlay() { drawOverlay(*other_, raw_->title().text(), Signal::kDcmError); }

void DcmPanel::colorItems() {
  raw_->setColor(plot_colors::envelope(palette()));
  filtered_->setColor(plot_colors::trace(palette(), 1));
}

std::vector<LegendBar::Entry> DcmPanel::entries(Nanoseconds time) const {
  std::vector<LegendBar::Entry> result{entry(*raw_, time)};
  nameOwn(result.front());
  if (other_->isVisible()) result.push_back(overlayEntry(*other_, raw_->title().text(), time));
  result.push_back(entry(*filtered_, time));
  return result;
}

QString DcmPanel::summary(Nanoseconds time) const {
  // An imported run has errors without a limit that is known.
  if (source().limits().dcm_error_ns == 0 && !raw_->series()->extent(store().first_time(), store().last_time() + 1))
    return source().overview().master.state == SyncState::kUnknown ? noText() : tr("DCM is off");
  const auto drift = store().value(Signal::kDrift, time);
  return tr("drift %1").arg(drift ? ppmText(static_cast<double>(drift->value)) : QStringLiteral("\u2013"));
}

QString DcmPanel::unitText(const SeriesItem&) const { return QStringLiteral("ns"); }
QString DcmPanel::valueText(double value) const { return signedTimeText(wholeNs(value)); }
QString DcmPanel::remark(Nanoseconds begin, Nanoseconds end) const { return stepText(source(), begin, end); }
QString DcmPanel::spreadText(double half) const { return timeText(wholeNs(std::ceil(half))); }

}  // namespace syncline::ui
