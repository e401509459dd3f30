// SPDX-License-Identifier: Apache-2.0
#include "ui/models/finding_table.h"

#include <algorithm>

#include "ui/text/finding_text.h"
#include "ui/text/units.h"

namespace syncline::ui {

int FindingTable::count(Severity severity) const {
  return static_cast<int>(std::ranges::count(rows_, severity, &Finding::severity));
}

int FindingTable::countFrom(Severity at_least) const {
  return static_cast<int>(
      std::ranges::count_if(rows_, [at_least](const Finding& one) { return one.severity >= at_least; }));
}

int FindingTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QString FindingTable::codeOf(const Finding& finding) { return fromView(finding.code); }

QVariant FindingTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& one = finding(index.row());
  switch (role) {
    case kLevelRole:
      return static_cast<int>(one.severity);
    case kSlaveRole:
      return one.place.slave;
    case kFromRole:
      return static_cast<qint64>(one.from);
    case kToRole:
      return static_cast<qint64>(one.to);
    case kKeyRole:
      return findingKey(one);
    case kCodeRole:
      return codeOf(one);
    case kLineRole:
      return one.place.line;
    case Qt::ToolTipRole: {
      const auto advice = findingAdvice(one);
      return advice.isEmpty() ? findingText(one) : findingText(one) + QStringLiteral("\n\n") + advice;
    }
    case Qt::DisplayRole:
      break;
    default:
      return {};
  }
  if (index.column() != 0) return cell(one, index.column());
  if (one.severity == Severity::kError) return tr("Error");
  return one.severity == Severity::kWarning ? tr("Warning") : tr("Note");
}

QVariant FindingTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == 0 ? tr("Severity") : heading(section);
}

}  // namespace syncline::ui
