// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/object_write_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include "protocol/object_value.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {

ObjectWriteBar::ObjectWriteBar(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  title_ = new ValueLabel;
  title_->setObjectName(QStringLiteral("objectSelected"));
  value_ = named(new QLineEdit, "objectValue", tr("New value"));
  value_->setMaximumWidth(180);
  words_ = named(new QComboBox, "objectValueWords", tr("Values with names"));
  note_ = new ValueLabel;
  note_->setObjectName(QStringLiteral("objectRange"));
  write_ = named(new QPushButton(tr("&Write")), "objectWrite", tr("Write the value"));
  // Long names end in an ellipsis rather than make the page wider than the window.
  for (auto* label : {title_, note_}) label->setMinimumWidth(100);
  words_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  words_->setMinimumContentsLength(10);
  layout->addWidget(title_, 2);
  layout->addWidget(value_, 1);
  layout->addWidget(words_);
  layout->addWidget(note_, 2);
  layout->addWidget(write_);
  connect(value_, &QLineEdit::textChanged, this, &ObjectWriteBar::check);
  connect(value_, &QLineEdit::returnPressed, this, &ObjectWriteBar::send);
  connect(write_, &QPushButton::clicked, this, &ObjectWriteBar::send);
  connect(words_, &QComboBox::activated, this, [this](int row) { value_->setText(words_->itemData(row).toString()); });
  setEntry({}, nullptr, {}, {});
}

void ObjectWriteBar::setEntry(coe::ObjectAddress object, const DictionaryEntry* entry,
                              const std::vector<std::uint8_t>& bytes, const QString& why) {
  const bool same = entry != nullptr && entry_ && object_ == object && *entry_ == *entry;
  if (same) return;  // what is being typed stays
  object_ = object;
  entry_ = entry == nullptr ? std::nullopt : std::optional(*entry);
  title_->setText(entry == nullptr ? why : QStringLiteral("%1 %2").arg(objectText(object), entry->name));
  words_->clear();
  if (entry != nullptr) {
    for (const auto& word : entry->words) {
      const auto number = QString::number(word.value);
      words_->addItem(QStringLiteral("%1: %2").arg(number, QString::fromStdString(word.text)), number);
    }
  }
  words_->setVisible(words_->count() > 0);
  value_->setVisible(entry != nullptr);
  note_->setVisible(entry != nullptr);
  write_->setVisible(entry != nullptr);
  value_->setText(entry == nullptr || bytes.empty() ? QString()
                                                    : QString::fromStdString(value_text(entry->type, bytes)));
  check();
}

void ObjectWriteBar::setPossible(bool possible) {
  possible_ = possible;
  check();
}

void ObjectWriteBar::check() {
  const bool good = entry_ && typedValue(*entry_, value_->text()).has_value();
  const bool wrong = entry_ && !good && !value_->text().isEmpty();
  write_->setEnabled(good && possible_);
  if (!entry_) return;
  const auto range = rangeText(*entry_);
  const auto kind = range.isEmpty() ? entry_->type_name : QStringLiteral("%1: %2").arg(entry_->type_name, range);
  note_->setText(wrong ? tr("Not possible; %1").arg(kind) : kind);
  auto colors = palette();
  if (wrong) colors.setColor(QPalette::WindowText, theme::toneColor(colors, theme::Tone::kBad));
  note_->setPalette(colors);
}

void ObjectWriteBar::send() {
  if (!write_->isEnabled() || !entry_) return;
  if (auto bytes = typedValue(*entry_, value_->text())) Q_EMIT writeWanted(object_, *bytes);
}

}  // namespace syncline::ui
