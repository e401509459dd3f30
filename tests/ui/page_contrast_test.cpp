// SPDX-License-Identifier: Apache-2.0
// In each theme every text of every page can be read on what it stands on.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <set>

#include "support/running_window.h"
#include "ui/editors/page.h"
#include "ui/plots/plot_colors.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

class PagesOfATheme : public test::RunningWindow, public ::testing::WithParamInterface<theme::Mode> {
 protected:
  PagesOfATheme() { theme::apply(GetParam()); }
  ~PagesOfATheme() override { theme::apply(theme::Mode::kLight); }

  static bool high() { return GetParam() == theme::Mode::kContrast; }
  /// What is disabled may be quieter.
  static double wanted(bool enabled) {
    if (enabled) return high() ? 7.0 : 4.5;
    return high() ? 4.5 : 1.8;
  }
  void look(const QWidget& widget, QColor text, QColor ground, const QString& words) {
    const double has = plot_colors::contrast(text, ground);
    ++seen_;
    if (has >= wanted(widget.isEnabled()) || !told_.insert(widget.objectName() + words).second) return;
    ADD_FAILURE() << qPrintable(widget.objectName()) << " \"" << qPrintable(words) << "\": " << qPrintable(text.name())
                  << " on " << qPrintable(ground.name()) << " is " << has;
  }
  void lookAt(const QWidget& widget) {
    const auto palette = widget.palette();
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
      if (!label->text().isEmpty())
        look(widget, palette.color(QPalette::WindowText), groundOf(widget), label->text().left(40));
    } else if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) {
      lookAtCells(*view);
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
      if (!button->text().isEmpty())
        look(widget, palette.color(QPalette::ButtonText), palette.color(QPalette::Button), button->text());
    } else if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
      look(widget, palette.color(line->text().isEmpty() ? QPalette::PlaceholderText : QPalette::Text),
           palette.color(QPalette::Base), line->text());
    }
  }
  void lookAtCells(const QAbstractItemView& view) {
    const auto* model = view.model();
    const auto top = view.rootIndex();
    for (int row = 0; model != nullptr && row < std::min(model->rowCount(top), 40); ++row) {
      for (int column = 0; column < model->columnCount(top); ++column) {
        const auto cell = model->index(row, column, top);
        const auto ink = cell.data(Qt::ForegroundRole), fill = cell.data(Qt::BackgroundRole);
        if (!cell.data().isValid() || (!ink.isValid() && !fill.isValid())) continue;
        const auto base = view.palette().color(QPalette::Base);
        look(view, ink.isValid() ? ink.value<QBrush>().color() : view.palette().color(QPalette::Text),
             fill.isValid() ? over(fill.value<QBrush>().color(), base) : base, cell.data().toString());
      }
    }
  }
  void lookAtAll() {
    for (auto* widget : window_.findChildren<QWidget*>()) {
      if (widget->isVisible()) lookAt(*widget);
    }
  }

  int seen_ = 0;

 private:
  static QColor over(const QColor& fill, const QColor& base) {
    const auto mixed = [&fill](float top, float below) { return top * fill.alphaF() + below * (1 - fill.alphaF()); };
    return QColor::fromRgbF(mixed(fill.redF(), base.redF()), mixed(fill.greenF(), base.greenF()),
                            mixed(fill.blueF(), base.blueF()));
  }
  static QColor groundOf(const QWidget& widget) {
    const auto* on = &widget;
    while (!on->isWindow() && !on->autoFillBackground()) on = on->parentWidget();
    return on->palette().color(on->backgroundRole());
  }

  std::set<QString> told_;
};

TEST_P(PagesOfATheme, CanBeRead) {
  goOnline();
  workspace_.setExpert(true);
  std::set<QString> pages;
  for (const int node : {-1, 0, 1, 2, 3, 4, 5}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      window_.editor().tabs()->setCurrentWidget(page);
      run(40 * kMillisecond);
      pages.insert(page->objectName());
      lookAtAll();
    }
  }
  EXPECT_GE(pages.size(), 20U);
  EXPECT_GE(seen_, 3'000);
}

INSTANTIATE_TEST_SUITE_P(All, PagesOfATheme,
                         ::testing::Values(theme::Mode::kLight, theme::Mode::kDark, theme::Mode::kContrast),
                         [](const auto& mode) { return theme::modeName(mode.param).toStdString(); });

}  // namespace
}  // namespace syncline::ui
