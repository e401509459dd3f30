// SPDX-License-Identifier: Apache-2.0
// Whether plots show what was there: single samples at any zoom, columns that stay as they were while the window
// slides, and no painting of what nobody sees. Counts, not times: each promise is that none of so many was wrong.
#include <qwt_plot_canvas.h>
#include <qwt_scale_map.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "bench/ratio_report.h"
#include "channels/cycle_sample.h"
#include "record/run_record.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overview_panel.h"
#include "ui/plots/band_item.h"
#include "ui/plots/series_item.h"
#include "ui/theme/theme.h"

namespace syncline::bench {
namespace {

using ui::ColumnGrid;
using ui::SeriesItem;

constexpr Nanoseconds kStart = 830'000'000 * kSecond, kStep = 125 * kMicrosecond;
constexpr double kNone = 1e-12;  // of so many: not one
constexpr float kSpike = 5000;
constexpr int kHeight = 240;

QwtScaleMap scale_map(double low, double high, double from, double to) {
  QwtScaleMap result;
  result.setScaleInterval(low, high);
  result.setPaintInterval(from, to);
  return result;
}

/// Noise with single samples that stand far above it.
struct SpikedSeries {
  SpikedSeries(std::size_t samples, std::size_t spike_count) : series(samples), size(samples) {
    std::mt19937_64 random(samples);
    while (spikes.size() < spike_count) spikes.push_back(random() % samples);
    std::ranges::sort(spikes);
    auto next = spikes.begin();
    series.reserve(samples);
    for (std::size_t i = 0; i < samples; ++i) {
      const bool spike = next != spikes.end() && *next == i;
      while (next != spikes.end() && *next == i) ++next;
      series.append(time_of(i), spike ? kSpike : static_cast<float>(random() % 2001) / 10.F - 100.F);
    }
  }
  [[nodiscard]] static Nanoseconds time_of(std::size_t index) {
    return kStart + static_cast<Nanoseconds>(index) * kStep;
  }
  MinMaxSeries series;
  std::size_t size;
  std::vector<std::size_t> spikes;
};

/// Pictures of a window, and which of its columns reach the height of a spike.
class SpikePicture {
 public:
  explicit SpikePicture(const MinMaxSeries& series) : item_(QStringLiteral("x")) { item_.setSeries(&series); }

  std::vector<bool> draw(const ColumnGrid& grid) {
    if (image_.width() != grid.columns) image_ = QImage(grid.columns, kHeight, QImage::Format_RGB32);
    image_.fill(Qt::white);
    {
      QPainter painter(&image_);
      item_.prepare(grid);
      // The spikes end in the uppermost fifth, where nothing else comes.
      item_.draw(&painter, scale_map(0, 1, 0, grid.columns), scale_map(-100, 5500, kHeight, 0),
                 QRectF(QPointF(), image_.size()));
    }
    std::vector<bool> reached(static_cast<std::size_t>(grid.columns));
    for (int y = 0; y < kHeight / 5; ++y) {
      const auto* line = reinterpret_cast<const QRgb*>(image_.constScanLine(y));
      for (int x = 0; x < grid.columns; ++x) {
        if (line[x] != qRgb(255, 255, 255)) reached[static_cast<std::size_t>(x)] = true;
      }
    }
    return reached;
  }

