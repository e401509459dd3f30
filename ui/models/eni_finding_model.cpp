// SPDX-License-Identifier: Apache-2.0
#include "ui/models/eni_finding_model.h"

#include <algorithm>
#include <utility>

#include "ui/text/finding_text.h"

namespace syncline::ui {

EniFindingModel::EniFindingModel(QObject* parent) : QAbstractTableModel(parent) {}

void EniFindingModel::setFindings(std::vector<Finding> findings) {
  std::ranges::stable_sort(findings, std::ranges::greater{}, &Finding::severity);
  if (findings == findings_) return;
  beginResetModel();
  findings_ = std::move(findings);
  endResetModel();
}

int EniFindingModel::count(Severity severity) const {
  return static_cast<int>(std::ranges::count(findings_, severity, &Finding::severity));
}

int EniFindingModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(findings_.size());
}

int EniFindingModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant EniFindingModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& finding = findings_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case kLineRole:
      return finding.place.line;
    case kLevelRole:
      return static_cast<int>(finding.severity);
    case Qt::ToolTipRole:
      return findingWhole(finding);
    case Qt::DisplayRole:
      break;
    default:
      return {};
  }
  switch (index.column()) {
    case kSeverity:
      if (finding.severity == Severity::kError) return tr("Error");
      return finding.severity == Severity::kWarning ? tr("Warning") : tr("Note");
    case kLine:
      return finding.place.line;
    case kRule:
      return QString::fromLatin1(finding.code.data(), static_cast<qsizetype>(finding.code.size()));
    case kFinding:
      return findingWhole(finding);
    default:
      return {};
  }
}

QVariant EniFindingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kSeverity:
      return tr("Severity");
    case kLine:
      return tr("Line");
    case kRule:
      return tr("Rule");
    case kFinding:
      return tr("Finding");
    default:
      return {};
  }
}

}  // namespace syncline::ui
