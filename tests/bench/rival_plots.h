// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QVector>
#include <functional>
#include <optional>

class QPainter;

namespace syncline::bench {

/// One picture of a curve into a painter.
using DrawPicture = std::function<void(QPainter&)>;

/// The same curve by other plotting libraries, as they are out of the box: canvas and curve alone, without axes, legend
/// and grid. Values are `low` to `high`. Nothing where the library was not there when this was built.
[[nodiscard]] std::optional<DrawPicture> qcustomplot_picture(const QVector<QPointF>& points, double low, double high);
[[nodiscard]] std::optional<DrawPicture> qtcharts_picture(const QVector<QPointF>& points, double low, double high);

}  // namespace syncline::bench
