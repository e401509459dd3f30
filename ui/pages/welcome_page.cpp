// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/welcome_page.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace syncline::ui {

WelcomePage::WelcomePage(const QList<QAction*>& beginnings, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("welcomePage"));
  setAccessibleName(tr("Welcome"));
  auto* layout = new QVBoxLayout(this);
  layout->addStretch(2);
  mark_ = new QLabel;
  mark_->setAlignment(Qt::AlignCenter);
  layout->addWidget(mark_);
  drawMark();
  auto* title = new QLabel(tr("Configure a machine, run it, and see it in sync"));
  title->setAlignment(Qt::AlignCenter);
  auto font = title->font();
  font.setPointSizeF(font.pointSizeF() * 1.35);
  font.setWeight(QFont::DemiBold);
  title->setFont(font);
  layout->addWidget(title);
  auto* hint = new QLabel(tr("Begin with the simulated demonstration machine, a bus, or a project file."));
  hint->setAlignment(Qt::AlignCenter);
  hint->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(hint);
  layout->addSpacing(14);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addStretch(1);
  for (auto* action : beginnings) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setObjectName(QStringLiteral("welcome_") + action->objectName());
    button->setAccessibleName(action->toolTip());
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(QSize(32, 32));
    button->setMinimumSize(150, 76);
    button->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(button);
  }
  row->addStretch(1);
  layout->addLayout(row);
  layout->addStretch(3);
}

void WelcomePage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) drawMark();
}

void WelcomePage::drawMark() { mark_->setPixmap(QIcon(QStringLiteral(":/icons/syncline.svg")).pixmap(72, 72)); }

}  // namespace syncline::ui
