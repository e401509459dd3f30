// SPDX-License-Identifier: Apache-2.0
#include "ui/models/eni_model.h"

#include <algorithm>
#include <utility>

namespace syncline::ui {
namespace {

/// Lines that stay around each change.
constexpr std::uint32_t kAround = 3;

QString changeMark(EniRowKind kind) {
  switch (kind) {
    case EniRowKind::kAdded:
      return QStringLiteral("+");
    case EniRowKind::kRemoved:
      return QStringLiteral("\u2212");
    case EniRowKind::kAltered:
      return QStringLiteral("~");
    case EniRowKind::kBefore:
      return QStringLiteral("\u2190");
    case EniRowKind::kSame:
      break;
  }
  return {};
}

/// Of lines that depend on a setting.
QString dependentWord(EniRowKind kind) {
  const bool ghost = kind == EniRowKind::kBefore || kind == EniRowKind::kRemoved;
  if (kind == EniRowKind::kSame) return {};
  return ghost ? EniModel::tr("with the other value") : EniModel::tr("depends on the setting");
}

QString changeWord(EniRowKind kind) {
  switch (kind) {
    case EniRowKind::kAdded:
      return EniModel::tr("added");
    case EniRowKind::kRemoved:
      return EniModel::tr("removed");
    case EniRowKind::kAltered:
      return EniModel::tr("altered");
    case EniRowKind::kBefore:
      return EniModel::tr("before");
    case EniRowKind::kSame:
      break;
  }
  return {};
}

char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool holds(std::string_view line, const std::string& words) {
  return std::search(line.begin(), line.end(), words.begin(), words.end(),
                     [](char x, char y) { return lowered(x) == y; }) != line.end();
}

}  // namespace

EniModel::EniModel(QObject* parent) : QAbstractTableModel(parent) {}

void EniModel::setView(std::shared_ptr<const EniView> view) {
  beginResetModel();
  view_ = std::move(view);
  choose();
  endResetModel();
}

void EniModel::setOnlyChanges(bool only) {
  if (only == only_changes_) return;
  beginResetModel();
  only_changes_ = only;
  choose();
  endResetModel();
}

void EniModel::choose() {
  chosen_.reset();
  if (!only_changes_ || view_ == nullptr || view_->before == nullptr) return;
  auto& chosen = chosen_.emplace();
  const auto rows = static_cast<std::uint32_t>(view_->rows.size());
  std::uint32_t next = 0;
  const auto leaveOut = [&](std::uint32_t end) {
    if (end > next) chosen.push_back({next, end - next});
    next = std::max(next, end);
  };
  for (const auto change : view_->changes) {
    leaveOut(change > kAround ? change - kAround : 0);
    auto end = change;
    while (end < rows && view_->rows[end].kind != EniRowKind::kSame) ++end;
    for (end = std::min(end + kAround, rows); next < end; ++next) chosen.push_back({next, 0});
  }
  leaveOut(rows);
}

EniModel::Shown EniModel::shown(int row) const {
  return chosen_ ? (*chosen_)[static_cast<std::size_t>(row)] : Shown{static_cast<std::uint32_t>(row), 0};
}

int EniModel::modelRow(std::size_t view_row) const {
  if (!chosen_) return static_cast<int>(view_row);
  const auto after = std::ranges::upper_bound(*chosen_, view_row, {}, &Shown::row);
  return std::max(static_cast<int>(after - chosen_->begin()) - 1, 0);
}

int EniModel::rowOf(std::size_t line) const {
  return view_ == nullptr || view_->rows.empty() ? -1 : modelRow(view_->row_of(line));
}

std::size_t EniModel::lineAt(int row) const {
  return view_ == nullptr || row < 0 || row >= rowCount() ? 0 : view_->line_at(shown(row).row);
}

int EniModel::changeFrom(int row, bool forward) const {
  if (view_ == nullptr || view_->changes.empty()) return -1;
  const auto& changes = view_->changes;
  const auto here = row < 0 ? 0 : shown(row).row;
  if (forward) {
    const auto next = row < 0 ? changes.begin() : std::ranges::upper_bound(changes, here);
    return modelRow(next == changes.end() ? changes.front() : *next);
  }
  const auto next = std::ranges::lower_bound(changes, here);
  return modelRow(next == changes.begin() ? changes.back() : *(next - 1));
}

int EniModel::find(const QString& words, int row, bool forward) const {
  const int rows = rowCount();
  auto wanted = words.toStdString();
  std::ranges::transform(wanted, wanted.begin(), lowered);
  if (wanted.empty()) return -1;
  for (int step = 1; step <= rows; ++step) {
    const int at = ((forward ? row + step : row - step) % rows + rows) % rows;
    const auto line = shown(at);
    if (line.left_out == 0 && holds(view_->line(view_->rows[line.row]), wanted)) return at;
  }
  return -1;
}

int EniModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid() || view_ == nullptr) return 0;
  return static_cast<int>(chosen_ ? chosen_->size() : view_->rows.size());
}

int EniModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString EniModel::text(std::size_t view_row) const {
  const auto line = view_->line(view_->rows[view_row]);
  return QString::fromUtf8(line.data(), static_cast<qsizetype>(line.size()));
}

QString EniModel::other(std::size_t view_row) const {
  const auto kind = view_->rows[view_row].kind;
  if (kind == EniRowKind::kBefore) return text(view_row + 1);
  return kind == EniRowKind::kAltered ? text(view_row - 1) : QString();
}

QVariant EniModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto line = shown(index.row());
  const auto& row = view_->rows[line.row];
  const bool gap = line.left_out > 0;
  switch (role) {
    case kGapRole:
      return gap;
    case kKindRole:
      return static_cast<int>(gap ? EniRowKind::kSame : row.kind);
    case kOtherRole:
      return gap ? QString() : other(line.row);
    case Qt::TextAlignmentRole:
      if (index.column() == kText) return {};
      return (index.column() == kLine ? Qt::AlignRight | Qt::AlignVCenter : Qt::Alignment(Qt::AlignCenter)).toInt();
    case Qt::AccessibleTextRole:
    case Qt::ToolTipRole:
      if (index.column() == kChange)
        return gap ? QString() : view_->trial ? dependentWord(row.kind) : changeWord(row.kind);
      if (role == Qt::ToolTipRole) return {};
      [[fallthrough]];
    case Qt::DisplayRole:
      if (gap)
        return index.column() == kText ? tr("… %n line(s) …", nullptr, static_cast<int>(line.left_out)) : QString();
      if (index.column() == kLine) return row.ghost() ? QVariant() : QVariant(row.line + 1);
      return index.column() == kChange ? changeMark(row.kind) : text(line.row);
    default:
      return {};
  }
}

QVariant EniModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kLine:
      return tr("Line");
    case kChange:
      return tr("Change");
    case kText:
      return tr("ENI");
    default:
      return {};
  }
}

}  // namespace syncline::ui
