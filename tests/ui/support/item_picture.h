// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_scale_map.h>

#include <QImage>
#include <QPainter>

#include "ui/plots/series_item.h"

namespace syncline::test {

/// Canvas of `size` for values from -largest to largest: the item in black on white.
inline QImage itemPicture(ui::SeriesItem& item, const ui::ColumnGrid& grid, QSize size, double largest) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  item.setColor(Qt::black);
  item.prepare(grid);
  QwtScaleMap x;
  QwtScaleMap y;
  x.setScaleInterval(0, 1);
  x.setPaintInterval(0, size.width());
  y.setScaleInterval(-largest, largest);
  y.setPaintInterval(size.height(), 0);
  QPainter painter(&image);
  item.draw(&painter, x, y, QRectF(QPointF(), size));
  return image;
}

}  // namespace syncline::test
