// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/record_editor.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>

#include "ui/editors/field_binder.h"
#include "ui/editors/page.h"
#include "ui/editors/record_form.h"
#include "ui/models/record_model.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

constexpr int kLowestTable = 120, kCardBeside = 330;

QWidget* heading(const QString& title, QWidget* none, QWidget* buttons) {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(title);
  auto font = label->font();
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  layout->setSpacing(10);
  layout->addWidget(label);
  layout->addWidget(none, 1);
  layout->addStretch();
  layout->addWidget(buttons);
  return area;
}

}  // namespace

RecordEditor::RecordEditor(Page& page, const char* name, const QString& title, RecordList list,
                           std::vector<RecordPart> parts, bool beside)
    : page_(page), read_(list.read) {
  const auto prefix = QLatin1String(name);
  QStringList titles;
  for (const auto& part : parts) {
    if (part.width < 0) continue;
    columns_.push_back(part);
    titles << part.label;
  }
  model_ = new RecordModel(titles, this);
  table_ = named(new QTableView, "", title);
  table_->setObjectName(prefix + QStringLiteral("Table"));
  setUpTable(*table_);
  table_->setModel(model_);
  table_->setMinimumHeight(kLowestTable);
  for (int i = 0; i < static_cast<int>(columns_.size()); ++i) {
    const int width = columns_[static_cast<std::size_t>(i)].width;
    if (width == 0) {
      stretchColumn(*table_, i);
    } else {
      table_->setColumnWidth(i, width);
    }
  }
  nothing_ = new QLabel(list.nothing);
  nothing_->setWordWrap(true);
  nothing_->setAlignment(Qt::AlignCenter);
  nothing_->setEnabled(false);
  auto* inside = new QVBoxLayout(table_->viewport());
  inside->addWidget(nothing_);
  form_ = new RecordForm(page, std::move(list), std::move(parts), [this] { return row(); });
  auto* layout = new QBoxLayout(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom, this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  auto* left = new QVBoxLayout;
  left->setSpacing(4);
  none_ = new QLabel(tr("none"));
  none_->setEnabled(false);
  none_->setVisible(false);
  left->addWidget(heading(title, none_, form_->makeButtons(prefix)));
  form_->takeKeysOf(*table_);
  left->addWidget(table_, 1);
  layout->addLayout(left, 3);
  card_ = new Card(tr("Selected"));
  form_->addFields(*card_);
  if (beside) card_->setMinimumWidth(kCardBeside);
  layout->addWidget(card_, beside ? 2 : 0, beside ? Qt::AlignTop : Qt::Alignment());
  connect(form_, &RecordForm::rowWanted, this, &RecordEditor::select);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
    if (showing_) return;
    // What was refused belongs to the record that was shown.
    page_.fields().revert();
    page_.refresh();
  });
}

void RecordEditor::foldWhenEmpty() { folds_ = true; }

int RecordEditor::row() const { return table_->currentIndex().row(); }

void RecordEditor::select(int row) {
  page_.fields().commit();
  table_->setCurrentIndex(row < 0 ? QModelIndex() : model_->index(row, 0));
}

void RecordEditor::showRecords() {
  const auto records = read_();
  RecordModel::Lines lines;
  for (std::size_t row = 0; row < records.size(); ++row) {
    QStringList line;
    for (const auto& part : columns_) {
      const auto text = part.text(records, row);
      const bool toggle = part.kind == RecordPart::Kind::kToggle;
      line << (toggle ? (text.isEmpty() ? QString() : QString(QChar(0x2713))) : text);
    }
    lines.push_back(std::move(line));
  }
  showing_ = true;
  nothing_->setVisible(lines.empty());
  const bool folded = folds_ && lines.empty();
  none_->setVisible(folded);
  table_->setVisible(!folded);
  card_->setVisible(!folded);
  model_->setLines(lines);
  if (row() < 0 && !lines.empty()) table_->setCurrentIndex(model_->index(0, 0));
  showing_ = false;
}

void RecordEditor::refreshButtons() { form_->refresh(); }

}  // namespace syncline::ui
