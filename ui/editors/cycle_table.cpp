// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/cycle_table.h"

#include <QHeaderView>

#include "advice/cycle_time_help.h"
#include "ui/text/finding_text.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

enum CycleColumn : int { kCycle, kVerdict, kBy, kCycleColumns };
constexpr qsizetype kMostTold = 3;
constexpr int kBetweenRows = 6;  // px

/// The first ones, and how many more there are; one more than those is told as well as counted.
QStringList firstOf(const QStringList& all) {
  const auto left = static_cast<int>(all.size() - kMostTold);
  return left > 1 ? all.first(kMostTold) << CycleTable::tr("%n more", nullptr, left) : all;
}

/// "A, B: why": those who refuse a cycle, or take it with a loss, each reason once.
QStringList refusalsOf(const CycleCandidate& candidate) {
  const bool partly = candidate.accepted();
  QStringList whys;
  QList<QStringList> whos;
  for (const auto& refusal : candidate.refusals) {
    if (refusal.partly != partly) continue;
    const auto why = reasonText(refusal.reason);
    auto at = whys.indexOf(why);
    if (at < 0) {
      at = whys.size();
      whys << why;
      whos << QStringList();
    }
    if (refusal.slave >= 0) whos[at] << QString::fromStdString(refusal.name);
  }
  QStringList lines;
  for (qsizetype i = 0; i < whys.size(); ++i) {
    lines << (whos[i].isEmpty() ? whys[i] : CycleTable::tr("%1: %2").arg(joinedParts(firstOf(whos[i])), whys[i]));
  }
  return lines;
}

QString verdictOf(const CycleCandidate& candidate) {
  if (!candidate.accepted()) return CycleTable::tr("Refused");
  return candidate.refusals.empty() ? CycleTable::tr("Accepted by all") : CycleTable::tr("Taken with a loss");
}

}  // namespace

CycleTable::CycleTable(QWidget* parent) : QTableWidget(0, kCycleColumns, parent) {
  setUpTable(*this);
  setHorizontalHeaderLabels({tr("Cycle"), tr("Slaves"), tr("Because of")});
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setColumnWidth(kCycle, 90);
  setColumnWidth(kVerdict, 180);
  stretchColumn(*this, kBy);
  setWordWrap(true);
  setToolTip(tr("Enter or a double click takes the cycle"));
  connect(this, &QTableWidget::activated, this, [this] {
    if (const auto cycle = markedCycle(); cycle > 0) Q_EMIT cycleTaken(cycle);
  });
}

qint64 CycleTable::markedCycle() const {
  const auto* marked = item(currentRow(), kCycle);
  return marked != nullptr ? marked->data(Qt::UserRole).toLongLong() : 0;
}

void CycleTable::showHelp(const CycleTimeHelp& help) {
  const bool none_marked = currentRow() < 0;
  setRowCount(static_cast<int>(help.candidates.size()));
  for (int i = 0; i < rowCount(); ++i) {
    const auto& candidate = help.candidates[static_cast<std::size_t>(i)];
    auto* cycle = new QTableWidgetItem(cycleText(candidate.cycle));
    cycle->setData(Qt::UserRole, static_cast<qlonglong>(candidate.cycle));
    const bool own = candidate.cycle == help.current.cycle;
    auto font = cycle->font();
    font.setBold(own);
    cycle->setFont(font);
    setItem(i, kCycle, cycle);
    setItem(i, kVerdict, new QTableWidgetItem(verdictOf(candidate)));
    const auto lines = refusalsOf(candidate);
    auto* by = new QTableWidgetItem(firstOf(lines).join(QLatin1Char('\n')));
    by->setToolTip(lines.join(QLatin1Char('\n')));
    setItem(i, kBy, by);
    if (own && none_marked) setCurrentItem(cycle);
  }
  fitRowHeights();
}

void CycleTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  fitRowHeights();
}

/// Lines that belong together stand nearer to each other than to those of the next row.
void CycleTable::fitRowHeights() {
  resizeRowsToContents();
  for (int row = 0; row < rowCount(); ++row) setRowHeight(row, rowHeight(row) + kBetweenRows);
}

QString acceptedCycles(const CycleTimeHelp& help) {
  if (!help.shortest && !help.longest && help.step <= 1) return CycleTable::tr("any cycle");
  const auto shortest = help.shortest ? cycleText(*help.shortest) : noText();
  const auto longest = help.longest ? cycleText(*help.longest) : noText();
  return CycleTable::tr("%1 to %2, in steps of %3").arg(shortest, longest, cycleText(help.step));
}

}  // namespace syncline::ui
