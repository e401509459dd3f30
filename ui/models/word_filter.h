// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>

namespace syncline::ui {

/// The rows in which all words occur somewhere, in any order; rows below bring their parent, and a parent that fits
/// itself brings all of them.
class WordFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  /// `words_role`: of the first column, what one may search for.
  explicit WordFilter(int words_role, QObject* parent = nullptr);
  void setWords(const QString& text);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  int role_;
  QStringList words_;
};

}  // namespace syncline::ui
