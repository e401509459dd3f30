// SPDX-License-Identifier: Apache-2.0
#pragma once

class QTableView;
class QTreeView;

namespace syncline::ui {

/// The look that all tables share: rows selected as a whole, no grid, no row numbers, compact rows.
void setUpTable(QTableView& view);
/// The same for trees of values.
void setUpTree(QTreeView& view);
/// As high as its rows: for a short table that nobody shall scroll in; after the rows are there.
void fitRows(QTableView& view);
/// Lets one column take the room that the others leave; after the model is set.
void stretchColumn(QTableView& view, int column);

}  // namespace syncline::ui
