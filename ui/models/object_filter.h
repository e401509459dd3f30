// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/word_filter.h"

namespace syncline::ui {

/// Objects in which all words occur somewhere, with their entries; of the watched ones alone when asked.
class ObjectFilter final : public WordFilter {
  Q_OBJECT

 public:
  explicit ObjectFilter(QObject* parent = nullptr);
  void setWatchedOnly(bool only);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  bool watched_only_ = false;
};

/// The rows that are shown, entries after their object, as comma separated values with a line of titles. A default is
/// no value that was read: it stands in a column of its own, the last one.
[[nodiscard]] QString tableCsv(const QAbstractItemModel& model);
/// Some of them in the same columns, apart by tabs, for spreadsheets and mails.
[[nodiscard]] QString rowsText(const QModelIndexList& rows);

}  // namespace syncline::ui
