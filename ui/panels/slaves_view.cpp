// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/slaves_view.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "record/run_record.h"
#include "trace/fault_log.h"
#include "ui/models/slave_figures_model.h"
#include "ui/panels/course_delegate.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/heat_legend.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/time_view.h"
#include "ui/text/event_text.h"
#include "ui/text/joined_text.h"
#include "ui/text/message.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spoken_value.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kReadingsATick = 150'000;  // two milliseconds
constexpr unsigned kFiguresEvery = 6;            // ticks: faster cannot be read
constexpr std::size_t kCourseParts = 48;

using FiguresColumn = SlaveFiguresModel::Column;

/// As wide as its heading and what usually stands below it: contents that change move nothing.
int widthOf(const QTableView& table, const SlaveFiguresModel& model, int column) {
  const QString usual[] = {
      QStringLiteral("#100 Servo drive"), QStringLiteral("+999 ns  "),  QStringLiteral("999.999 ms"),
      QStringLiteral("99.999 ms"),        QStringLiteral("+99.999 ms"), QStringLiteral("99.999 ms"),
      QStringLiteral("0.001 %"),          QStringLiteral("9999"),       QString(16, u'0')};
  const int heading = table.horizontalHeader()->fontMetrics().horizontalAdvance(
                          model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()) +
                      26;  // with the mark of the order
  return std::max(heading, table.fontMetrics().horizontalAdvance(usual[column]) + 12);
}

}  // namespace

SlavesView::SlavesView(TimeView* view, CursorSet* cursors, QWidget* parent)
    : QWidget(parent),
      view_(view),
      plot_(named(new HeatMapPlot(view, cursors), "slavesHeatMap", tr("Deviations of all slaves"))),
      legend_(named(new HeatLegend, "slavesLegend", tr("Colours of the deviations"))),
      reading_(named(new ValueLabel, "slavesReading", tr("Reading under the pointer"))),
      model_(new SlaveFiguresModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(named(new QTableView, "slavesTable", tr("Figures of all slaves"))) {
  setObjectName(QStringLiteral("slavesView"));
  setAccessibleName(tr("Slaves"));
  reading_->setLeastCharacters(4);
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(SlaveFiguresModel::kSortRole);
  table_->setModel(sorted_);
  setUpTable(*table_);
  table_->setItemDelegateForColumn(FiguresColumn::kCourse, new CourseDelegate(table_));
  table_->setSortingEnabled(true);
  table_->sortByColumn(FiguresColumn::kMax, Qt::DescendingOrder);
  table_->setFrameShape(QFrame::NoFrame);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 4);
  for (int i = 0; i < SlaveFiguresModel::kColumns; ++i) table_->setColumnWidth(i, widthOf(*table_, *model_, i));
  // The worst at once, the age of a reading for those who look for it.
  auto* header = table_->horizontalHeader();
  header->moveSection(header->visualIndex(FiguresColumn::kMax), 1);
  header->moveSection(header->visualIndex(FiguresColumn::kCourse), 2);
  header->moveSection(header->visualIndex(FiguresColumn::kAge), header->visualIndex(FiguresColumn::kMissed));
  table_->setMinimumWidth(200);
  auto* body = new QSplitter;
  body->setObjectName(QStringLiteral("slavesSplitter"));
  body->setChildrenCollapsible(false);
  body->addWidget(plot_);
  body->addWidget(table_);
  body->setStretchFactor(0, 4);
  body->setStretchFactor(1, 3);
  body->setSizes({500, 440});
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  head->addWidget(legend_);
  head->addWidget(reading_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(head);
  layout->addWidget(body, 1);
  connect(plot_, &HeatMapPlot::pointedChanged, this, &SlavesView::showReading);
  connect(plot_, &HeatMapPlot::slaveSelected, this, &SlavesView::select);
  connect(plot_, &HeatMapPlot::momentActivated, this, &SlavesView::momentChosen);
  connect(plot_, &HeatMapPlot::eventClicked, this, &SlavesView::eventClicked);
  connect(plot_, &HeatMapPlot::menuRequested, this, &SlavesView::menuRequested);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
    plot_->setSelected(selectedInTable());
    showReading();
  });
  connect(table_, &QTableView::activated, this, [this] { plot_->activateSelected(); });
}

