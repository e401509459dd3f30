// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/distribution_view.h"

#include <fmt/format.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "record/run_record.h"
#include "support/csv_field.h"
#include "ui/panels/sample_range.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/histogram_plot.h"
#include "ui/plots/plot_colors.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spoken_value.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kPortion = 1'000'000;  // samples a tick, of all signals together: some milliseconds
constexpr std::size_t kBins = 80, kMomentsShown = 500;
constexpr int kOtherAlpha = 130;  // muted
constexpr std::array kFractions{0.5, 0.99, 0.999, 0.9999};

QTableWidget* makeTable(const char* object_name, const QString& accessible_name) {
  auto* table = named(new QTableWidget, object_name, accessible_name);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->verticalHeader()->setDefaultSectionSize(19);
  table->verticalHeader()->setMinimumSectionSize(17);
  table->horizontalHeader()->setFixedHeight(20);
  table->setFrameShape(QFrame::NoFrame);
  table->setShowGrid(false);
  table->viewport()->setAutoFillBackground(false);
  table->setMinimumHeight(60);
  return table;
}

void put(QTableWidget& table, int row, int column, const QString& text) {
  auto* item = table.item(row, column);
  if (item == nullptr) {
    table.setItem(row, column, item = new QTableWidgetItem);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (item->text() != text) item->setText(text);
}

}  // namespace

