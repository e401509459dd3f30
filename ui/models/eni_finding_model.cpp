// SPDX-License-Identifier: Apache-2.0
#include "ui/models/eni_finding_model.h"

#include <algorithm>
#include <utility>

#include "ui/text/finding_text.h"

namespace syncline::ui {

void EniFindingModel::setFindings(std::vector<Finding> findings) {
  std::ranges::stable_sort(findings, std::ranges::greater{}, &Finding::severity);
  if (findings == rows_) return;
  beginResetModel();
  rows_ = std::move(findings);
  endResetModel();
}

int EniFindingModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant EniFindingModel::cell(const Finding& finding, int column) const {
  switch (column) {
    case kLine:
      return finding.place.line;
    case kRule:
      return codeOf(finding);
    case kFinding:
      return findingWhole(finding);
    default:
      return {};
  }
}

QString EniFindingModel::heading(int column) const {
  switch (column) {
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
