// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/tables.h"

#include <QHeaderView>
#include <QTableView>

namespace syncline::ui {

void setUpTable(QTableView& view) {
  view.setSelectionBehavior(QAbstractItemView::SelectRows);
  view.setSelectionMode(QAbstractItemView::SingleSelection);
  view.setEditTriggers(QAbstractItemView::NoEditTriggers);
  view.setShowGrid(false);
  view.setAlternatingRowColors(true);
  view.setWordWrap(false);
  view.setTabKeyNavigation(false);
  view.verticalHeader()->hide();
  view.verticalHeader()->setDefaultSectionSize(view.fontMetrics().height() + 8);
  view.verticalHeader()->setMinimumSectionSize(view.fontMetrics().height() + 4);
  view.horizontalHeader()->setHighlightSections(false);
  view.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void stretchColumn(QTableView& view, int column) {
  view.horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
}

}  // namespace syncline::ui