DistributionView::DistributionView(const TimeView* view, const CursorSet* cursors, QWidget* parent)
    : QWidget(parent), view_(view) {
  setObjectName(QStringLiteral("distributionView"));
  setAccessibleName(tr("Distribution"));
  signals_ = named(new SignalChooser([](const SignalInfo&) { return true; }), "distributionSignals",
                   tr("Signals of the distribution"));
  signals_->setSources({Source{}});
  connect(signals_, &SignalChooser::variablesWanted, this, &DistributionView::variablesWanted);
  connect(signals_, &SignalChooser::changed, this, [this] {
    moments_->hide();
    plot_->setChosen(-2);
    refresh();
  });
  range_ = named(new SampleRange(view, cursors), "distributionRange", tr("Samples that count"));
  axis_ = named(new QComboBox, "distributionAxis", tr("Value axis of the distribution"));
  axis_->addItems({tr("All values"), tr("Up to twice the limit")});
  state_ = named(new QLabel, "distributionState", tr("State of the distribution"));
  plot_ = named(new HistogramPlot, "histogramPlot", tr("Distribution"));
  figures_ = makeTable("distributionFigures", tr("Quantiles"));
  figures_->setRowCount(static_cast<int>(kFractions.size()) + 2);
  figures_->setVerticalHeaderLabels(
      {tr("50 %"), tr("99 %"), tr("99.9 %"), tr("99.99 %"), tr("Largest"), tr("Samples")});
  moments_ = makeTable("distributionMoments", tr("Samples of the bin"));
  moments_->setColumnCount(2);
  moments_->setToolTip(tr("The latest samples of the bin; a double click shows the moment in the plots"));
  moments_->verticalHeader()->hide();
  moments_->setFixedWidth(210);
  moments_->hide();
  connect(plot_, &HistogramPlot::binClicked, this, &DistributionView::listBin);
  connect(moments_, &QTableWidget::itemActivated, this, [this](const QTableWidgetItem* item) {
    Q_EMIT momentChosen(moments_->item(item->row(), 0)->data(Qt::UserRole).toLongLong());
  });
  auto* controls = new QHBoxLayout;
  controls->setSpacing(6);
  for (QWidget* widget : {static_cast<QWidget*>(signals_), static_cast<QWidget*>(range_), static_cast<QWidget*>(axis_)})
    controls->addWidget(widget);
  controls->addWidget(state_, 1);
  auto* body = new QHBoxLayout;
  body->setSpacing(8);
  body->addWidget(plot_, 1);
  // As high as its rows: below them there would be an empty header.
  figures_->setMaximumHeight(figures_->rowCount() * 19 + 21);
  body->addWidget(figures_, 0, Qt::AlignTop);
  body->addWidget(moments_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(controls);
  layout->addLayout(body, 1);
}

void DistributionView::setRecord(const RunRecord* record, bool recorded) {
  for (auto& count : counts_) count.aim(nullptr, 0, 0, {});
  record_ = record;
  signals_->setRecord(record, recorded);
  if (sources().empty()) signals_->setSources({Source{}});
  grid_ = {};
  moments_->hide();
}

void DistributionView::setOverlay(const TracePanel::Overlay& overlay) {
  if (overlay.record != overlay_.record) {
    others_.clear();
    if (overlay.record != nullptr) others_.resize(kMost);
    figures_->setColumnCount(0);
  }
  overlay_ = overlay;
}

/// A variable's number is that of its run: of another one nothing says that it is the same.
const MinMaxSeries* DistributionView::otherSeries(const Source& source) const {
  if (others_.empty() || source.signal == Signal::kVariable || !isThere(*overlay_.record, source)) return nullptr;
  return &seriesOf(*overlay_.record, source);
}

/// Of the first signal that has one.
double DistributionView::limit() const {
  for (const auto& source : sources()) {
    if (const double limit = limitOf(record_->limits(), source.signal); limit > 0) return limit;
  }
  return 0;
}

/// Round numbers about everything. What still suits stays: another grid means to count anew.
BinGrid DistributionView::gridFor(Nanoseconds begin, Nanoseconds end) const {
  double low = 0;
  double high = 0;
  for (const auto& source : sources()) {
    const auto extent = seriesOf(*record_, source).extent(begin, end);
    if (!extent) continue;
    low = std::min(low, static_cast<double>(extent->min));
    high = std::max(high, static_cast<double>(extent->max));
  }
  for (const auto& source : sources()) {
    const auto* series = otherSeries(source);
    const auto extent = series == nullptr ? std::nullopt : series->extent(begin - overlay_.shift, end - overlay_.shift);
    if (!extent) continue;
    low = std::min(low, static_cast<double>(extent->min));
    high = std::max(high, static_cast<double>(extent->max));
  }
  if (const double most = limit(); axis_->currentIndex() == 1 && most > 0) {
    return {low < 0 ? -2 * most : 0, 2 * most, kBins};
  }
  // Bins of 1, 2 or 5 times a power of ten, of times a nanosecond at least: they are whole.
  const bool whole =
      std::ranges::all_of(sources(), [](const Source& source) { return info(source.signal).unit == "ns"; });
  const double span = std::max(high - low, whole ? 10.0 : 1e-3);
  const double least = span * 1.3 / static_cast<double>(kBins);
  const double power = std::pow(10, std::floor(std::log10(least)));
  double width = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= least) width = factor * power;
  }
  if (whole) width = std::max(width, 1.0);
  const bool suits = low >= grid_.low && high < grid_.high &&
                     grid_.high - grid_.low<4 * span&& static_cast<double>(grid_.bins)> 8 &&
                     (!whole || grid_.width() >= 1);
  if (suits && grid_ != BinGrid{}) return grid_;
  const double first = low < 0 ? std::floor((low - 0.15 * span) / width) * width : 0;
  const auto bins = static_cast<std::size_t>(std::ceil((high + 0.15 * span - first) / width)) + 1;
  return {first, first + static_cast<double>(bins) * width, bins};
}

bool DistributionView::complete() const {
  const auto all = [](const auto& counts) {
    return std::all_of(counts.begin(), counts.end(), [](const Distribution& count) { return count.complete(); });
  };
  return all(counts_) && all(others_);
}

