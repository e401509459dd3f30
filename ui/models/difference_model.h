// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <vector>

namespace syncline::ui {

/// Differences in words: where, what, and the two sides.
class DifferenceModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kWhere, kWhat, kLeft, kRight, kColumns };
  enum Role { kKeyRole = Qt::UserRole + 1 };
  struct Line {
    QString where, what, left, right;
    QString key;  // of the setting; empty: none
  };

  /// `left` and `right`: what the two sides are called.
  DifferenceModel(std::vector<Line> lines, const QString& left, const QString& right, QObject* parent = nullptr);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<Line> lines_;
  QStringList titles_;
};

}  // namespace syncline::ui