void SlavesView::setRecord(const RunRecord* record) {
  record_ = record;
  round_.drop();
  roles_.clear();
  ticks_ = 0;
  begin_ = end_ = 0;
  plot_->setRecord(record);
  model_->setRows({}, 0);
  reading_->clear();
}

void SlavesView::refresh() {
  if (record_ == nullptr || record_->samples().empty()) return;
  if (ticks_ % kFiguresEvery == 0) updateRows();
  plot_->refresh();
  legend_->setScale(plot_->full(), limitOf(record_->limits(), Signal::kSlaveDeviation) > 0);
  updateFigures();
  ++ticks_;
}

/// Who follows is known once it was read.
void SlavesView::updateRows() {
  auto roles = clock_roles(record_->config(), record_->samples(), record_->snapshot().dc.reference_clock);
  if (roles == roles_) return;
  roles_ = std::move(roles);
  std::vector<HeatMapPlot::Row> rows;
  for (std::size_t i = 0; i < roles_.size(); ++i) {
    if (roles_[i] != ClockRole::kNoDc)
      rows.push_back({i, nameOf(*record_, {Signal::kSlaveDeviation, i}), roles_[i] == ClockRole::kReference});
  }
  plot_->setRows(std::move(rows));
  widenNames();
}

/// Names as wide as they are, where the user has not said otherwise; they change with the machine alone.
void SlavesView::widenNames() {
  constexpr int kWidest = 210;
  if (table_->columnWidth(FiguresColumn::kSlave) != widthOf(*table_, *model_, FiguresColumn::kSlave)) return;
  int width = table_->columnWidth(FiguresColumn::kSlave);
  for (std::size_t i = 0; i < roles_.size(); ++i) {
    const auto name = nameOf(*record_, {Signal::kSlaveDeviation, i});
    width = std::max(width, table_->fontMetrics().horizontalAdvance(name) + 14);
  }
  table_->setColumnWidth(FiguresColumn::kSlave, std::min(width, kWidest));
}

bool SlavesView::complete() const {
  return round_.complete() && begin_ == view_->begin() && end_ == view_->end() + 1 && !roles_.empty();
}

void SlavesView::updateFigures() {
  const auto begin = view_->begin();
  const auto end = view_->end() + 1;
  if (round_.complete() && ticks_ % kFiguresEvery == 0 && (begin != begin_ || end != end_)) {
    begin_ = begin;
    end_ = end;
    round_.aim(record_->samples(), begin, end, limitOf(record_->limits(), Signal::kSlaveDeviation));
  }
  if (round_.complete()) return;
  if (round_.work(kReadingsATick)) showFigures();
}

/// Largest magnitudes of equal parts of the range.
QVector<float> SlavesView::courseOf(std::size_t slave) const {
  QVector<float> course(static_cast<int>(kCourseParts), SlaveCells::kNoReading);
  if (slave >= plot_->cells().slaves()) return course;
  const auto cells = plot_->cells().row(slave);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    auto& part = course[static_cast<int>(i * kCourseParts / cells.size())];
    part = std::max(part, cells[i] < 0 ? cells[i] : static_cast<float>(static_cast<double>(cells[i]) / plot_->full()));
  }
  return course;
}

void SlavesView::showFigures() {
  std::vector<SlaveFiguresModel::Row> rows;
  for (std::size_t i = 0; i < round_.figures().size(); ++i) {
    rows.push_back({nameOf(*record_, {Signal::kSlaveDeviation, i}), roles_.at(i), round_.figures()[i], courseOf(i)});
  }
  model_->setRows(std::move(rows), limitOf(record_->limits(), Signal::kSlaveDeviation));
  if (plot_->selected() >= 0 && selectedInTable() < 0) select(plot_->selected());
  showReading();
}

int SlavesView::selectedInTable() const {
  const auto current = sorted_->mapToSource(table_->currentIndex());
  return current.isValid() ? current.row() : -1;
}

void SlavesView::select(int slave) {
  plot_->setSelected(slave);
  if (slave != selectedInTable()) {
    const auto row = sorted_->mapFromSource(model_->index(slave, 0));
    if (row.isValid()) {
      table_->setCurrentIndex(row);
      table_->scrollTo(row);
    } else if (slave < 0) {
      table_->setCurrentIndex({});
    }
  }
  showReading();
}

