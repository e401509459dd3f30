// SPDX-License-Identifier: Apache-2.0
#include "ui/models/finding_model.h"

#include <algorithm>

#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"

namespace syncline::ui {
namespace {

bool same(const Finding& x, const Finding& y) { return x.code == y.code && x.place == y.place; }

}  // namespace

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

int FindingModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant FindingModel::cell(const Finding& finding, int column) const {
  switch (column) {
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

QString FindingModel::heading(int column) const {
  switch (column) {
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
