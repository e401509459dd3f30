// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/spoken_value.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QLabel>
#include <QTextDocumentFragment>
#include <utility>

#include "ui/text/menu_key.h"

namespace syncline::ui {
namespace {

constexpr const char* kSpeaks = "speaksValue";

class PaintedValue final : public QAccessibleWidget {
 public:
  explicit PaintedValue(QWidget* painted) : QAccessibleWidget(painted, QAccessible::Graphic) {}
  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    if (kind == QAccessible::Description) return widget()->toolTip();
    if (kind != QAccessible::Value) return QAccessibleWidget::text(kind);
    const auto said = widget()->accessibleDescription();
    return said.isEmpty() ? QCoreApplication::translate("SpokenValue", "Nothing is shown") : said;
  }
};

/// Qt has the text of a label as its name, and nowhere where it has another name. The rest is as with Qt: asked when it
/// is wanted, because a label is known here before it has got its name or its field.
class LabelText final : public QAccessibleWidget {
 public:
  explicit LabelText(QLabel* label) : QAccessibleWidget(label, QAccessible::StaticText) {}
  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    const bool own_name = !label().accessibleName().isEmpty();
    if (kind == (own_name ? QAccessible::Value : QAccessible::Name)) return plain();
    return QAccessibleWidget::text(kind);
  }
  [[nodiscard]] QList<std::pair<QAccessibleInterface*, QAccessible::Relation>> relations(
      QAccessible::Relation match) const override {
    auto all = QAccessibleWidget::relations(match);
    auto* field = label().buddy();
    if (field != nullptr && match.testFlag(QAccessible::Labelled))
      all.append({QAccessible::queryAccessibleInterface(field), QAccessible::Labelled});
    return all;
  }

 private:
  [[nodiscard]] const QLabel& label() const { return *static_cast<const QLabel*>(object()); }
  [[nodiscard]] QString plain() const {
    const auto text = label().text();
    const auto format = label().textFormat();
    if (format == Qt::RichText || (format == Qt::AutoText && Qt::mightBeRichText(text)))
      return QTextDocumentFragment::fromHtml(text).toPlainText();
    return label().buddy() != nullptr ? withoutMenuKey(text) : text;
  }
};

QAccessibleInterface* interfaceOf(const QString&, QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  if (widget == nullptr) return nullptr;
  if (widget->property(kSpeaks).toBool()) return new PaintedValue(widget);
  auto* label = qobject_cast<QLabel*>(widget);
  return label != nullptr && label->pixmap().isNull() ? new LabelText(label) : nullptr;
}

}  // namespace

void installSpokenValues() {
  static const bool installed = [] {
    QAccessible::installFactory(interfaceOf);
    return true;
  }();
  static_cast<void>(installed);
}

void speaksValue(QWidget& widget) {
  installSpokenValues();
  widget.setProperty(kSpeaks, true);
}

void sayValue(QWidget& widget, const QString& value) {
  if (value == widget.accessibleDescription()) return;
  widget.setAccessibleDescription(value);
  if (!QAccessible::isActive()) return;
  QAccessibleValueChangeEvent event(&widget, value);
  QAccessible::updateAccessibility(&event);
}

}  // namespace syncline::ui
