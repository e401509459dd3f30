// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/distribution_view.h"

#include <fmt/format.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "ui/plots/plot_colors.h"
#include "ui/text/signal_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kPortion = 1'000'000;  // samples a tick, of all signals together: some milliseconds
constexpr std::size_t kBins = 80, kMomentsShown = 500;
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
    : QWidget(parent), view_(view), cursors_(cursors), sources_{Source{}} {
  setObjectName(QStringLiteral("distributionView"));
  setAccessibleName(tr("Distribution"));
  signals_ = named(new QToolButton, "distributionSignals", tr("Signals of the distribution"));
  signals_->setText(tr("Signals"));
  signals_->setToolTip(tr("Up to four signals over each other"));
  signals_->setPopupMode(QToolButton::InstantPopup);
  signals_->setMenu(new QMenu(signals_));
  connect(signals_->menu(), &QMenu::aboutToShow, this, &DistributionView::fillMenu);
  range_ = named(new QComboBox, "distributionRange", tr("Samples that count"));
  range_->addItems({tr("Range shown"), tr("Between the cursors"), tr("Since the figures were armed")});
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

void DistributionView::setRecord(const RunRecord* record) {
  for (auto& count : counts_) count.aim(nullptr, 0, 0, {});
  // What the new one does not have is not asked for.
  if (record != nullptr) {
    std::erase_if(sources_, [&](const Source& source) {
      return info(source.signal).scope == SignalInfo::Scope::kSlave && source.slave >= record->samples().slave_count();
    });
  }
  if (sources_.empty()) sources_ = {Source{}};
  record_ = record;
  grid_ = {};
  moments_->hide();
}

void DistributionView::setSources(std::vector<Source> sources) {
  sources.resize(std::min(sources.size(), kMost));
  sources_ = std::move(sources);
  moments_->hide();
  plot_->setChosen(-2);
  refresh();
}

const MinMaxSeries& DistributionView::series(const Source& source) const {
  return info(source.signal).scope == SignalInfo::Scope::kSlave ? record_->samples().series(source.signal, source.slave)
                                                                : record_->samples().series(source.signal);
}

QString DistributionView::name(const Source& source) const {
  const auto text = signalText(source.signal);
  if (info(source.signal).scope != SignalInfo::Scope::kSlave) return text;
  return u'#' + QString::number(source.slave) + u' ' + QString::fromStdString(record_->slave_name(source.slave));
}

/// Of the first signal that has one.
double DistributionView::limit() const {
  for (const auto& source : sources_) {
    switch (source.signal) {
      case Signal::kDeviation:
      case Signal::kDeviationOred:
      case Signal::kNetworkToSlave:
      case Signal::kSlaveDeviation:
        return record_->limits().deviation_ns;
      case Signal::kDcmError:
      case Signal::kDcmErrorFiltered:
      case Signal::kMasterToNetwork:
        return static_cast<double>(record_->limits().dcm_error_ns);
      default:
        break;
    }
  }
  return 0;
}

std::pair<Nanoseconds, Nanoseconds> DistributionView::range() const {
  switch (static_cast<Range>(range_->currentIndex())) {
    case Range::kCursors:
      if (!cursors_->both()) return {0, 0};
      return std::pair(std::min(*cursors_->at(CursorSet::kA), *cursors_->at(CursorSet::kB)),
                       std::max(*cursors_->at(CursorSet::kA), *cursors_->at(CursorSet::kB)) + 1);
    case Range::kArmed:
      if (!record_->overview().armed) return {0, 0};
      return {*record_->overview().armed, record_->samples().last_time() + 1};
    case Range::kShown:
      break;
  }
  return {view_->begin(), view_->end() + 1};
}

/// Round numbers about everything. What still suits stays: another grid means to count anew.
BinGrid DistributionView::gridFor(Nanoseconds begin, Nanoseconds end) const {
  double low = 0;
  double high = 0;
  for (const auto& source : sources_) {
    const auto extent = series(source).extent(begin, end);
    if (!extent) continue;
    low = std::min(low, static_cast<double>(extent->min));
    high = std::max(high, static_cast<double>(extent->max));
  }
  if (const double most = limit(); axis_->currentIndex() == 1 && most > 0) {
    return {low < 0 ? -2 * most : 0, 2 * most, kBins};
  }
  // Bins of 1, 2 or 5 times a power of ten, of times a nanosecond at least: they are whole.
  const bool whole =
      std::ranges::all_of(sources_, [](const Source& source) { return info(source.signal).unit == "ns"; });
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
  return std::all_of(counts_.begin(), counts_.end(), [](const Distribution& count) { return count.complete(); });
}

void DistributionView::refresh() {
  if (record_ == nullptr || record_->samples().empty()) return;
  const auto [begin, end] = range();
  grid_ = gridFor(begin, end);
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (i >= sources_.size()) {
      counts_[i].aim(nullptr, 0, 0, grid_);
      continue;
    }
    counts_[i].aim(&series(sources_[i]), begin, end, grid_);
    counts_[i].work(kPortion / sources_.size());
  }
  std::vector<HistogramPlot::Steps> steps;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    steps.push_back({name(sources_[i]),
                     plot_colors::trace(palette(), static_cast<int>(i)),
                     {counts_[i].bins().begin(), counts_[i].bins().end()},
                     counts_[i].below(),
                     counts_[i].above()});
  }
  const auto unit = sources_.empty() ? QString() : fromView(info(sources_.front().signal).unit);
  plot_->setData(grid_, std::move(steps), limit(), unit);
  showFigures();
}