void DistributionView::refresh() {
  if (record_ == nullptr || record_->samples().empty()) return;
  const auto [begin, end] = range_->of(*record_);
  grid_ = gridFor(begin, end);
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (i >= sources().size()) {
      counts_[i].aim(nullptr, 0, 0, grid_);
      continue;
    }
    counts_[i].aim(&seriesOf(*record_, sources()[i]), begin, end, grid_);
    counts_[i].work(kPortion / sources().size());
  }
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const auto* series = i < sources().size() ? otherSeries(sources()[i]) : nullptr;
    others_[i].aim(series, begin - overlay_.shift, end - overlay_.shift, grid_);
    others_[i].work(kPortion / std::max<std::size_t>(sources().size(), 1));
  }
  std::vector<HistogramPlot::Steps> steps;
  const auto add = [&steps](const QString& name, const QColor& color, const Distribution& count) {
    steps.push_back({name, color, {count.bins().begin(), count.bins().end()}, count.below(), count.above()});
  };
  for (const auto& column : columns()) add(column.name, column.color, *column.count);
  const auto unit = sources().empty() ? QString() : fromView(info(sources().front().signal).unit);
  plot_->setData(grid_, std::move(steps), limit(), unit);
  showFigures();
}

/// Each signal, and behind it the same of the other recording.
std::vector<DistributionView::Column> DistributionView::columns() const {
  std::vector<Column> all;
  for (std::size_t i = 0; i < sources().size(); ++i) {
    const auto& source = sources()[i];
    const auto name = nameOf(*record_, source);
    auto color = plot_colors::trace(palette(), static_cast<int>(i));
    const bool both = otherSeries(source) != nullptr;
    all.push_back({both ? tr("%1 (%2)").arg(name, overlay_.own) : name, color, source, &counts_[i],
                   isUpperEstimate(*record_, source.signal)});
    if (!both) continue;
    color.setAlpha(kOtherAlpha);
    all.push_back({tr("%1 (%2)").arg(name, overlay_.other), color, source, &others_[i],
                   isUpperEstimate(*overlay_.record, source.signal)});
  }
  return all;
}

void DistributionView::showFigures() {
  const QLocale locale;
  const auto unit = [](const Source& source) { return fromView(info(source.signal).unit); };
  const auto number = [&](double value, const Source& source) {
    if (source.signal == Signal::kVariable) return numberText(value);
    // A quantile is exact to a part of its value: more digits say nothing.
    const auto size = std::abs(value);
    const int digits = value == std::floor(value) || size >= 100 ? 0 : size >= 10 ? 1 : 2;
    return locale.toString(value, 'f', digits) + u' ' + unit(source);
  };
  const auto shown = columns();
  const int count_of_columns = static_cast<int>(shown.size());
  if (figures_->columnCount() != count_of_columns) figures_->setColumnCount(count_of_columns);
  QStringList spoken;
  for (int column = 0; column < count_of_columns; ++column) {
    const auto& [name, color, source, count, is_estimate] = shown[static_cast<std::size_t>(column)];
    auto* header = figures_->horizontalHeaderItem(column);
    if (header == nullptr) figures_->setHorizontalHeaderItem(column, header = new QTableWidgetItem);
    header->setText(name);
    header->setForeground(color);
    int row = 0;
    const auto put_number = [&, &of = source, &is_above = is_estimate](std::optional<double> value) {
      const auto text = value ? number(*value, of) : noText();
      put(*figures_, row++, column, value && is_above ? atMostText(text) : text);
    };
    for (const double fraction : kFractions) put_number(count->quantile(fraction));
    const auto extent = count->extent();
    put_number(extent ? std::optional(static_cast<double>(extent->max)) : std::nullopt);
    put(*figures_, row, column, countText(count->count()));
    spoken << name + QStringLiteral(": 99.9 % ") + figures_->item(2, column)->text();
  }
  int wide = figures_->verticalHeader()->sizeHint().width() + 4;
  for (int column = 0; column < count_of_columns; ++column) {
    const int header =
        figures_->horizontalHeader()->fontMetrics().horizontalAdvance(figures_->horizontalHeaderItem(column)->text());
    figures_->setColumnWidth(column, std::clamp(header + 16, 80, 160));
    wide += figures_->columnWidth(column);
  }
  figures_->setFixedWidth(std::min(wide, 320));
  sayValue(*plot_, joinedClauses(spoken));
  double least = 1;
  for (const auto& count : counts_) least = std::min(least, count.progress());
  for (const auto& count : others_) least = std::min(least, count.progress());
  auto text = range_->lack(*record_);
  if (text.isEmpty() && !complete()) text = tr("Computing, %1 %").arg(static_cast<int>(100 * least));
  if (text.isEmpty() && !sources().empty()) text = binText();
  state_->setText(text);
}

