// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QIconEngine>
#include <QString>
#include <utility>

namespace syncline::ui::theme {

/// A drawing of resources/icons in the colours of its modes. It is drawn when somebody shows it, in the pixels that are
/// asked for: a window has some hundred icons, most of them in menus that nobody opens, and a screen may have any
/// scale.
class LineIcon : public QIconEngine {
 public:
  struct Colors {
    QColor normal, disabled, selected;
  };
  /// Whether resources/icons has a drawing of that name.
  [[nodiscard]] static bool exists(const QString& name);
  LineIcon(QString name, const Colors& colors) : name_(std::move(name)), colors_(colors) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override;
  /// `size` in pixels of the screen.
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override;
  [[nodiscard]] QString key() const override;
  [[nodiscard]] QIconEngine* clone() const override;

 private:
  [[nodiscard]] const QColor& colorOf(QIcon::Mode mode) const;

  QString name_;
  Colors colors_;
};

}  // namespace syncline::ui::theme
