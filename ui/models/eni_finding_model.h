// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/finding_table.h"

namespace syncline::ui {

/// What the checker says of the lines of an ENI, the worst first.
class EniFindingModel final : public FindingTable {
  Q_OBJECT

 public:
  enum Column { kSeverity, kLine, kRule, kFinding, kColumns };

  using FindingTable::FindingTable;
  void setFindings(std::vector<Finding> findings);
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;

 protected:
  [[nodiscard]] QVariant cell(const Finding& finding, int column) const override;
  [[nodiscard]] QString heading(int column) const override;
};

}  // namespace syncline::ui
