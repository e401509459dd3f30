// SPDX-License-Identifier: Apache-2.0
#include "ui/models/word_filter.h"

#include <algorithm>

#include "ui/text/as_typed.h"

namespace syncline::ui {

WordFilter::WordFilter(int words_role, QObject* parent) : QSortFilterProxyModel(parent), role_(words_role) {
  setRecursiveFilteringEnabled(true);
}

void WordFilter::setWords(const QString& text) {
  words_ = asTyped(text).split(u' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

bool WordFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  if (words_.isEmpty()) return true;
  auto line = sourceModel()->index(row, 0, parent).data(role_).toString();
  if (parent.isValid()) line += u' ' + parent.data(role_).toString();
  line = asTyped(line);
  return std::ranges::all_of(words_, [&](const QString& word) { return line.contains(word, Qt::CaseInsensitive); });
}

}  // namespace syncline::ui
