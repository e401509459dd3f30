// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>

namespace syncline::ui {

/// Objects in which all words occur somewhere, with their entries; of the watched ones alone when asked.
class ObjectFilter final : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit ObjectFilter(QObject* parent = nullptr);
  void setWords(const QString& text);
  void setWatchedOnly(bool only);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QStringList words_;
  bool watched_only_ = false;
};

/// The rows that are shown, entries after their object, as comma separated values with a line of titles.
[[nodiscard]] QString tableCsv(const QAbstractItemModel& model);
/// Some of them, columns apart by tabs, for spreadsheets and mails.
[[nodiscard]] QString rowsText(const QModelIndexList& rows);

}  // namespace syncline::ui
