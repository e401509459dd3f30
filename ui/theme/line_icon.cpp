// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/line_icon.h"

#include <QFile>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <algorithm>

namespace syncline::ui::theme {

namespace {

QString fileOf(const QString& name) { return QStringLiteral(":/icons/%1.svg").arg(name); }

/// The icons are drawn in black; any other colour is put in here.
QByteArray colored(const QString& name, const QColor& color) {
  QFile file(fileOf(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return file.readAll().replace("#000000", color.name().toLatin1());
}

/// In the middle, as wide as it is high.
QRectF squareIn(const QSize& size) {
  const int side = std::min(size.width(), size.height());
  return {(size.width() - side) / 2.0, (size.height() - side) / 2.0, static_cast<qreal>(side),
          static_cast<qreal>(side)};
}

}  // namespace

bool LineIcon::exists(const QString& name) { return QFile::exists(fileOf(name)); }

const QColor& LineIcon::colorOf(QIcon::Mode mode) const {
  if (mode == QIcon::Disabled) return colors_.disabled;
  return mode == QIcon::Selected ? colors_.selected : colors_.normal;
}

void LineIcon::paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) {
  const QSize pixels = rect.size() * painter->device()->devicePixelRatioF();
  painter->drawPixmap(rect, pixmap(pixels, mode, state));
}

QPixmap LineIcon::pixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/) {
  const auto& color = colorOf(mode);
  const auto drawn =
      QStringLiteral("syncline/%1/%2/%3x%4").arg(name_, color.name()).arg(size.width()).arg(size.height());
  QPixmap pixmap;
  if (QPixmapCache::find(drawn, &pixmap)) return pixmap;
  pixmap = QPixmap(size);
  pixmap.fill(Qt::transparent);
  QSvgRenderer renderer(colored(name_, color));
  QPainter painter(&pixmap);
  renderer.render(&painter, squareIn(size));
  painter.end();
  QPixmapCache::insert(drawn, pixmap);
  return pixmap;
}

QString LineIcon::key() const { return QStringLiteral("syncline::LineIcon"); }
QIconEngine* LineIcon::clone() const { return new LineIcon(name_, colors_); }

}  // namespace syncline::ui::theme
