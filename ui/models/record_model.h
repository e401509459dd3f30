// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <vector>

namespace syncline::ui {

/// Records of a list as lines of words. Lines that stay keep their place and selection.
class RecordModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  using Lines = std::vector<QStringList>;
  static constexpr int kWordsRole = Qt::UserRole + 1;  // the whole line
  explicit RecordModel(QStringList titles, QObject* parent = nullptr);

  /// Each line has a word for each title.
  void setLines(const Lines& lines);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QStringList titles_;
  Lines lines_;
};

}  // namespace syncline::ui