QString SlavesView::readingText(const HeatMapPlot::Spot& spot) const {
  const auto& samples = record_->samples();
  QStringList said{nameOf(*record_, {Signal::kSlaveDeviation, spot.slave}), runTimeText(spot.time - view_->origin())};
  const float worst = plot_->cells().row(spot.slave)[spot.column];
  const auto reading = worst < 0 ? std::nullopt : samples.value(Signal::kSlaveDeviation, spot.slave, spot.time);
  if (reading) {
    said << signedTimeText(std::llround(reading->value)) << tr("%1 old").arg(timeText(spot.time - reading->time));
  } else if (worst < 0) {
    said << tr("no reading");
  }
  if (worst >= 0 && (!reading || std::abs(reading->value) < worst))
    said << tr("up to %1 in the cell").arg(timeText(std::llround(worst)));
  if (const double limit = limitOf(record_->limits(), Signal::kSlaveDeviation); limit > 0)
    said << tr("limit \u00B1%1").arg(timeText(std::llround(limit)));
  return said.join(QStringLiteral(" \u00B7 "));
}

/// What happened there: the event that the mark is of, and how many more share its place.
QString SlavesView::eventsText(const HeatMapPlot::MarkSpot& spot) const {
  const auto& mark = spot.mark;
  QString first;
  int more = -1;
  for (const auto& note : record_->notes()) {
    if (spot.is_in_row || std::llabs(note.time - mark.time) >= plot_->columnWidth()) continue;
    ++more;
    if (!mark.note || note.time != mark.time || !first.isEmpty()) continue;
    first = QStringList{runTimeText(note.time - view_->origin()), tr("Note"), QString::fromStdString(note.text)}.join(
        QStringLiteral(" \u00B7 "));
  }
  for (const auto& event : record_->events()) {
    if (std::llabs(event.time - mark.time) >= plot_->columnWidth() || meaning_of(event) == EventMeaning::kNews)
      continue;
    if (spot.is_in_row && event.slave != mark.slave) continue;
    ++more;
    if (mark.note || event.time != mark.time || event.slave != mark.slave || !first.isEmpty()) continue;
    const auto message = messageOf(event, record_->config());
    QStringList parts{runTimeText(event.time - view_->origin()), message ? message->source : QString(),
                      briefText(event)};
    parts.removeAll(QString());
    first = parts.join(QStringLiteral(" \u00B7 "));
  }
  return more > 0 ? tr("%1 (and %n more here)", nullptr, more).arg(first) : first;
}

/// Who was farthest off in the range shown.
QString SlavesView::worstText() const {
  const auto& rows = model_->rows();
  const auto off = [](const SlaveFiguresModel::Row& row) {
    return row.figures.statistics.count() > 0 ? row.figures.statistics.max_magnitude() : -1;
  };
  const auto worst = std::ranges::max_element(rows, {}, off);
  if (worst == rows.end() || off(*worst) < 0) return {};
  const int row = static_cast<int>(worst - rows.begin());
  const auto of = [&](int column) { return model_->index(row, column).data().toString(); };
  const double limit = limitOf(record_->limits(), Signal::kSlaveDeviation);
  const auto text = tr("Farthest off is %1: %2").arg(of(SlaveFiguresModel::kSlave), of(SlaveFiguresModel::kMax));
  return limit > 0 ? joinedParts({text, tr("limit \u00B1%1").arg(timeText(std::llround(limit)))}) : text;
}

/// Of the event or the cell under the pointer; without one the marked slave's figures.
void SlavesView::showReading() {
  if (record_ == nullptr) return;
  QString text;
  if (plot_->pointedMark()) {
    text = eventsText(*plot_->pointedMark());
  } else if (plot_->pointed()) {
    text = readingText(*plot_->pointed());
  } else if (const int slave = plot_->selected(); slave >= 0 && slave < model_->rowCount()) {
    const auto of = [&](int column) { return model_->index(slave, column).data().toString(); };
    text = tr("%1: now %2, at most %3")
               .arg(of(SlaveFiguresModel::kSlave), of(SlaveFiguresModel::kNow), of(SlaveFiguresModel::kMax));
  }
  sayValue(*plot_, joinedSentences({text, worstText()}));
  if (text != reading_->text()) reading_->setText(text);
}

}  // namespace syncline::ui
