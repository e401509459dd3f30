// SPDX-License-Identifier: Apache-2.0
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_scale_map.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QVector>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "bench/ratio_report.h"
#include "bench/rival_plots.h"
#include "channels/cycle_sample.h"
#include "trace/min_max_series.h"
#include "ui/panels/live_strip.h"
#include "ui/plots/band_item.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/heat_map_plot.h"
#include "ui/plots/series_item.h"
#include "ui/plots/time_view.h"
#include "ui/theme/theme.h"

/// Drawing a long series: our item on the pyramid against Qwt's own curve, on the same canvas.
namespace syncline::bench {
namespace {

using ui::ColumnGrid;
using ui::SeriesItem;

constexpr QSize kCanvas(1200, 500);
constexpr Nanoseconds kStart = 830'000'000 * kSecond;

/// Noise with rare spikes, as a deviation looks.
float noise(std::mt19937& random) {
  const auto value = static_cast<float>(random() % 2001) / 10.F - 100.F;
  return random() % 5000 == 0 ? value * 8 : value;
}

/// The same samples for our item and for Qwt's curve.
struct Data {
  explicit Data(int count) : series(static_cast<std::size_t>(count)), size(count) {
    std::mt19937 random(1);
    points.reserve(count);
    for (int i = 0; i < count; ++i) {
      const float value = noise(random);
      series.append(kStart + i * kMillisecond, value);
      points.append(QPointF(i, static_cast<double>(value)));
    }
    curve.setSamples(points);
  }
  MinMaxSeries series;
  QVector<QPointF> points;
  QwtPlotCurve curve;
  int size;
};

class Canvas {
 public:
  explicit Canvas(double scale = 1) : image_(kCanvas * scale, QImage::Format_RGB32) {
    image_.setDevicePixelRatio(scale);
  }

  template <class Draw>
  double time(Draw&& draw) {
    return median_ns([&] {
      image_.fill(Qt::white);
      QPainter painter(&image_);
      draw(painter);
    });
  }
  [[nodiscard]] double scale() const { return image_.devicePixelRatioF(); }

