// SPDX-License-Identifier: Apache-2.0
// The wheel scrolls; only in a field that has the focus it changes a value.
#include <gtest/gtest.h>

#include <QtTest/qtestspontaneevent.h>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <set>

#include "support/editable_project.h"
#include "support/project_window.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"

namespace syncline::ui {
namespace {

void turn(QWidget& widget, int by) {
  const QPointF middle(widget.rect().center());
  QWheelEvent wheel(middle, widget.mapToGlobal(middle), {}, {0, by}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QSpontaneKeyEvent::setSpontaneous(&wheel);  // as one that comes from the mouse goes to the next one
  qApp->notify(&widget, &wheel);
}

QVariant stateOf(const QWidget& widget) {
  if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) return combo->currentIndex();
  if (const auto* slider = qobject_cast<const QSlider*>(&widget)) return slider->value();
  return static_cast<const QAbstractSpinBox&>(widget).text();
}

QList<QWidget*> turnables(QWidget& in) {
  QList<QWidget*> all;
  for (auto* one : in.findChildren<QComboBox*>()) all.append(one);
  for (auto* one : in.findChildren<QAbstractSpinBox*>()) all.append(one);
  for (auto* one : in.findChildren<QSlider*>()) all.append(one);
  return all;
}

class CalmWheelOfTheWindow : public test::ProjectWindow {
 protected:
  CalmWheelOfTheWindow() : ProjectWindow(test::projectOfFamilies()) {}
};

TEST_F(CalmWheelOfTheWindow, ChangesNoFieldWithoutTheFocus) {
  workspace_.setExpert(true);
  std::set<QString> names;
  for (const int node : {-1, 0, 1, 2, 3, 4}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      window_.editor().tabs()->setCurrentWidget(page);
      window_.editor().tabs()->setFocus();
      for (auto* widget : turnables(window_)) {
        const auto name = widget->objectName();
        const auto before = stateOf(*widget);
        turn(*widget, 120);
        turn(*widget, -240);
        EXPECT_EQ(stateOf(*widget), before) << qPrintable(name);
        EXPECT_FALSE(widget->isVisible() && widget->focusPolicy() == Qt::WheelFocus) << qPrintable(name);
        names.insert(name);
      }
      ASSERT_EQ(project(), test::projectOfFamilies()) << qPrintable(page->objectName());
    }
  }
  for (const char* name : {"eniDialect", "eniSince", "eniSection", "objectSource", "objectPoll", "registerGroup",
                           "eepromAlias", "masterCycle", "slaveAlias"})
    EXPECT_TRUE(names.contains(QLatin1String(name))) << name;
}

TEST_F(CalmWheelOfTheWindow, ChangesTheOneWithIt) {
  show(1, "slaveEepromPage");
  auto& alias = field<QSpinBox>("eepromAlias");
  alias.setEnabled(true);
  alias.setFocus();
  const int before = alias.value();
  turn(alias, 120);
  EXPECT_EQ(alias.value(), before + 1);
}

TEST_F(CalmWheelOfTheWindow, ScrollsWhatItStandsIn) {
  QScrollArea area;
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  auto* box = new QSpinBox;
  box->setValue(50);
  layout->addWidget(box);
  auto* tall = new QLabel;
  tall->setFixedHeight(2000);
  layout->addWidget(tall);
  area.setWidget(content);
  area.resize(300, 200);
  area.show();
  area.setFocus();
  QApplication::processEvents();
  ASSERT_GT(area.verticalScrollBar()->maximum(), 0);
  ASSERT_FALSE(box->hasFocus());
  turn(*box, -120);
  EXPECT_EQ(box->value(), 50);
  EXPECT_GT(area.verticalScrollBar()->value(), 0);
}

}  // namespace
}  // namespace syncline::ui
