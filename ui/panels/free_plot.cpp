// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/free_plot.h"

#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include <QActionGroup>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "trace/counted_at_least.h"
#include "ui/plots/band_item.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/series_csv.h"
#include "ui/plots/view_signals.h"
#include "ui/text/state_text.h"
#include "ui/text/sync_text.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr double kLabelExtent = 50;  // logical pixels

bool isDerived(const SignalSource& source) { return info(source.signal).form == SignalInfo::Form::kDerived; }

QToolButton* headButton(const char* name, const QString& text, const QString& spoken) {
  auto* button = named(new QToolButton, name, spoken);
  button->setText(text);
  button->setToolTip(spoken);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

FreePlot::FreePlot(TimeView* view, CursorSet* cursors, QWidget* parent)
    : TracePanel({}, axisFor({}), view, cursors, parent),
      choose_(headButton("freePlotSignals", tr("Signals…"), tr("Choose signals and axes"))),
      menu_(headButton("freePlotMenu", QStringLiteral("\u22EF"), tr("Menu of this plot"))) {
  // Decades have longer labels: whatever its scale is, a plot has its canvas where the others have theirs.
  for (const auto side : {TracePlot::kLeft, TracePlot::kRight})
    plot()->axisScaleDraw(plot()->axis(side).id())->setMinimumExtent(kLabelExtent);
  addToHead(choose_);
  addToHead(menu_);
  connect(choose_, &QToolButton::clicked, this, &FreePlot::settingsWanted);
  // Not the button's own menu, whose arrow would stand in the dots.
  auto* menu = new QMenu(menu_);
  menu->setObjectName(QStringLiteral("freePlotActions"));
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
  connect(menu_, &QToolButton::clicked, this,
          [this, menu] { menu->popup(menu_->mapToGlobal(menu_->rect().bottomLeft())); });
}

FreePlot::~FreePlot() = default;

void FreePlot::setPlot(const ViewPlot& plot, int number, int count) {
  const bool same =
      plot == shown_ && number == number_ && count == count_ && drawn_derived_ == most_derived_ && !curves_.empty();
  drawn_derived_ = most_derived_;
  number_ = number;
  count_ = count;
  setObjectName(QStringLiteral("freePlot%1").arg(number));
  this->plot()->setObjectName(QStringLiteral("freeCanvas%1").arg(number));
  if (same) return;
  const auto before = std::exchange(shown_, plot);
  curves_.clear();  // they are of the signals before
  TracePanel::setScale(plot.scale);
  for (const auto side : {TracePlot::kLeft, TracePlot::kRight}) {
    const auto& limits = side == TracePlot::kLeft ? plot.left : plot.right;
    const auto& had = side == TracePlot::kLeft ? before.left : before.right;
    if (limits || had || before.signals != plot.signals) TracePanel::setLimits(side, limits);
  }
  TracePanel::setOwnTime(plot.own_time);
  attach();
  if (hasSource()) colorItems();
  refreshText(true);
}

int FreePlot::derivedOf(const ViewPlot& plot) {
  return static_cast<int>(std::ranges::count_if(plot.signals, [](const ViewSignal& signal) {
    const auto* row = rowOf(signal);
    return row != nullptr && row->form == SignalInfo::Form::kDerived;
  }));
}

void FreePlot::follow() {
  if (!hasSource() || source().watched().lists().size() == lists_) return;
  attach();
  colorItems();
}

void FreePlot::refresh() {
  renew();
  plot()->refresh();
}

void FreePlot::setButtons(bool on) {
  choose_->setVisible(on);
  menu_->setVisible(on);
}

/// What all of them have in common, else the number.
QString FreePlot::autoTitle() const {
  const auto& signals = shown_.signals;
  if (signals.empty() || !hasSource()) return tr("Plot %1").arg(number_ + 1);
  const auto owner = ownerOf(source(), signals.front());
  const auto quantity = quantityOf(signals.front());
  if (signals.size() == 1) return nameOf(source(), signals.front());
  const auto all = [&](auto same) { return std::ranges::all_of(signals, same); };
  if (all([&](const ViewSignal& one) { return quantityOf(one) == quantity; })) return quantity;
  if (!owner.isEmpty() && all([&](const ViewSignal& one) { return ownerOf(source(), one) == owner; })) return owner;
  return tr("Plot %1").arg(number_ + 1);
}

/// Without what the heading says of all of them.
QString FreePlot::curveName(const ViewSignal& signal) const {
  const auto title = autoTitle();
  const auto owner = ownerOf(source(), signal);
  if (shown_.title.empty() && shown_.signals.size() > 1) {
    if (!owner.isEmpty() && title == quantityOf(signal)) return owner;
    if (title == owner) return quantityOf(signal);
  }
  return nameOf(source(), signal);
}

void FreePlot::attach() {
  curves_.clear();
  for (auto* item : items_) {
    item->setSeries(nullptr);
    item->setVisible(false);
  }
  for (auto* band : bands_) {
    band->setSeries(nullptr, nullptr, {});
    band->setVisible(false);
  }
  lists_ = hasSource() ? source().watched().lists().size() : 0;
  setTitle(shown_.title.empty() ? autoTitle() : QString::fromStdString(shown_.title));
  layAxes();
  if (!hasSource()) return plot()->markDirty();
  int derived = 0;
  for (std::size_t i = 0; i < shown_.signals.size(); ++i) {
    Curve curve;
    curve.signal = i;
    curve.source = sourceOf(source(), shown_.signals[i]);
    if (curve.source && isDerived(*curve.source) && ++derived > most_derived_) curve.source.reset();
    attachCurve(curve);
    curves_.push_back(std::move(curve));
  }
  showLimit();
  plot()->markDirty();
}

void FreePlot::attachCurve(Curve& curve) {
  if (!curve.source) return;
  const auto& signal = signalOf(curve);
  const auto taken = [](const auto* one) { return one->isVisible(); };
  if (isState(signal)) {
    auto band = std::ranges::find_if_not(bands_, taken);
    if (band == bands_.end()) band = bands_.insert(bands_.end(), plot()->addBand({}));
    curve.band = *band;
    const auto owner = ownerOf(source(), signal);
    curve.band->setTitle(owner.isEmpty() ? quantityOf(signal) : owner);
    curve.band->setVisible(true);
  } else {
    auto item = std::ranges::find_if_not(items_, taken);
    if (item == items_.end()) item = items_.insert(items_.end(), plot()->addItem({}, SeriesItem::Shape::kLine));
    curve.item = *item;
    const bool steps = info(curve.source->signal).form == SignalInfo::Form::kHeld;
    curve.item->setShape(steps ? SeriesItem::Shape::kStep : SeriesItem::Shape::kLine);
    curve.item->setTitle(curveName(signal));
    plot()->setSide(*curve.item, signal.right ? TracePlot::kRight : TracePlot::kLeft);
    if (signal.rate && isCount(signal)) curve.rate = std::make_unique<RateSeries>();
    curve.item->setVisible(true);
  }
  drawCurve(curve);
}

void FreePlot::drawCurve(Curve& curve) {
  if (!curve.source) return;
  const auto signal = curve.source->signal;
  const auto place = curve.source->slave;
  if (curve.band != nullptr) {
    if (curve.band->series() != nullptr) return;
    curve.band->setSeries(&store().series(signal, place), store().held(signal, place), [this, signal](int value) {
      const auto text = stateText(signal, value);
      return BandItem::State{text.text, theme::toneFill(palette(), text.tone), theme::toneColor(palette(), text.tone)};
    });
  } else if (curve.rate != nullptr) {
    curve.rate->extend(*store().held(signal, place));
    if (curve.item->series() != nullptr) return;
    curve.item->setSeries(&curve.rate->rates().series());
    curve.item->setHeldBy(&curve.rate->rates());
  } else {
    draw(*curve.item, signal, place);
  }
}

void FreePlot::renew() {
  // A master may be given other ones while it runs.
  if (hasSource() && !(limits_ == source().limits())) showLimit();
  for (auto& curve : curves_) {
    if (curve.rate != nullptr || (curve.source && isDerived(*curve.source))) drawCurve(curve);
  }
}

void FreePlot::layAxes() {
  for (const auto side : {TracePlot::kLeft, TracePlot::kRight}) {
    std::vector<const ViewSignal*> on;
    for (const auto& signal : shown_.signals) {
      if (!isState(signal) && signal.right == (side == TracePlot::kRight)) on.push_back(&signal);
    }
    auto options = axisFor(on);
    if (on.empty() && std::ranges::any_of(shown_.signals, isState)) options.quantity = tr("State");
    plot()->axis(side).setOptions(options);
  }
}

/// That of the first signal that is held against something.
void FreePlot::showLimit() {
  plot()->setLimit(0, {});
  limit_signal_.reset();
  limits_ = source().limits();
  for (const auto& curve : curves_) {
    if (curve.item == nullptr || curve.rate != nullptr) continue;
    const double limit = limitOf(source().limits(), curve.source->signal);
    if (limit <= 0) continue;
    limit_signal_ = curve.source->signal;
    return plot()->setLimit(limit, tr("limit \u00B1%1").arg(timeText(static_cast<Nanoseconds>(limit))),
                            signalOf(curve).right ? TracePlot::kRight : TracePlot::kLeft);
  }
}

void FreePlot::colorItems() {
  int slot = 0;
  for (auto& curve : curves_) {
    if (curve.item != nullptr) curve.item->setColor(plot_colors::trace(palette(), slot++));
    if (curve.band != nullptr) curve.band->forgetColors();
  }
}

const FreePlot::Curve* FreePlot::curveOf(const SeriesItem& item) const {
  const auto found = std::ranges::find(curves_, &item, &Curve::item);
  return found == curves_.end() ? nullptr : &*found;
}

/// A count whose counter had stood at its end stop, or was cleared, by `time`.
bool FreePlot::atLeast(const Curve& curve, Nanoseconds time) const {
  if (!curve.source || signalOf(curve).rate || info(curve.source->signal).scope != SignalInfo::Scope::kSlave)
    return false;
  return counted_at_least(source().samples(), curve.source->signal, curve.source->slave, time);
}

std::vector<LegendBar::Entry> FreePlot::entries(Nanoseconds time) const {
  std::vector<LegendBar::Entry> result;
  for (const auto& curve : curves_) {
    const auto& signal = signalOf(curve);
    LegendBar::Entry one;
    if (curve.item != nullptr) {
      one = entry(*curve.item, time);
      if (atLeast(curve, time) && one.value != noText()) one.value = QStringLiteral("\u2265 ") + one.value;
    } else {
      one.name = curveName(signal);
      one.color = theme::outline(palette());
      one.shape = SeriesItem::Shape::kEnvelope;
      const auto state = curve.band == nullptr ? QString() : curve.band->stateAt(time);
      one.value = state.isEmpty() ? noText() : state;
      if (curve.band == nullptr) one.value = sourceOf(source(), signal) ? tr("not drawn") : tr("not there");
    }
    one.source = curve.source;
    if (signal.right) one.name = tr("%1 (right)").arg(one.name);
    if (signal.of == ViewSignal::Of::kSlave && curve.source) {
      const auto number = u'#' + QString::number(curve.source->slave);
      one.short_name =
          one.name.startsWith(number) && shown_.title.empty() && autoTitle() == quantityOf(signal) ? number : QString();
    }
    result.push_back(std::move(one));
  }
  return result;
}

QString FreePlot::summary(Nanoseconds) const {
  if (shown_.signals.empty()) return tr("Nothing chosen yet: Signals…");
  const auto* item = primary();
  if (item == nullptr || shown_.signals.size() != 1) return {};
  const auto extent = item->series()->extent(view().begin(), view().end() + 1);
  if (!extent) return {};
  return tr("min %1   max %2")
      .arg(itemText(*item, static_cast<double>(extent->min)), itemText(*item, static_cast<double>(extent->max)));
}

const SeriesItem* FreePlot::primary() const {
  const auto found = std::ranges::find_if(curves_, [](const Curve& curve) { return curve.item != nullptr; });
  return found == curves_.end() ? nullptr : found->item;
}

QString FreePlot::valueText(double value) const { return numberText(value); }

QString FreePlot::itemText(const SeriesItem& item, double value) const {
  const auto* curve = curveOf(item);
  return curve == nullptr ? numberText(value) : valueOf(signalOf(*curve), value);
}

QString FreePlot::unitText(const SeriesItem& item) const {
  const auto* curve = curveOf(item);
  return curve == nullptr ? QString() : unitOf(signalOf(*curve));
}

std::vector<CsvColumn> FreePlot::columns() {
  std::vector<CsvColumn> columns;
  renew();
  for (const auto& curve : curves_) {
    if (!curve.source) continue;
    auto name = keyOf(source(), *curve.source);
    if (curve.rate != nullptr) name += " per s";
    columns.push_back({std::move(name), curve.band != nullptr ? curve.band->series() : curve.item->series()});
  }
  return columns;
}

void FreePlot::change(const ViewPlot& plot) { Q_EMIT edited(plot); }

void FreePlot::setScale(ValueScale scale) {
  auto plot = shown_;
  plot.scale = scale;
  change(plot);
}

void FreePlot::setLimits(TracePlot::Side side, const std::optional<AxisLimits>& limits) {
  auto plot = shown_;
  (side == TracePlot::kLeft ? plot.left : plot.right) = limits;
  change(plot);
}

void FreePlot::setOwnTime(bool own) {
  auto plot = shown_;
  plot.own_time = own;
  change(plot);
}

void FreePlot::fillMenu(QMenu& menu) {
  menu.clear();
  menu.addAction(tr("Signals and axes…"), this, &FreePlot::settingsWanted);
  auto* scales = menu.addMenu(tr("Value scale"));
  auto* group = new QActionGroup(scales);
  for (const auto& [scale, text] :
       {std::pair{ValueScale::kLinear, tr("Linear")}, std::pair{ValueScale::kSignedLog, tr("Signed logarithmic")},
        std::pair{ValueScale::kLog, tr("Logarithmic")}}) {
    auto* action = scales->addAction(text, this, [this, scale = scale] { setScale(scale); });
    action->setCheckable(true);
    action->setChecked(shown_.scale == scale);
    group->addAction(action);
  }
  auto* own = menu.addAction(tr("Own time axis"), this, [this](bool on) { setOwnTime(on); });
  own->setCheckable(true);
  own->setChecked(shown_.own_time);
  auto* out = menu.addMenu(tr("Take out"));
  auto* right = menu.addMenu(tr("Axis at the right"));
  for (std::size_t i = 0; i < shown_.signals.size(); ++i) {
    const auto& signal = shown_.signals[i];
    const auto name = hasSource() ? nameOf(source(), signal) : quantityOf(signal);
    out->addAction(name, this, [this, i] {
      auto plot = shown_;
      plot.signals.erase(plot.signals.begin() + static_cast<std::ptrdiff_t>(i));
      change(plot);
    });
    if (isState(signal)) continue;
    auto* side = right->addAction(name, this, [this, i](bool on) {
      auto plot = shown_;
      plot.signals[i].right = on;
      change(plot);
    });
    side->setCheckable(true);
    side->setChecked(signal.right);
  }
  out->setEnabled(!out->isEmpty());
  right->setEnabled(!right->isEmpty());
  menu.addSeparator();
  menu.addAction(tr("Move up"), this, [this] { Q_EMIT moveWanted(-1); })->setEnabled(number_ > 0);
  menu.addAction(tr("Move down"), this, [this] { Q_EMIT moveWanted(1); })->setEnabled(number_ + 1 < count_);
  menu.addAction(tr("Remove plot"), this, &FreePlot::removeWanted);
}

}  // namespace syncline::ui
