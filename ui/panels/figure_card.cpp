// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/figure_card.h"

#include "ui/text/joined_text.h"
#include "ui/widgets/spoken_value.h"
#include "ui/widgets/value_label.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace syncline::ui {
namespace {

constexpr int kLeastOfFigure = 14;

void setColor(QLabel& label, const QColor& color) {
  QPalette palette;  // of nothing else: the rest follows the theme, or a picture
  palette.setColor(QPalette::WindowText, color);
  label.setPalette(palette);
}

/// What says nothing takes no room.
void setTextOf(QLabel& label, const QString& text) {
  if (label.text() != text) label.setText(text);
  if (label.isHidden() != text.isEmpty()) label.setVisible(!text.isEmpty());
}

}  // namespace

FigureCard::FigureCard(const char* name, const QString& title, const QString& tool_tip, QWidget* parent)
    : QFrame(parent), title_(new ValueLabel), main_(new QLabel), note_(new QLabel), grid_(new QGridLayout) {
  speaksValue(*this);
  setObjectName(QLatin1String(name));
  setAccessibleName(title);
  setToolTip(tool_tip);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  auto bold = font();
  bold.setWeight(QFont::DemiBold);
  // Where a language needs more room than there is, a second line has it, or pointing at it tells the rest.
  title_->setWordWrap(true);
  title_->setFont(bold);
  auto big = font();
  big.setPointSizeF(big.pointSizeF() * 1.7);
  big.setWeight(QFont::DemiBold);
  main_->setFont(big);
  main_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  main_->setAccessibleName(title);
  note_->setWordWrap(true);
  note_->setAccessibleName(tr("Margin: %1").arg(title));
  for (auto* label : {title_, main_, note_}) {
    // The cards share the width; a long figure must not push the others away.
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  }
  title_->setText(title);  // with the policy: only then it asks for the height that its lines need
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(0);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  layout->addWidget(title_);
  layout->addWidget(main_);
  layout->addWidget(note_);
  layout->addLayout(grid_);
  layout->addStretch(1);
  for (auto* label : {main_, note_}) label->hide();
}

std::size_t FigureCard::addFigure(const QString& label, const QString& tool_tip) {
  const int row = static_cast<int>(figures_.size());
  auto* name = new QLabel(label);
  // A long figure must not make the window wider.
  auto* value = new ValueLabel;
  value->setLeastCharacters(kLeastOfFigure);
  for (QLabel* part : {name, static_cast<QLabel*>(value)}) part->setToolTip(tool_tip);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setAccessibleName(joinedParts({label, title_->text()}));
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid_->addWidget(name, row, 0);
  grid_->addWidget(value, row, 1);
  grid_->setColumnStretch(1, 1);
  labels_.push_back(name);
  figures_.push_back(value);
  colorText();
  return figures_.size() - 1;
}

/// All of it in one sentence: a reader that stands on the card needs not look for its parts.
void FigureCard::say() {
  QStringList said{main_->text(), note_->text()};
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    if (!figures_[i]->text().isEmpty()) said << tr("%1: %2").arg(labels_[i]->text(), figures_[i]->text());
  }
  sayValue(*this, joinedClauses(said));
}

void FigureCard::setMain(const QString& text) {
  if (text == mainText()) return;
  setTextOf(*main_, text);
  say();
}

void FigureCard::setNote(theme::Tone tone, const QString& text) {
  if (text != noteText()) {
    setTextOf(*note_, text);
    say();
  }
  if (tone == tone_) return;
  tone_ = tone;
  colorText();
}

void FigureCard::setFigure(std::size_t number, const QString& text, const QString& shorter) {
  if (text == figureText(number)) return;
  figures_.at(number)->setText(text, shorter);
  figures_.at(number)->setVisible(!text.isEmpty());
  say();
}

QString FigureCard::mainText() const { return main_->text(); }
QString FigureCard::noteText() const { return note_->text(); }
QString FigureCard::figureText(std::size_t number) const { return figures_.at(number)->text(); }

QStringList FigureCard::lines() const {
  QStringList all{QStringList{title_->text(), main_->text(), note_->text()}.join(u'\t')};
  for (std::size_t i = 0; i < figures_.size(); ++i)
    all << QStringList{joinedParts({title_->text(), labels_[i]->text()}), figures_[i]->text()}.join(u'\t');
  return all;
}

void FigureCard::colorText() {
  for (auto* label : labels_) setColor(*label, theme::mutedText(palette()));
  setColor(*note_, theme::toneColor(palette(), tone_));
}

void FigureCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme::outline(palette()));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
}

void FigureCard::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorText();
}

}  // namespace syncline::ui
