// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QStringList>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTextDocument>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>

#include "ui/widgets/pill.h"
#include "ui/widgets/value_label.h"
#include "ui/widgets/whole_texts.h"

namespace syncline::test {

/// Texts of a window that its user does not see whole, and cannot by pointing at them.
class CutTexts {
 public:
  explicit CutTexts(const QWidget& window) {
    // Asking for a tip deletes the one that was shown before, which is a child of the window, too.
    const auto found = window.findChildren<QWidget*>();
    for (const auto& widget : QList<QPointer<QWidget>>(found.begin(), found.end())) {
      if (widget && widget->isVisible() && !widget->visibleRegion().isEmpty()) look(*widget);
    }
  }
  [[nodiscard]] const QStringList& found() const { return found_; }

 private:
  static constexpr qsizetype kLeastShown = 12;  // of a value that ends in an ellipsis, with it
  static constexpr int kLeastCell = 20;         // px of a cell that is in view
  static constexpr int kLongPill = 24;          // what has more characters may end in its tool tip

  void say(const QWidget& widget, const QString& text, int wanted, int has) {
    QString path = widget.objectName();
    for (auto* up = widget.parentWidget(); up != nullptr && path.isEmpty(); up = up->parentWidget())
      path = up->objectName();
    found_.append(QStringLiteral("%1 \"%2\": %3 of %4 px").arg(path, text).arg(has).arg(wanted));
  }
  void look(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return lookAt(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return lookAt(*button);
    if (const auto* pill = qobject_cast<const ui::Pill*>(&widget)) {
      if (pill->shown() != pill->text() && pill->text().size() <= kLongPill)
        say(*pill, pill->text(), pill->sizeHint().width(), pill->width());
      return;
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) return lookAt(*tabs);
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) return lookAt(*header);
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) return lookAt(*view);
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) return lookAt(*combo);
    if (const auto* area = qobject_cast<const QScrollArea*>(&widget)) {
      if (area->horizontalScrollBar()->isVisible())
        say(*area, QStringLiteral("the page"), area->widget()->width(), area->viewport()->width());
    }
  }
  void lookAt(const QLabel& label) {
    if (label.text().isEmpty()) return;
    if (const auto* value = qobject_cast<const ui::ValueLabel*>(&label)) return lookAt(*value);
    const auto room = label.contentsRect();
    if (label.wordWrap()) {
      const int high = label.heightForWidth(label.width());
      if (high > label.height()) say(label, label.text(), high, label.height());
      // A word that is longer than the line.
      const int wide = Qt::mightBeRichText(label.text())
                           ? wrapped(label, room.width())
                           : label.fontMetrics().boundingRect(room, Qt::TextWordWrap, label.text()).width();
      if (wide > room.width()) say(label, label.text(), wide, room.width());
      return;
    }
    const int keys = label.buddy() != nullptr ? Qt::TextShowMnemonic : 0;
    const int wide = Qt::mightBeRichText(label.text()) ? label.sizeHint().width()
                                                       : label.fontMetrics().size(keys, label.text()).width();
    if (wide > room.width() || seen(label) < label.width()) say(label, label.text(), wide, seen(label));
  }
  /// How wide its longest line is, of at most so many px where its words allow it.
  static int wrapped(const QLabel& label, int width) {
    QTextDocument document;
    document.setDocumentMargin(0);
    document.setDefaultFont(label.font());
    document.setHtml(label.text());
    document.setTextWidth(width);
    return static_cast<int>(document.idealWidth());
  }
  /// What ends in an ellipsis has its whole text in the tool tip that its user sees, and shows enough to be known by.
  void lookAt(const ui::ValueLabel& label) {
    const auto shown = label.shown();
    if (shown == label.text() && seen(label) >= label.width()) return;
    const bool whole_form = !shown.endsWith(QChar(0x2026));  // the shorter one
    const bool known = whole_form || shown.size() >= std::min<qsizetype>(label.text().size(), kLeastShown);
    const auto middle = label.rect().center();
    if (!known || !tipAt(label, middle).contains(label.text()))
      say(label, label.text(), label.sizeHint().width(), seen(label));
  }
  /// Cells that are in view.
  void lookAt(const QAbstractItemView& view) {
    const auto* viewport = view.viewport();
    const auto& model = view.model();
    if (model == nullptr) return;
    QSet<QModelIndex> seen_cells;
    const int step = std::max(4, view.fontMetrics().height() / 2);
    for (int y = step / 2; y < viewport->height(); y += step) {
      const auto first = view.indexAt(QPoint(viewport->width() / 2, y));
      if (!first.isValid() || seen_cells.contains(first)) continue;
      seen_cells.insert(first);
      for (int column = 0; column < model->columnCount(first.parent()); ++column)
        lookAt(view, first.siblingAtColumn(column));
    }
  }
  void lookAt(const QAbstractItemView& view, const QModelIndex& cell) {
    const auto room = view.visualRect(cell) & view.viewport()->rect();
    if (room.width() < kLeastCell || room.height() < view.fontMetrics().height() || !ui::WholeTexts::isCut(view, cell))
      return;
    const auto text = cell.data().toString();
    if (!tipAt(*view.viewport(), room.center()).contains(text))
      say(view, text, view.sizeHintForIndex(cell).width(), room.width());
  }
  /// What stands beside the pointer there.
  static QString tipAt(const QWidget& widget, QPoint at) {
    QToolTip::hideText();
    QHelpEvent asks(QEvent::ToolTip, at, widget.mapToGlobal(at));
    QCoreApplication::sendEvent(const_cast<QWidget*>(&widget), &asks);
    const auto text = QToolTip::text();
    QToolTip::hideText();
    return text;
  }
  void lookAt(const QAbstractButton& button) {
    if (button.objectName() == QLatin1String("qt_toolbar_ext_button"))
      return say(button, QStringLiteral("the tool bar"), button.parentWidget()->sizeHint().width(),
                 button.parentWidget()->width());
    if (button.text().isEmpty()) return;
    // A style gives room that the text does not need.
    const int wide = button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width();
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) return;
    const int frame = std::min(6, std::max(0, button.sizeHint().width() - wide));
    if (wide + frame > button.width() || seen(button) < button.width())
      say(button, button.text(), button.sizeHint().width(), seen(button));
  }
  void lookAt(const QTabBar& tabs) {
    int all = 0;
    for (int i = 0; i < tabs.count(); ++i) {
      const int wide = tabs.fontMetrics().size(Qt::TextShowMnemonic, tabs.tabText(i)).width();
      all += tabs.tabRect(i).width();
      if (wide > tabs.tabRect(i).width() && tabs.tabToolTip(i).isEmpty())
        say(tabs, tabs.tabText(i), wide, tabs.tabRect(i).width());
    }
    // Beyond its width it scrolls; the arrows then lead to the others.
    if (all > tabs.width() && !tabs.usesScrollButtons()) say(tabs, QStringLiteral("the tabs"), all, tabs.width());
  }
  void lookAt(const QHeaderView& header) {
    if (header.orientation() != Qt::Horizontal || header.model() == nullptr) return;
    const int margin = header.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &header);
    for (int i = 0; i < header.count(); ++i) {
      const auto text = header.model()->headerData(i, Qt::Horizontal).toString();
      const int wide = header.fontMetrics().horizontalAdvance(text) + 2 * margin;
      if (!header.isSectionHidden(i) && wide > header.sectionSize(i)) say(header, text, wide, header.sectionSize(i));
    }
  }
  void lookAt(const QComboBox& combo) {
    if (combo.isEditable()) return;
    QStyleOptionComboBox option;
    option.initFrom(&combo);
    const auto room = combo.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo);
    const int wide = combo.fontMetrics().horizontalAdvance(combo.currentText());
    if (wide > room.width()) say(combo, combo.currentText(), wide, room.width());
  }
  /// The width of it that lies within all that it stands in.
  static int seen(const QWidget& widget) { return widget.visibleRegion().boundingRect().width(); }

  QStringList found_;
};

}  // namespace syncline::test
