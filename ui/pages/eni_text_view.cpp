// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/eni_text_view.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "ui/models/eni_model.h"
#include "ui/pages/eni_line_delegate.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

/// Longer lines end at the edge; no ENI of ours has one.
constexpr int kMostCharacters = 2'000;

}  // namespace

EniTextView::EniTextView(EniModel& model, QWidget* parent) : QTableView(parent), model_(model) {
  named(this, "eniText", tr("Text of the ENI"));
  setUpTable(*this);
  setSelectionMode(ExtendedSelection);
  setAlternatingRowColors(false);
  setHorizontalScrollMode(ScrollPerPixel);
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setItemDelegate(new EniLineDelegate(this));
  setModel(&model_);
  horizontalHeader()->hide();
  horizontalHeader()->setMinimumSectionSize(8);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // by adaptColumns(): nobody drags them
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setMinimumSectionSize(fontMetrics().height());
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 2);
  setMinimumHeight(3 * verticalHeader()->defaultSectionSize());
}

void EniTextView::adaptColumns() {
  const auto* view = model_.view();
  if (view == nullptr) return;
  const int wide = fontMetrics().horizontalAdvance(u'0');
  const auto digits = QString::number(view->text->lines.size()).size();
  setColumnWidth(EniModel::kLine, static_cast<int>(digits + 1) * wide + 8);
  setColumnWidth(EniModel::kChange, 3 * wide);
  const auto characters = std::min(static_cast<int>(view->widest), kMostCharacters) + 4;
  const int room = viewport()->width() - columnWidth(EniModel::kLine) - columnWidth(EniModel::kChange);
  setColumnWidth(EniModel::kText, std::max(characters * wide, room));
}

void EniTextView::setOutdated(bool outdated) {
  if (outdated == std::exchange(outdated_, outdated)) return;
  viewport()->update();
}

void EniTextView::goToRow(int row, ScrollHint hint) {
  if (row < 0 || row >= model_.rowCount()) return;
  const auto index = model_.index(row, EniModel::kText);
  setCurrentIndex(index);
  scrollTo(index, hint);
}

void EniTextView::scrollTo(const QModelIndex& index, ScrollHint hint) {
  const int sideways = horizontalScrollBar()->value();
  QTableView::scrollTo(index, hint);
  horizontalScrollBar()->setValue(sideways);
}

QString EniTextView::selectedText() const {
  auto rows = selectionModel()->selectedRows(EniModel::kText);
  std::ranges::sort(rows, {}, &QModelIndex::row);
  QStringList lines;
  for (const auto& row : rows) lines.append(row.data().toString());
  return lines.join(u'\n');
}

void EniTextView::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return QGuiApplication::clipboard()->setText(selectedText());
  QTableView::keyPressEvent(event);
}

}  // namespace syncline::ui
