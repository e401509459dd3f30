// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/segments.h"

#include <QAction>
#include <QActionGroup>
#include <QHBoxLayout>
#include <QToolButton>

namespace syncline::ui {

Segments::Segments(const QList<Choice>& choices, QWidget* parent) : QWidget(parent), group_(new QActionGroup(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  for (const auto& choice : choices) {
    auto* action = new QAction(choice.text, this);
    action->setObjectName(QLatin1String(choice.object_name));
    action->setCheckable(true);
    action->setShortcut(choice.shortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(choice.tip, choice.shortcut.toString(QKeySequence::NativeText)));
    group_->addAction(action);
    connect(action, &QAction::triggered, this,
            [this, number = static_cast<int>(actions_.size())] { Q_EMIT chosen(number); });
    actions_.append(action);
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(choice.object_name) + QStringLiteral("Button"));
    button->setDefaultAction(action);
    button->setAccessibleName(action->toolTip());
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    layout->addWidget(button);
  }
}

void Segments::setCurrent(int choice) { actions_.at(choice)->setChecked(true); }

int Segments::current() const { return static_cast<int>(actions_.indexOf(group_->checkedAction())); }

}  // namespace syncline::ui