/// "each bar 5 ns wide"
QString DistributionView::binText() const {
  const auto unit = fromView(info(sources().front().signal).unit);
  const auto width = QLocale().toString(grid_.width(), 'g', 4) + (unit.isEmpty() ? QString() : u' ' + unit);
  return tr("each bar %1 wide").arg(width);
}

void DistributionView::listBin(qint64 bin) {
  if (record_ == nullptr || sources().empty()) return;
  struct Row {
    Distribution::Hit hit;
    std::size_t source;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < sources().size(); ++i) {
    for (const auto& hit : counts_[i].hits(static_cast<std::ptrdiff_t>(bin), kMomentsShown)) rows.push_back({hit, i});
  }
  std::ranges::stable_sort(rows, {}, [](const Row& row) { return row.hit.time; });
  moments_->setHorizontalHeaderLabels({tr("Time since start"), tr("Value")});
  moments_->setRowCount(static_cast<int>(rows.size()));
  const QLocale locale;
  for (int i = 0; i < moments_->rowCount(); ++i) {
    const auto& row = rows[static_cast<std::size_t>(i)];
    const auto since = static_cast<double>(row.hit.time - view_->origin()) / 1e9;
    put(*moments_, i, 0, tr("%1 s").arg(locale.toString(since, 'f', 6)));
    moments_->item(i, 0)->setData(Qt::UserRole, static_cast<qlonglong>(row.hit.time));
    put(*moments_, i, 1,
        (locale.toString(static_cast<double>(row.hit.value), 'g', 7) + u' ' +
         fromView(info(sources()[row.source].signal).unit))
            .trimmed());
    moments_->item(i, 1)->setForeground(plot_colors::trace(palette(), static_cast<int>(row.source)));
  }
  moments_->setColumnWidth(0, 118);
  moments_->horizontalHeader()->setStretchLastSection(true);
  moments_->show();
  moments_->scrollToBottom();
}

std::string DistributionView::csv() const {
  const auto& grid = grid_;
  std::string text = "from,to";
  for (const auto& source : sources())
    text += ',' + (record_ == nullptr ? std::string(info(source.signal).key) : csv_field(keyOf(*record_, source)));
  for (std::size_t i = 0; i < sources().size() && !others_.empty(); ++i)
    text += ',' + csv_field(keyOf(*record_, sources()[i]) + " (" + overlay_.other.toStdString() + ')');
  const auto line = [&](const std::string& from, const std::string& to, auto count) {
    text += '\n' + from + ',' + to;
    for (std::size_t i = 0; i < sources().size(); ++i)
      fmt::format_to(std::back_inserter(text), ",{}", count(counts_[i]));
    for (std::size_t i = 0; i < sources().size() && !others_.empty(); ++i)
      fmt::format_to(std::back_inserter(text), ",{}", count(others_[i]));
  };
  const auto edge = [&](std::size_t bin) {
    return fmt::format("{:.9g}", grid.low + static_cast<double>(bin) * grid.width());
  };
  line({}, edge(0), [](const Distribution& count) { return count.below(); });
  for (std::size_t bin = 0; bin < grid.bins; ++bin) {
    line(edge(bin), edge(bin + 1),
         [bin](const Distribution& count) { return bin < count.bins().size() ? count.bins()[bin] : 0; });
  }
  line(edge(grid.bins), {}, [](const Distribution& count) { return count.above(); });
  return text + '\n';
}

}  // namespace syncline::ui