 private:
  QImage image_;
};

QwtScaleMap map(double low, double high, double from, double to) {
  QwtScaleMap result;
  result.setScaleInterval(low, high);
  result.setPaintInterval(from, to);
  return result;
}

/// `part` of the series, or its latest stretch. Each picture is of another width, as while it is zoomed: nothing of the
/// one before is in it.
double item_time(const MinMaxSeries& series, Canvas& canvas, double part = 1) {
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  const auto end = kStart + static_cast<Nanoseconds>(series.size()) * kMillisecond;
  const auto begin = end - static_cast<Nanoseconds>(part * static_cast<double>(end - kStart));
  const auto columns = static_cast<int>(kCanvas.width() * canvas.scale());
  bool wider = false;
  return canvas.time([&](QPainter& painter) {
    wider = !wider;
    item.prepare(ColumnGrid::of(begin + (wider ? 2 * columns : 0), end, columns));
    item.draw(&painter, map(0, 1, 0, kCanvas.width()), map(-900, 900, kCanvas.height(), 0), QRectF(QPointF(), kCanvas));
  });
}

/// The whole of it moves by a column from picture to picture, as while it follows.
double following_time(const MinMaxSeries& series, Canvas& canvas) {
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  auto end = kStart + static_cast<Nanoseconds>(series.size()) * kMillisecond;
  const auto span = end - kStart;
  return canvas.time([&](QPainter& painter) {
    const auto grid = ColumnGrid::of(end - span, end, kCanvas.width());
    end -= grid.width;  // backwards: there are no newer ones
    if (end < kStart + span / 2) end += span / 2;
    item.prepare(grid);
    item.draw(&painter, map(0, 1, 0, kCanvas.width()), map(-900, 900, kCanvas.height(), 0), QRectF(QPointF(), kCanvas));
  });
}

double item_time(const Data& data, Canvas& canvas, double part = 1) { return item_time(data.series, canvas, part); }

/// Of any length: every column is nearly as high as the canvas, so that as many pixels are filled.
MinMaxSeries even_series(int count) {
  MinMaxSeries series(static_cast<std::size_t>(count));
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i)
    series.append(kStart + i * kMillisecond, static_cast<float>(random() % 2001) * 0.8F - 800);
  return series;
}

/// More than Qwt's curve, with its 16 bytes a point twice, has room for.
void compare_lengths(RatioReport& report) {
  Canvas canvas;
  const auto few = even_series(10'000);
  const auto many = even_series(100'000'000);
  const auto whole = item_time(few, canvas), following = following_time(few, canvas);
  report.add("draw 100 M points", item_time(many, canvas), "10 k points", whole, 2);
  report.add("100 M points, a picture after the other", following_time(many, canvas), "10 k points", following, 2);
}

double curve_time(Data& data, Canvas& canvas, bool aggressive, bool cosmetic = false) {
  data.curve.setPaintAttribute(QwtPlotCurve::FilterPointsAggressive, aggressive);
  data.curve.setPen(Qt::black, cosmetic ? 0 : 1);
  return canvas.time([&](QPainter& painter) {
    data.curve.drawSeries(&painter, map(0, data.size, 0, kCanvas.width()), map(-900, 900, kCanvas.height(), 0),
                          QRectF(QPointF(), kCanvas), 0, -1);
  });
}

/// One picture by another library; where it is not there, that is said and nothing promised.
void compare_rival(RatioReport& report, const std::string& what, double ours, const char* rival,
                   const std::optional<DrawPicture>& picture, double gate) {
  if (!picture) return report.add_missing(what, rival);
  Canvas canvas;
  report.add(what, ours, rival, canvas.time([&](QPainter& painter) { (*picture)(painter); }), gate);
}

void compare_rivals(RatioReport& report, const std::string& what, double ours, const Data& data) {
  const auto qcustomplot = qcustomplot_picture(data.points, -900, 900);
  switch (data.size) {
    case 100'000:
      return compare_rival(report, "G5 " + what, ours, "QCustomPlot, adaptive", qcustomplot, 1);
    case 1'000'000:
      compare_rival(report, "G4 " + what, ours, "QCustomPlot, adaptive", qcustomplot, 1.0 / 3);
      return compare_rival(report, "G4 " + what, ours, "Qt Charts", qtcharts_picture(data.points, -900, 900),
                           1.0 / 150);
    case 10'000'000:
      return compare_rival(report, "G3 " + what, ours, "QCustomPlot, adaptive", qcustomplot, 1.0 / 12);
    default:
      return;
  }
}

void compare_sizes(RatioReport& report) {
  Canvas canvas;
  struct Size {
    int count;
    const char* name;
    double gate, aggressive_gate;
    const char *number = "", *aggressive_number = "";  // of the gate
  };
  std::map<int, double> ours;
  for (const auto& size :
       {Size{1'000, "1 k", 2, 0, "G6 "}, Size{10'000, "10 k", 1, 0}, Size{100'000, "100 k", 1.0 / 8, 1},
        Size{1'000'000, "1 M", 1.0 / 60, 1.0 / 10}, Size{10'000'000, "10 M", 1.0 / 300, 1.0 / 60, "G1 ", "G2 "}}) {
    Data data(size.count);
    ours[size.count] = item_time(data, canvas);
    const std::string what = std::string("draw ") + size.name + " points";
    report.add(size.number + what, ours[size.count], "Qwt curve", curve_time(data, canvas, false), size.gate);
    report.add(size.aggressive_number + what, ours[size.count], "Qwt curve, aggressive filter",
               curve_time(data, canvas, true), size.aggressive_gate);
    compare_rivals(report, what, ours[size.count], data);
    if (size.count == 10'000'000) {
      report.add("G8 draw 1 % of 10 M points", item_time(data, canvas, 0.01), "all of them", ours[size.count], 1.5);
    }
  }
  report.add("G7 draw 10 M points", ours[10'000'000], "1 k points", ours[1'000], 4);
}

void compare_scales(RatioReport& report) {
  Data data(100'000);
  Canvas plain;
  const double at_one = item_time(data, plain);
  const double curve_at_one = curve_time(data, plain, true);
  for (const double scale : {1.25, 2.0}) {
    Canvas canvas(scale);
    const auto name = "G9 draw 100 k points, display scale " + std::string(scale == 2.0 ? "2" : "1.25");
    report.add(name, item_time(data, canvas), "scale 1", at_one, scale == 2.0 ? 6 : 2);
    report.add("Qwt curve, the same", curve_time(data, canvas, true), "scale 1", curve_at_one, 0);
  }
}

/// One redraw of a live plot after 133 new samples on a long history.
void compare_live(RatioReport& report) {
  constexpr int kHistory = 10'000'000;
  constexpr int kNew = 133;
  Canvas canvas;
  Data data(kHistory);
  std::mt19937 random(2);
  Nanoseconds now = kStart + kHistory * kMillisecond;
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&data.series);
  const double ours = canvas.time([&](QPainter& painter) {
    for (int i = 0; i < kNew; ++i) data.series.append(now += kMillisecond, noise(random));
    item.prepare(ColumnGrid::of(now - kHistory * kMillisecond, now, kCanvas.width()));
    item.draw(&painter, map(0, 1, 0, kCanvas.width()), map(-900, 900, kCanvas.height(), 0), QRectF(QPointF(), kCanvas));
  });
  QVector<QPointF> points(kHistory);
  for (int i = 0; i < kHistory; ++i) points[i] = QPointF(i, static_cast<double>(noise(random)));
  const double theirs = canvas.time([&](QPainter& painter) {
    points.remove(0, kNew);
    const double last = points.last().x();
    for (int i = 1; i <= kNew; ++i) points.append(QPointF(last + i, static_cast<double>(noise(random))));
    data.curve.setPaintAttribute(QwtPlotCurve::FilterPointsAggressive, true);
    data.curve.setSamples(points);
    data.curve.drawSeries(&painter, map(points.first().x(), points.last().x(), 0, kCanvas.width()),
                          map(-900, 900, kCanvas.height(), 0), QRectF(QPointF(), kCanvas), 0, -1);
  });
  report.add("G11 133 new samples and redraw, 10 M history", ours, "Qwt curve, aggressive filter", theirs, 1.0 / 100);
}

/// The live strip as it runs: 8 kHz, 20 slaves, a minute shown, 30 redraws a second.
void compare_strip(RatioReport& report) {
  constexpr Nanoseconds kCycle = 125 * kMicrosecond;
  constexpr int kPerTick = 267;
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kCycle;
  for (int i = 0; i < 20; ++i) config.slaves.emplace_back().name = "Slave_" + std::to_string(1001 + i);
  RunRecord record(config);
  ui::LiveStrip strip;
  strip.resize(1280, 230);
  strip.setRecord(&record);
  strip.timeView()->setSpan(60 * kSecond);
  std::mt19937 random(3);
  std::uint64_t cycle = 0;
  const auto produce = [&](int count) {
    std::vector<CycleSample> samples(static_cast<std::size_t>(count));
    for (auto& sample : samples) {
      sample.cycle = cycle;
      sample.send_time = kStart + static_cast<Nanoseconds>(cycle) * kCycle;
      sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
                     CycleSample::kReferenceValid;
      sample.deviation_ns = 20 + random() % 40;
      sample.dcm_error_ns = static_cast<std::int32_t>(random() % 401) - 200;
      sample.slave_position = static_cast<std::int16_t>(cycle % config.slaves.size());
      sample.slave_deviation_ns = static_cast<std::int32_t>(random() % 41) - 20;
      ++cycle;
    }
    return samples;
  };
  strip.show();
  record.add(produce(480'000));
  strip.refresh();
  QApplication::processEvents();
  const auto samples = produce(kPerTick);
  auto moving = samples;
  const double append = median_ns([&] {
    for (auto& sample : moving) {
      sample.cycle += kPerTick;
      sample.send_time += kPerTick * kCycle;
    }
    record.add(moving);
  });
  const double frame = median_ns([&] {
    for (auto& sample : moving) {
      sample.cycle += kPerTick;
      sample.send_time += kPerTick * kCycle;
    }
    record.add(moving);
    strip.refresh();
    QApplication::processEvents();
  });
  report.add("live strip: append one sample", append / kPerTick, "a cycle of 125 us", 125e3, 1.0 / 100);
  report.add("live strip: append, redraw, numbers", frame, "a tick of 33 ms", 33e6, 0.6);
}

/// So many curves in one canvas, each with as many points.
double curves_time(int count, int points) {
  std::vector<std::unique_ptr<Data>> curves;
  for (int i = 0; i < count; ++i) curves.push_back(std::make_unique<Data>(points));
  Canvas canvas;
  return canvas.time([&](QPainter& painter) {
    for (const auto& data : curves) {
      data->curve.setSamples(data->points);
      data->curve.setPaintAttribute(QwtPlotCurve::FilterPointsAggressive);
      data->curve.setPen(Qt::black, 1);
      data->curve.drawSeries(&painter, map(0, points, 0, kCanvas.width()), map(-900, 900, kCanvas.height(), 0),
                             QRectF(QPointF(), kCanvas), 0, -1);
    }
  });
}

/// The heat map by itself, scrolling; its frame in ns.
double map_time(RunRecord& record, Nanoseconds shown, const std::function<void()>& go_on, double going_on) {
  ui::TimeView view;
  ui::CursorSet cursors;
  ui::HeatMapPlot map(&view, &cursors);
  std::vector<ui::HeatMapPlot::Row> rows;
  for (std::size_t i = 0; i < record.samples().slave_count(); ++i)
    rows.push_back({i, QString::fromStdString(record.slave_name(i)), i == 0});
  map.resize(kCanvas);
  map.setRecord(&record);
  map.setRows(std::move(rows));
  view.setSpan(shown);
  map.show();
  return median_ns([&] {
           go_on();
           view.setBounds(record.samples().first_time(), record.samples().last_time());
           map.markDirty();
           map.refresh();
           QApplication::processEvents();
         }) -
         going_on;
}

/// The heat map as it runs: 4 kHz, 300 slaves, ten minutes shown; with the table and its figures, 300,000 readings a
/// tick, and by itself.
void compare_slaves(RatioReport& report) {
  constexpr Nanoseconds kCycle = 250 * kMicrosecond;
  constexpr int kPerTick = 133, kSlaves = 300, kMinutes = 10, kCycles = kMinutes * 60 * 4000;
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kCycle;
  for (int i = 0; i < kSlaves; ++i) config.slaves.emplace_back().name = "Slave_" + std::to_string(1001 + i);
  config.dc.sync_window.enabled = true;
  config.dc.sync_window.exponent = 7;
  RunRecord record(config);
  ui::LiveStrip strip;
  strip.resize(1600, 400);
  strip.setRecord(&record);
  strip.timeView()->setSpan(kMinutes * 60 * kSecond);
  std::mt19937 random(3);
  std::uint64_t cycle = 0;
  std::vector<CycleSample> samples;
  const auto produce = [&](int count) {
    samples.resize(static_cast<std::size_t>(count));
    for (auto& sample : samples) {
      sample.cycle = cycle;
      sample.send_time = kStart + static_cast<Nanoseconds>(cycle) * kCycle;
      sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows;
      sample.slave_position = static_cast<std::int16_t>(cycle % kSlaves);
      sample.slave_deviation_ns = static_cast<std::int32_t>(random() % 271) - 135;
      ++cycle;
    }
    record.add(samples);
  };
  strip.show();
  produce(kCycles);
  strip.showBody(ui::LiveStrip::Body::kSlaves);
  // The table counts what was there before in portions.
  for (int i = 0; i < 30; ++i) {
    strip.refresh();
    QApplication::processEvents();
  }
  const double append = median_ns([&] { produce(kPerTick); });
  const double frame = median_ns([&] {
    produce(kPerTick);
    strip.refresh();
    QApplication::processEvents();
  });
  report.add("heat map and table of 300 slaves: a frame", frame - append, "8 ms", 8e6, 1);
  const auto curves = curves_time(kSlaves, kCycles / kSlaves);
  report.add("the same", frame - append, "300 Qwt curves, aggressive filter", curves, 1.0 / 40);
  const auto map = map_time(
      record, kMinutes * 60 * kSecond, [&] { produce(kPerTick); }, append);
  report.add("G10 heat map alone: a frame", map, "8 ms", 8e6, 1);
  report.add("G10 the same", map, "300 Qwt curves, aggressive filter", curves, 1.0 / 50);
}

int run() {
  RatioReport report;
  compare_sizes(report);
  compare_lengths(report);
  compare_scales(report);
  compare_live(report);
  compare_strip(report);
  compare_slaves(report);
  return report.finish("Plots, 1200 x 500 canvas");
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  syncline::ui::theme::apply(syncline::ui::theme::Mode::kLight);
  return syncline::bench::run();
}
