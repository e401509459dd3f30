// SPDX-License-Identifier: Apache-2.0
#include "bench/rival_plots.h"

#include <QPainter>
#include <memory>

#ifdef SYNCLINE_BENCH_QCUSTOMPLOT
#include <qcustomplot.h>
#endif
#ifdef SYNCLINE_BENCH_QTCHARTS
#include <QChart>
#include <QGraphicsScene>
#include <QLineSeries>
#include <QValueAxis>
#endif

namespace syncline::bench {

std::optional<DrawPicture> qcustomplot_picture([[maybe_unused]] const QVector<QPointF>& points,
                                               [[maybe_unused]] double low, [[maybe_unused]] double high) {
#ifdef SYNCLINE_BENCH_QCUSTOMPLOT
  auto plot = std::make_shared<QCustomPlot>();
  auto* graph = plot->addGraph();  // adaptive sampling is on unless it is taken away
  auto data = QSharedPointer<QCPGraphDataContainer>::create();
  for (const auto& point : points) data->add(QCPGraphData(point.x(), point.y()));
  graph->setData(data);
  graph->setPen(QPen(Qt::black));
  plot->xAxis->setRange(0, static_cast<double>(points.size()));
  plot->yAxis->setRange(low, high);
  for (auto* axis : plot->axisRect()->axes()) {
    axis->setVisible(false);
    axis->grid()->setVisible(false);
  }
  plot->axisRect()->setAutoMargins(QCP::msNone);
  return [plot](QPainter& painter) {
    const auto ratio = painter.device()->devicePixelRatioF();
    QCPPainter own;
    painter.end();
    own.begin(painter.device());
    plot->toPainter(&own, static_cast<int>(painter.device()->width() / ratio),
                    static_cast<int>(painter.device()->height() / ratio));
  };
#else
  return std::nullopt;
#endif
}

std::optional<DrawPicture> qtcharts_picture([[maybe_unused]] const QVector<QPointF>& points,
                                            [[maybe_unused]] double low, [[maybe_unused]] double high) {
#ifdef SYNCLINE_BENCH_QTCHARTS
  struct Chart {
    QGraphicsScene scene;
    QChart* chart = new QChart;
  };
  auto chart = std::make_shared<Chart>();
  auto* series = new QLineSeries;
  series->replace(points);
  chart->chart->addSeries(series);
  chart->chart->createDefaultAxes();
  chart->chart->legend()->hide();
  for (auto* axis : chart->chart->axes()) {
    axis->setVisible(false);
    if (axis->orientation() == Qt::Vertical) axis->setRange(low, high);
  }
  chart->scene.addItem(chart->chart);
  return [chart](QPainter& painter) {
    const auto ratio = painter.device()->devicePixelRatioF();
    const QSizeF size(painter.device()->width() / ratio, painter.device()->height() / ratio);
    if (chart->chart->size() != size) chart->chart->resize(size);
    chart->scene.render(&painter, QRectF(QPointF(), size), QRectF(QPointF(), size));
  };
#else
  return std::nullopt;
#endif
}

}  // namespace syncline::bench
