// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "compare/found_slaves.h"

namespace syncline::ui {

/// What a scan found beside the project, a line a slave; lines that differ can be ticked.
class FoundModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kStatus, kOurs, kFound, kDifference, kColumns };
  enum Role { kKindRole = Qt::UserRole + 1 };

  /// Both outlive the model. All lines that differ are ticked.
  FoundModel(const Project& ours, const Project& found, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<FoundSlave>& lines() const { return lines_; }
  [[nodiscard]] const std::vector<bool>& ticked() const { return ticked_; }
  [[nodiscard]] int count(FoundKind kind) const;
  [[nodiscard]] int tickedCount() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  [[nodiscard]] QString text(const FoundSlave& line, int column) const;
  [[nodiscard]] QString difference(const FoundSlave& line) const;

  const Project& ours_;
  const Project& found_;
  std::vector<FoundSlave> lines_;
  std::vector<bool> ticked_;
};

}  // namespace syncline::ui
