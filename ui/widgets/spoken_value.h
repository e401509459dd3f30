// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

namespace syncline::ui {

/// Once there is an application, before labels are made: a label with an accessible name of its own has its text as its
/// value from then on. Again: nothing.
void installSpokenValues();

/// A widget that paints a value has no part that a screen reader could read. What it shows is its accessible
/// description (QWidget::accessibleDescription), and from here on its accessible value, too; without one it says that
/// nothing is shown. First in the constructor of such a widget: what is known of it before is kept. A label with an
/// accessible name of its own has its text as its value without being asked.
void speaksValue(QWidget& widget);

/// What the widget shows from now on; whoever listens is told where it is another than before.
void sayValue(QWidget& widget, const QString& value);

}  // namespace syncline::ui
