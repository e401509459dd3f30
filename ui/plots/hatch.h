// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QRectF>

class QPainter;

namespace syncline::ui {

/// Fills with slanted lines, whose places depend on nothing but the coordinates: neighbours fit together. Lines and no
/// pattern brush, which readers of SVG draw as black or not at all.
void fillHatched(QPainter& painter, const QRectF& area, const QColor& color);

}  // namespace syncline::ui
