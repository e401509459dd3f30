// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/object_picker.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "config/device_description.h"
#include "ui/models/record_model.h"
#include "ui/models/word_filter.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

bool usable(const ObjectEntry& entry, ObjectUse use) {
  if (use == ObjectUse::kWrite) return entry.writable;
  return use == ObjectUse::kMapOutputs ? entry.rx_mappable : entry.tx_mappable;
}

}  // namespace

std::vector<PickableObject> pickableObjects(const DeviceDescription& device, ObjectUse use) {
  std::vector<PickableObject> all;
  for (const auto& object : device.dictionary) {
    for (const auto& entry : object.entries) {
      if (!usable(entry, use)) continue;
      const auto own = QString::fromStdString(object.name), part = QString::fromStdString(entry.name);
      all.push_back({object.index, entry.sub_index,
                     part.isEmpty() || part == own ? own : QStringLiteral("%1: %2").arg(own, part),
                     QString::fromStdString(entry.data_type), entry.bit_length, entry.default_data});
    }
  }
  return all;
}

ObjectPicker::ObjectPicker(std::vector<PickableObject> objects, QWidget* parent)
    : QDialog(parent), objects_(std::move(objects)) {
  setObjectName(QStringLiteral("objectPicker"));
  setWindowTitle(tr("Choose Object"));
  resize(620, 460);
  auto* layout = new QVBoxLayout(this);
  auto* words = named(new QLineEdit, "objectWords", tr("Search objects"));
  words->setPlaceholderText(tr("Index, name or type"));
  words->setClearButtonEnabled(true);
  layout->addWidget(words);
  auto* model = new RecordModel({tr("Object"), tr("Name"), tr("Type"), tr("Size")}, this);
  RecordModel::Lines lines;
  for (const auto& object : objects_) {
    lines.push_back({objectText(object.index, object.sub_index), object.name, object.type, bitsText(object.bits)});
  }
  model->setLines(lines);
  auto* filter = new WordFilter(RecordModel::kWordsRole, this);
  filter->setSourceModel(model);
  shown_ = filter;
  table_ = named(new QTableView, "objectTable", tr("Objects of the device"));
  setUpTable(*table_);
  table_->setModel(shown_);
  table_->setColumnWidth(0, 92);
  table_->setColumnWidth(2, 100);
  table_->setColumnWidth(3, 72);
  stretchColumn(*table_, 1);
  layout->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  auto* choose = named(buttons->addButton(tr("&Choose"), QDialogButtonBox::AcceptRole), "objectChoose", tr("Choose"));
  layout->addWidget(buttons);
  const auto first = [this] { table_->setCurrentIndex(shown_->index(0, 0)); };
  connect(words, &QLineEdit::textChanged, this, [filter, first](const QString& text) {
    filter->setWords(text);
    first();
  });
  connect(table_, &QTableView::activated, this, &ObjectPicker::pick);
  connect(choose, &QPushButton::clicked, this, &ObjectPicker::pick);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  first();
}

void ObjectPicker::pick() {
  const auto row = shown_->mapToSource(table_->currentIndex()).row();
  if (row < 0) return;
  const auto object = objects_[static_cast<std::size_t>(row)];
  accept();
  Q_EMIT picked(object);
}

}  // namespace syncline::ui
