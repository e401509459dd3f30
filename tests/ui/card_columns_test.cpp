// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>

#include "ui/widgets/card.h"

namespace syncline {
namespace {

TEST(CardColumns, ALoneCardIsNoWiderThanOneReads) {
  ui::CardColumns columns;
  auto* card = columns.add(0, QStringLiteral("Mailbox"));
  auto* field = new QLineEdit;
  card->form()->addRow(QStringLiteral("Size"), field);
  columns.addStretch();
  columns.resize(1600, 400);
  columns.show();
  for (int i = 0; i < 3; ++i) QApplication::processEvents();
  EXPECT_LE(card->width(), 640);
  EXPECT_GE(card->width(), 600) << "as wide as it may";
  EXPECT_LT(card->x(), 40) << "at the left";
}

TEST(CardColumns, ShareAPageThatIsNotWider) {
  ui::CardColumns columns;
  std::vector<ui::Card*> cards;
  for (int i = 0; i < 3; ++i) {
    cards.push_back(columns.add(i, QStringLiteral("Card")));
    cards.back()->form()->addRow(QStringLiteral("Size"), new QLineEdit);
  }
  columns.addStretch();
  columns.resize(1000, 400);
  columns.show();
  for (int i = 0; i < 3; ++i) QApplication::processEvents();
  EXPECT_GT(cards.back()->x() + cards.back()->width(), 970) << "all of the width is used";
}

}  // namespace
}  // namespace syncline
