// SPDX-License-Identifier: Apache-2.0
#include "ui/models/finding_model.h"

#include <algorithm>

#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"

namespace syncline::ui {
namespace {

bool same(const Finding& x, const Finding& y) { return x.code == y.code && x.place == y.place; }

}  // namespace

FindingModel::FindingModel(QObject* parent) : QAbstractTableModel(parent) {}

void FindingModel::setFindings(const std::vector<Finding>& findings) {
  for (int row = 0; row < static_cast<int>(findings.size()); ++row) put(row, findings[static_cast<std::size_t>(row)]);
  const int last = static_cast<int>(rows_.size()) - 1;
  if (last < static_cast<int>(findings.size())) return;
  beginRemoveRows({}, static_cast<int>(findings.size()), last);
  rows_.resize(findings.size());
  endRemoveRows();
}

/// One that is there already moves to its place.
void FindingModel::put(int row, const Finding& finding) {
  const auto begin = rows_.begin() + row;
  const auto found = std::find_if(begin, rows_.end(), [&](const Finding& old) { return same(old, finding); });
  if (found == rows_.end()) {
    beginInsertRows({}, row, row);
    rows_.insert(begin, finding);
    endInsertRows();
    return;
  }
  if (found != begin) {
    const int from = static_cast<int>(found - rows_.begin());
    beginMoveRows({}, from, from, {}, row);
    std::rotate(begin, found, found + 1);
    endMoveRows();
  }
  auto& old = rows_[static_cast<std::size_t>(row)];
  if (old == finding) return;
  old = finding;
  Q_EMIT dataChanged(index(row, 0), index(row, kColumns - 1));
}

int FindingModel::count(Severity at_least) const {
  return static_cast<int>(
      std::ranges::count_if(rows_, [at_least](const Finding& f) { return f.severity >= at_least; }));
}

int FindingModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int FindingModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant FindingModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& finding = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case kLevelRole:
      return static_cast<int>(finding.severity);
    case kSlaveRole:
      return finding.place.slave;
    case kFromRole:
      return static_cast<qint64>(finding.from);
    case kToRole:
      return static_cast<qint64>(finding.to);
    case kKeyRole:
      return findingKey(finding);
    case kCodeRole:
      return QString::fromLatin1(finding.code.data(), static_cast<qsizetype>(finding.code.size()));
    case Qt::ToolTipRole: {
      const auto advice = findingAdvice(finding);
      return advice.isEmpty() ? findingText(finding) : findingText(finding) + QStringLiteral("\n\n") + advice;
    }
    case Qt::DisplayRole:
      break;
    default:
      return {};
  }
  switch (index.column()) {
    case kSeverity:
      if (finding.severity == Severity::kError) return tr("Error");
      return finding.severity == Severity::kWarning ? tr("Warning") : tr("Note");
    case kWhere:
      if (!finding.place.file.empty()) return QString::fromStdString(finding.place.file);
      return finding.place.slave < 0 ? masterWord() : slaveWord() + QStringLiteral(" %1").arg(finding.place.slave);
    case kFinding:
      return findingText(finding);
    case kAdvice:
      return findingAdvice(finding);
    default:
      return {};
  }
}

QVariant FindingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kSeverity:
      return tr("Severity");
    case kWhere:
      return tr("Where");
    case kFinding:
      return tr("Finding");
    case kAdvice:
      return tr("What to do");
    default:
      return {};
  }
}

}  // namespace syncline::ui
