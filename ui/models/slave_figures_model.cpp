// SPDX-License-Identifier: Apache-2.0
#include "ui/models/slave_figures_model.h"

#include <QApplication>
#include <QColor>
#include <QLocale>
#include <QPalette>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/text/units.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr double kNoNumber = -std::numeric_limits<double>::infinity();

/// Two digits that count: "12 %", "0.031 %".
QString shareText(double share) {
  if (share == 0) return QStringLiteral("0\u00A0%");
  return QLocale().toString(100 * share, 'g', share >= 0.1 ? 3 : 2) + QStringLiteral("\u00A0%");
}

}  // namespace

void SlaveFiguresModel::setRows(std::vector<Row> rows, double limit) {
  const bool other = rows.size() != rows_.size();
  if (other) beginResetModel();
  rows_ = std::move(rows);
  limit_ = limit;
  if (other) return endResetModel();
  if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int SlaveFiguresModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SlaveFiguresModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString SlaveFiguresModel::textOf(int row, int column) const {
  const auto& one = rows_[static_cast<std::size_t>(row)];
  const auto& figures = one.figures;
  if (column == kSlave) return one.name;
  if (column == kMissed) return figures.missed ? countText(*figures.missed) : noText();
  if (column == kCourse) return {};
  if (column == kNow && one.role == ClockRole::kReference) return tr("reference");
  if (column == kNow && one.role == ClockRole::kNoDc) return tr("no DC");
  if (column == kNow)
    return figures.is_present ? signedTimeText(wholeNs(static_cast<double>(figures.newest->value))) : noText();
  if (column == kAge) return figures.newest ? timeText(figures.age) : noText();
  const auto& statistics = figures.statistics;
  if (statistics.count() == 0) return noText();
  if (column == kMax) return timeText(wholeNs(statistics.max_magnitude()));
  if (column == kMean) return signedTimeText(wholeNs(statistics.mean()));
  if (column == kRms) return timeText(wholeNs(statistics.rms()));
  const auto share = figures.share_over(limit_);
  return share ? shareText(*share) : noText();
}

/// Of a mean, how sure it is: a column for it would say the same of nearly all.
QString SlaveFiguresModel::tipOf(int row, int column) const {
  const auto text = textOf(row, column);
  const auto& statistics = rows_[static_cast<std::size_t>(row)].figures.statistics;
  if (column != kMean || statistics.count() == 0) return text;
  const auto half = statistics.mean_half_width();
  if (!half) return tr("%1; too few readings, or too alike, to say how sure that is").arg(text);
  return tr("%1; with 95 % certainty the true mean lies in it").arg(withSpreadText(text, half));
}

double SlaveFiguresModel::numberOf(int row, int column) const {
  const auto& figures = rows_[static_cast<std::size_t>(row)].figures;
  const auto& statistics = figures.statistics;
  switch (column) {
    case kSlave:
      return row;
    case kNow:
      return figures.is_present ? std::abs(static_cast<double>(figures.newest->value)) : kNoNumber;
    case kAge:
      return figures.newest ? static_cast<double>(figures.age) : kNoNumber;
    case kMissed:
      return figures.missed ? static_cast<double>(*figures.missed) : kNoNumber;
    case kOver:
      return figures.share_over(limit_).value_or(kNoNumber);
    default:
      break;
  }
  if (statistics.count() == 0) return kNoNumber;
  if (column == kMean) return std::abs(statistics.mean());
  return column == kRms ? statistics.rms() : statistics.max_magnitude();
}

QColor SlaveFiguresModel::colorOf(int row, int column) const {
  const auto& one = rows_[static_cast<std::size_t>(row)];
  const auto colors = QApplication::palette();
  const auto& figures = one.figures;
  const bool over = limit_ > 0 && ((column == kOver && figures.over > 0) ||
                                   ((column == kMax || column == kNow) && numberOf(row, column) > limit_));
  if (over || (column == kMissed && figures.missed.value_or(0) > 0)) return theme::toneColor(colors, theme::Tone::kBad);
  const bool old = column == kAge && figures.newest && !figures.is_present;
  if (old) return theme::toneColor(colors, theme::Tone::kWarning);
  return one.role == ClockRole::kFollower ? QColor() : theme::mutedText(colors);
}

QVariant SlaveFiguresModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  switch (role) {
    case Qt::DisplayRole:
      return textOf(index.row(), index.column());
    case Qt::ToolTipRole:
      return index.column() == kSlave || index.column() == kMean ? tipOf(index.row(), index.column()) : QString();
    case kSortRole:
      return numberOf(index.row(), index.column());
    case kCourseRole:
      return QVariant::fromValue(rows_[static_cast<std::size_t>(index.row())].course);
    case Qt::ForegroundRole:
      if (const auto color = colorOf(index.row(), index.column()); color.isValid()) return color;
      return {};
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignVCenter | (index.column() == kSlave ? Qt::AlignLeft : Qt::AlignRight));
    default:
      return {};
  }
}

QVariant SlaveFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
  const QString names[] = {tr("Slave"), tr("Now"),  tr("Age"),        tr("Max"),   tr("Mean"),
                           tr("RMS"),   tr("Over"), tr("SM2 missed"), tr("Course")};
  const QString tips[] = {tr("By position"),
                          tr("The newest reading; a dash where it is too old to be present"),
                          tr("Of the newest reading, at the end of the range shown"),
                          tr("The largest magnitude of all readings of the range shown"),
                          tr("Of all readings, with their signs; sorted by its magnitude"),
                          tr("Root mean square of all readings, about zero"),
                          tr("Part of the readings whose magnitude is over the limit"),
                          tr("SM2 events missed in the range shown; a dash without such a counter"),
                          tr("The largest magnitudes over the range shown; the top is the limit")};
  if (role == Qt::DisplayRole) return names[section];
  if (role == Qt::ToolTipRole) return tips[section];
  if (role == Qt::TextAlignmentRole)
    return QVariant(Qt::AlignVCenter | (section == kSlave || section == kCourse ? Qt::AlignLeft : Qt::AlignRight));
  return {};
}

}  // namespace syncline::ui
