// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/finding_table.h"

namespace syncline::ui {

/// The findings about the project and the running bus, most severe first. Rows that stay keep their place and
/// selection.
class FindingModel final : public FindingTable {
  Q_OBJECT

 public:
  enum Column { kSeverity, kWhere, kFinding, kAdvice, kColumns };

  using FindingTable::FindingTable;
  void setFindings(const std::vector<Finding>& findings);
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;

 protected:
  [[nodiscard]] QVariant cell(const Finding& finding, int column) const override;
  [[nodiscard]] QString heading(int column) const override;

 private:
  void put(int row, const Finding& finding);
};

}  // namespace syncline::ui