 private:
  SeriesItem item_;
  QImage image_;
};

struct Seen {
  std::size_t windows = 0, spikes = 0, missed = 0, invented = 0;
};

/// One window: each spike of it must be within a pixel of its place, and nothing else may reach its height.
void look(SpikePicture& picture, const SpikedSeries& data, std::size_t first, std::size_t count, int columns,
          Seen& seen) {
  const auto grid = ColumnGrid::of(data.time_of(first), data.time_of(first + count), columns);
  const auto reached = picture.draw(grid);
  std::vector<bool> allowed(reached.size());
  const auto near = [&](int x, const std::function<void(std::size_t)>& visit) {
    // Where single samples are joined, the lines to a spike and from it reach as far as its neighbours.
    const int beside = static_cast<int>(std::ceil(static_cast<double>(kStep) / static_cast<double>(grid.width))) + 1;
    for (int at = std::max(x - beside, 0); at <= std::min(x + beside, columns - 1); ++at)
      visit(static_cast<std::size_t>(at));
  };
  ++seen.windows;
  for (auto spike = std::ranges::lower_bound(data.spikes, first);
       spike != data.spikes.end() && data.time_of(*spike) < grid.end(); ++spike) {
    if (data.time_of(*spike) < grid.origin) continue;
    const auto x = static_cast<int>(grid.column_of(data.time_of(*spike)));
    bool found = false;
    for (int at = std::max(x - 1, 0); at <= std::min(x + 1, columns - 1); ++at)
      found = found || reached[static_cast<std::size_t>(at)];
    ++seen.spikes;
    if (!found) ++seen.missed;
    near(x, [&](std::size_t at) { allowed[at] = true; });
  }
  // A line to a spike just outside reaches in.
  for (const auto spike : data.spikes) {
    const auto time = data.time_of(spike);
    if (time >= grid.origin - 2 * kStep && time <= grid.end() + 2 * kStep)
      near(static_cast<int>(std::floor(grid.column_of(time))), [&](std::size_t at) { allowed[at] = true; });
  }
  for (std::size_t at = 0; at < reached.size(); ++at) {
    if (reached[at] && !allowed[at]) ++seen.invented;
  }
}

void tell(RatioReport& report, const std::string& of, const Seen& seen) {
  const auto windows = " in " + std::to_string(seen.windows) + " windows";
  report.add_count("G12 " + of + ": spikes not drawn", static_cast<double>(seen.missed), "of",
                   static_cast<double>(seen.spikes), "spikes" + windows, kNone);
  report.add_count("G12 " + of + ": spikes that are none", static_cast<double>(seen.invented), "of",
                   static_cast<double>(seen.spikes), "spikes" + windows, kNone);
}

/// From eight samples to all of them, each length as likely in each decade.
void spikes_at_any_zoom(RatioReport& report) {
  constexpr std::size_t kSamples = 10'000'000;
  const SpikedSeries data(kSamples, 2'000);
  SpikePicture picture(data.series);
  std::mt19937_64 random(12);
  Seen seen;
  for (int i = 0; i < 10'000; ++i) {
    const double part = std::pow(static_cast<double>(kSamples) / 8, static_cast<double>(random() % 10'001) / 10'000);
    const auto count = std::min(static_cast<std::size_t>(8 * part), kSamples - 1);
    // Half of the windows are about a spike: short ones would hardly ever hold one.
    auto first = random() % (kSamples - count);
    if (i % 2 == 0) {
      const auto before = std::min(data.spikes[random() % data.spikes.size()], kSamples - count - 1);
      first = before - std::min(before, random() % count);
    }
    look(picture, data, first, count, static_cast<int>(200 + random() % 1'400), seen);
  }
  tell(report, "10 M samples", seen);
}

/// A single sample, an eighth of a millisecond in three and a half hours.
void one_spike_in_100_million(RatioReport& report) {
  constexpr std::size_t kSamples = 100'000'000;
  const SpikedSeries data(kSamples, 1);
  SpikePicture picture(data.series);
  std::mt19937_64 random(13);
  Seen seen;
  for (int i = 0; i < 1'000; ++i) {
    const double part = std::pow(static_cast<double>(kSamples) / 8, static_cast<double>(i) / 999);
    const auto count = std::min(static_cast<std::size_t>(8 * part), kSamples - 1);
    const auto lowest = data.spikes[0] >= count ? data.spikes[0] - count + 1 : 0;
    const auto highest = std::min(data.spikes[0], kSamples - count - 1);
    look(picture, data, lowest + random() % (highest - lowest + 1), count, 1'200, seen);
  }
  tell(report, "1 in 100 M samples", seen);
}

/// The same stretch after a slide by anything, and after new samples: what lies inside is as it was, bit for bit.
void columns_stay(RatioReport& report) {
  constexpr std::size_t kSamples = 1'000'000, kMore = 20'000;
  MinMaxSeries series(kSamples + kMore);
  std::mt19937_64 random(14);
  const auto append = [&] {
    const auto time = series.empty() ? kStart : series.last_time() + kStep;
    series.append(time, static_cast<float>(random() % 2001) / 10.F - 100.F);
  };
  for (std::size_t i = 0; i < kSamples; ++i) append();
  std::size_t compared = 0, changed = 0;
  const auto interior = [&](const SeriesItem& item, Nanoseconds until) {
    std::map<Nanoseconds, SeriesColumn> columns;
    for (const auto& column : item.columns()) columns.emplace(column.start, column);
    // The first and the last one are cut by the window.
    if (!columns.empty()) columns.erase(columns.begin());
    if (!columns.empty()) columns.erase(std::prev(columns.end()));
    std::erase_if(columns, [&](const auto& entry) { return entry.first >= until; });
    return columns;
  };
  const auto width = [](const ColumnGrid& grid) { return grid.width; };
  for (int i = 0; i < 2'000; ++i) {
    // One item slides and keeps what it has; the other is asked anew.
    SeriesItem sliding(QStringLiteral("x")), anew(QStringLiteral("y"));
    sliding.setSeries(&series);
    anew.setSeries(&series);
    const auto columns = static_cast<int>(200 + random() % 1'400);
    const auto span = static_cast<Nanoseconds>(static_cast<double>(columns) * 8 *
                                               std::pow(70.0, static_cast<double>(random() % 1'001) / 1'000)) *
                      kStep;
    auto end = series.last_time() - static_cast<Nanoseconds>(random() % static_cast<std::uint64_t>(10 * kSecond));
    auto grid = ColumnGrid::of(end - span, end, columns);
    sliding.prepare(grid);
    for (int slide = 0; slide < 5; ++slide) {
      const auto newest = series.last_time();
      const auto before = interior(sliding, newest - width(grid));
      for (int k = 0; k < 2 && series.size() < kSamples + kMore - 1; ++k) append();
      end += static_cast<Nanoseconds>(random() % static_cast<std::uint64_t>(span / 2)) - span / 4;
      grid = ColumnGrid::of(end - span, end, columns);
      sliding.prepare(grid);
      anew.prepare(grid);
      const auto until = newest - width(grid);
      const auto after = interior(sliding, until), fresh = interior(anew, until);
      for (const auto& [start, column] : before) {
        const auto found = after.find(start);
        if (found == after.end()) continue;
        ++compared;
        if (!(found->second == column)) ++changed;
      }
      if (after != fresh) ++changed;
    }
  }
  report.add_count("G13 columns that change as a window slides", static_cast<double>(changed), "of",
                   static_cast<double>(compared), "inner columns, 10000 slides", kNone);
}

/// Counts paint events of what belongs to a window; of the plots' canvases alone where it is told so.
class PaintCounter final : public QObject {
 public:
  std::size_t all = 0, canvases = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint && watched->isWidgetType()) {
      ++all;
      if (qobject_cast<QwtPlotCanvas*>(watched) != nullptr) ++canvases;
    }
    return false;
  }
};

class PaintedWindow {
 public:
  PaintedWindow() : record_(machine()) {
    window_.resize(1600, 1000);
    auto* column = new QVBoxLayout(&window_);
    column->addWidget(&overview_);
    column->addWidget(&strip_, 1);
    strip_.setRecord(&record_);
    overview_.setRecord(&record_, false);
    overview_.setLive(true);
    strip_.timeView()->setSpan(10 * kSecond);
    window_.show();
    qApp->installEventFilter(&counter_);
    run(60);
  }
  ~PaintedWindow() { qApp->removeEventFilter(&counter_); }
  PaintedWindow(const PaintedWindow&) = delete;
  PaintedWindow& operator=(const PaintedWindow&) = delete;

  /// So many ticks of a running machine; what was painted in them. `ns`: of this thread a tick.
  PaintedWindow& run(int ticks) {
    QApplication::processEvents();
    counter_.all = counter_.canvases = 0;
    const auto begin = processor_seconds();
    for (int tick = 0; tick < ticks; ++tick) {
      record_.add(samples());
      strip_.refresh();
      QApplication::processEvents();
      // The overview has a timer of its own.
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ns_ = (processor_seconds() - begin) * 1e9 / ticks;
    return *this;
  }
  [[nodiscard]] std::size_t painted() const { return counter_.all; }
  [[nodiscard]] std::size_t plots_painted() const { return counter_.canvases; }
  [[nodiscard]] double ns() const { return ns_; }
  [[nodiscard]] QWidget& window() { return window_; }
  [[nodiscard]] ui::LiveStrip& strip() { return strip_; }

 private:
  static NetworkConfig machine() {
    NetworkConfig config;
    config.cyclic.resize(1);
    config.cyclic.front().cycle_time = kStep;
    config.dc.sync_window.enabled = true;
    config.dc.sync_window.exponent = 7;
    for (int i = 0; i < 20; ++i) config.slaves.emplace_back().name = "Slave_" + std::to_string(1001 + i);
    return config;
  }
  const std::vector<CycleSample>& samples() {
    samples_.resize(267);
    for (auto& sample : samples_) {
      sample.cycle = cycle_;
      sample.send_time = kStart + static_cast<Nanoseconds>(cycle_) * kStep;
      sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
                     CycleSample::kReferenceValid;
      sample.master_state = 8;
      sample.deviation_ns = static_cast<std::uint32_t>(20 + random_() % 40);
      sample.dcm_error_ns = static_cast<std::int32_t>(random_() % 401) - 200;
      sample.slave_position = static_cast<std::int16_t>(cycle_ % 20);
      sample.slave_deviation_ns = static_cast<std::int32_t>(random_() % 41) - 20;
      ++cycle_;
    }
    return samples_;
  }

  RunRecord record_;
  QWidget window_;
  ui::OverviewPanel overview_;
  ui::LiveStrip strip_;
  PaintCounter counter_;
  std::mt19937 random_{3};
  std::uint64_t cycle_ = 0;
  std::vector<CycleSample> samples_;
  double ns_ = 0;
};

void nobody_paints_what_nobody_sees(RatioReport& report) {
  constexpr int kTicks = 300;
  PaintedWindow shown;
  const auto usual = static_cast<double>(shown.run(kTicks).painted());
  const double usual_ns = shown.ns();
  const auto plots = static_cast<double>(shown.plots_painted());
  shown.window().hide();
  report.add_count("G18 paints while hidden", static_cast<double>(shown.run(kTicks).painted()), "of", usual,
                   "while shown, 300 ticks", kNone);
  report.add("a tick while hidden", shown.ns(), "while shown", usual_ns, 0.5);
  shown.window().show();
  shown.window().showMinimized();
  shown.run(10);  // what was wanted before
  report.add_count("G18 paints while minimised", static_cast<double>(shown.run(kTicks).painted()), "of", usual,
                   "while shown, 300 ticks", kNone);
  shown.window().showNormal();
  shown.run(30);
  // Words say by how much the picture is behind; the plots stand.
  shown.strip().timeView()->freeze();
  shown.run(30);
  report.add_count("G18 plots painted while frozen", static_cast<double>(shown.run(kTicks).plots_painted()), "of",
                   plots, "while shown, 300 ticks", kNone);
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  syncline::ui::theme::apply(syncline::ui::theme::Mode::kLight);
  syncline::bench::RatioReport report;
  syncline::bench::spikes_at_any_zoom(report);
  syncline::bench::one_spike_in_100_million(report);
  syncline::bench::columns_stay(report);
  syncline::bench::nobody_paints_what_nobody_sees(report);
  return report.finish("What the plots show");
}
