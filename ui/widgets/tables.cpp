// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/tables.h"

#include <QHeaderView>
#include <QTableView>
#include <QTreeView>

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

void setUpTree(QTreeView& view) {
  view.setUniformRowHeights(true);
  view.setAlternatingRowColors(true);
  view.setEditTriggers(QAbstractItemView::NoEditTriggers);
  view.setMinimumHeight(120);
  view.header()->setStretchLastSection(true);
  view.header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void fitRows(QTableView& view) {
  view.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto frame = 2 * view.frameWidth();
  view.setFixedHeight(view.horizontalHeader()->sizeHint().height() + view.verticalHeader()->length() + frame);
}

void stretchColumn(QTableView& view, int column) {
  view.horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
}

}  // namespace syncline::ui