void DistributionView::showFigures() {
  const QLocale locale;
  const auto unit = [](const Source& source) { return fromView(info(source.signal).unit); };
  const auto number = [&](double value, const Source& source) {
    return locale.toString(value, 'f', value == std::floor(value) ? 0 : 2) + u' ' + unit(source);
  };
  const int columns = static_cast<int>(sources_.size());
  if (figures_->columnCount() != columns) figures_->setColumnCount(columns);
  QStringList spoken;
  for (int column = 0; column < columns; ++column) {
    const auto& source = sources_[static_cast<std::size_t>(column)];
    const auto& count = counts_[static_cast<std::size_t>(column)];
    auto* header = figures_->horizontalHeaderItem(column);
    if (header == nullptr) figures_->setHorizontalHeaderItem(column, header = new QTableWidgetItem);
    header->setText(name(source));
    header->setForeground(plot_colors::trace(palette(), column));
    int row = 0;
    for (const double fraction : kFractions) {
      const auto value = count.quantile(fraction);
      put(*figures_, row++, column, value ? number(*value, source) : noText());
    }
    const auto extent = count.extent();
    put(*figures_, row++, column, extent ? number(static_cast<double>(extent->max), source) : noText());
    put(*figures_, row, column, countText(count.count()));
    spoken << name(source) + QStringLiteral(": 99.9 % ") + figures_->item(2, column)->text();
  }
  int wide = figures_->verticalHeader()->sizeHint().width() + 4;
  for (int column = 0; column < columns; ++column) {
    const int header =
        figures_->horizontalHeader()->fontMetrics().horizontalAdvance(figures_->horizontalHeaderItem(column)->text());
    figures_->setColumnWidth(column, std::clamp(header + 16, 80, 160));
    wide += figures_->columnWidth(column);
  }
  figures_->setFixedWidth(std::min(wide, 320));
  plot_->setAccessibleDescription(spoken.join(QStringLiteral("; ")));
  double least = 1;
  for (const auto& count : counts_) least = std::min(least, count.progress());
  QString text;
  const auto chosen = static_cast<Range>(range_->currentIndex());
  if (chosen == Range::kCursors && !cursors_->both()) {
    text = tr("Set two cursors: keys A and B");
  } else if (chosen == Range::kArmed && !record_->overview().armed) {
    text = tr("Not armed: the machine has not been ready yet");
  } else if (!complete()) {
    text = tr("Computing, %1 %").arg(static_cast<int>(100 * least));
  }
  state_->setText(text);
}

void DistributionView::listBin(qint64 bin) {
  if (record_ == nullptr || sources_.empty()) return;
  struct Row {
    Distribution::Hit hit;
    std::size_t source;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
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
        locale.toString(static_cast<double>(row.hit.value), 'g', 7) + u' ' +
            fromView(info(sources_[row.source].signal).unit));
    moments_->item(i, 1)->setForeground(plot_colors::trace(palette(), static_cast<int>(row.source)));
  }
  moments_->setColumnWidth(0, 118);
  moments_->horizontalHeader()->setStretchLastSection(true);
  moments_->show();
  moments_->scrollToBottom();
}

void DistributionView::addSource(QMenu& menu, const QString& text, const Source& source) {
  auto* action = menu.addAction(text);
  const bool chosen = std::ranges::find(sources_, source) != sources_.end();
  action->setCheckable(true);
  action->setChecked(chosen);
  action->setEnabled(chosen ? sources_.size() > 1 : sources_.size() < kMost);
  connect(action, &QAction::triggered, this, [this, source](bool on) {
    auto sources = sources_;
    std::erase(sources, source);
    if (on) sources.push_back(source);
    setSources(std::move(sources));
  });
}

void DistributionView::fillMenu() {
  auto& menu = *signals_->menu();
  menu.clear();
  if (record_ == nullptr) return;
  for (const auto& row : signals()) {
    const auto text = signalText(row.id);
    if (!text.isEmpty() && row.scope == SignalInfo::Scope::kBus) addSource(menu, text, {row.id, 0});
  }
  auto* slaves = menu.addMenu(tr("Deviation of a slave"));
  for (std::size_t slave = 0; slave < record_->samples().slave_count(); ++slave) {
    const Source source{Signal::kSlaveDeviation, slave};
    if (!series(source).empty()) addSource(*slaves, name(source), source);
  }
}

std::string DistributionView::csv() const {
  const auto& grid = grid_;
  std::string text = "from,to";
  for (const auto& source : sources_) {
    const auto& row = info(source.signal);
    text += fmt::format(",{}{}", row.key,
                        row.scope == SignalInfo::Scope::kSlave ? fmt::format(" #{}", source.slave) : std::string());
  }
  const auto line = [&](const std::string& from, const std::string& to, auto count) {
    text += '\n' + from + ',' + to;
    for (std::size_t i = 0; i < sources_.size(); ++i)
      fmt::format_to(std::back_inserter(text), ",{}", count(counts_[i]));
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
