// SPDX-License-Identifier: Apache-2.0
// The monitor as a whole, for a quarter of an hour of a machine: 200 slaves at 8 kHz, six plots and the overview at 30
// pictures a second, everything kept in memory, a recording beside it. Time goes as fast as the processor lets it; what
// a tick costs is compared with how long a tick lasts.
#include <fmt/format.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <time.h>
#include <unistd.h>

#include <QApplication>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "bench/ratio_report.h"
#include "channels/sample_ring.h"
#include "findings/error_text.h"
#include "record/recent_run.h"
#include "record/recording_writer.h"
#include "record/run_record.h"
#include "support/clock.h"
#include "support/real_time.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overview_panel.h"
#include "ui/theme/theme.h"

namespace syncline::bench {
namespace {

constexpr Nanoseconds kCycle = 125 * kMicrosecond, kStart = 830'000'000 * kSecond;
constexpr Nanoseconds kTick = 33'375 * kMicrosecond;  // 267 cycles
constexpr std::size_t kPerTick = 267;
constexpr int kSlaves = 200, kMinutes = 15, kFilled = 10;  // by then all that is kept is there
constexpr int kTicksAMinute = static_cast<int>(60 * kSecond / kTick);
constexpr Nanoseconds kShown = 60 * kSecond;
constexpr std::size_t kBudget = 256U << 20;  // what the window keeps
constexpr double kMiB = 1024 * 1024;

double resident_mib() {
  std::size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / kMiB;
}

NetworkConfig machine() {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kCycle;
  config.dc.sync_window.enabled = true;
  config.dc.sync_window.exponent = 7;
  for (int i = 0; i < kSlaves; ++i) config.slaves.emplace_back().name = "Slave_" + std::to_string(1001 + i);
  return config;
}

/// A variable for each of the three further plots.
std::vector<WatchedVariable> variables() {
  std::vector<WatchedVariable> result(3);
  const char* names[] = {"Position actual value", "Velocity actual value", "Torque actual value"};
  const char* types[] = {"DINT", "DINT", "INT"};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i].name = names[i];
    result[i].data_type = types[i];
    result[i].bit_offset = static_cast<std::uint32_t>(32 * i);
    result[i].bit_size = i == 2 ? 16 : 32;
    result[i].slave = 0;
  }
  return result;
}

/// The cyclic thread's side.
class Producer {
 public:
  CycleSample next() {
    CycleSample s;
    s.cycle = ++cycle_;
    s.send_time = kStart + static_cast<Nanoseconds>(cycle_) * kCycle;
    s.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
              CycleSample::kReferenceValid | CycleSample::kDeviationValid;
    s.master_state = 8;
    s.slaves_sync = s.master_sync = SyncState::kInSync;
    s.wkc_expected = s.wkc_received = 600;
    s.reference_time = s.send_time;
    s.round_trip_ns = 60'000;
    s.deviation_ns = static_cast<std::uint32_t>(20 + random_() % 40);
    s.deviation_ored_ns = s.deviation_ns | 63U;
    s.dcm_error_ns = static_cast<std::int32_t>(random_() % 401) - 200;
    s.dcm_error_filtered_ns = s.dcm_error_ns / 8;
    s.slave_position = static_cast<std::int16_t>(cycle_ % kSlaves);
    s.slave_deviation_ns = static_cast<std::int32_t>(random_() % 81) - 40;
    s.watch_list = 1;
    s.watched_known = 7;
    for (std::size_t i = 0; i < 3; ++i) s.watched[i] = random_() % 30'000;
    return s;
  }

 private:
  std::mt19937 random_{3};
  std::uint64_t cycle_ = 0;
};

Snapshot snapshot(Nanoseconds time) {
  Snapshot result;
  result.time = time;
  result.online = result.link_up = true;
  result.state = result.requested = AlState::kOp;
  result.cycle_time = kCycle;
  result.slaves.resize(kSlaves);
  for (std::size_t i = 0; i < result.slaves.size(); ++i) {
    result.slaves[i].present = true;
    result.slaves[i].al_status = 8;
    result.slaves[i].dc_enabled = result.slaves[i].follows = i > 0;
  }
  return result;
}

/// What a tick of the window costs.
class Dashboard {
 public:
  Dashboard() : record_(machine()) {
    (void)record_.watch(variables());
    window_.resize(1600, 1000);
    auto* column = new QVBoxLayout(&window_);
    column->addWidget(&overview_);
    column->addWidget(&strip_, 1);
    strip_.setRecord(&record_);
    overview_.setRecord(&record_, false);
    overview_.setLive(true);
    strip_.timeView()->setSpan(kShown);
    window_.show();
  }

  void tick(SampleRing& ring) {
    samples_.clear();
    ring.pop(samples_);
    if (samples_.empty()) return;
    record_.add(samples_);
    recent_.add(samples_);
    if (++ticks_ % 3 == 0) record_.add(snapshot(samples_.back().send_time));
    if (ticks_ % 8 == 0) overview_.refresh();
    strip_.refresh();
    QApplication::processEvents();
  }
  [[nodiscard]] const RunRecord& record() const { return record_; }
  [[nodiscard]] const std::vector<CycleSample>& samples() const { return samples_; }

 private:
  RunRecord record_;
  RecentSamples recent_{kBudget};
  QWidget window_;
  ui::OverviewPanel overview_;
  ui::LiveStrip strip_;
  std::vector<CycleSample> samples_;
  unsigned ticks_ = 0;
};

/// Six plots of Qwt's own curves over the same time, with its strongest filter.
class PlainDashboard {
 public:
  PlainDashboard() {
    window_.resize(1600, 1000);
    auto* column = new QVBoxLayout(&window_);
    std::mt19937 random(1);
    for (int i = 0; i < 6; ++i) {
      auto* plot = new QwtPlot;
      column->addWidget(plot);
      auto* curve = new QwtPlotCurve;
      curve->setPaintAttribute(QwtPlotCurve::FilterPointsAggressive);
      curve->attach(plot);
      QVector<QPointF> points;
      for (int x = 0; x < static_cast<int>(kShown / kCycle); ++x)
        points.append(QPointF(x, static_cast<double>(random() % 401)));
      plots_.push_back({plot, curve, std::move(points)});
    }
    window_.show();
  }
  void tick() {
    for (auto& [plot, curve, points] : plots_) {
      points.remove(0, kPerTick);
      const double last = points.last().x();
      for (std::size_t i = 1; i <= kPerTick; ++i)
        points.append(QPointF(last + static_cast<double>(i), static_cast<double>(random_() % 401)));
      curve->setSamples(points);
      plot->setAxisScale(QwtPlot::xBottom, points.first().x(), points.last().x());
      plot->replot();
    }
    QApplication::processEvents();
  }

 private:
  struct Plot {
    QwtPlot* plot;
    QwtPlotCurve* curve;
    QVector<QPointF> points;
  };
  QWidget window_;
  std::vector<Plot> plots_;
  std::mt19937 random_{2};
};

void bench_dashboard(RatioReport& report) {
  double plain = 0;
  {
    PlainDashboard dashboard;
    plain = median_ns([&] { dashboard.tick(); }, 5);
  }
  SampleRing ring;
  Producer producer;
  Dashboard dashboard;
  std::uint64_t produced = 0;
  double ticked = 0, memory = 0;
  constexpr int kTicks = kMinutes * kTicksAMinute;
  for (int i = 0; i < kTicks; ++i) {
    if (i == kFilled * kTicksAMinute) memory = resident_mib();
    for (std::size_t n = 0; n < kPerTick; ++n) produced += ring.push(producer.next()) ? 1 : 0;
    const auto begin = processor_seconds();
    dashboard.tick(ring);
    ticked += (processor_seconds() - begin) * 1e9;
  }
  const double tick = ticked / kTicks;
  report.add("G17 six plots and overview, 200 slaves: a tick", tick, "how long it lasts", static_cast<double>(kTick),
             0.25);
  report.add("G17 the same", tick, "six Qwt curves, aggressive filter", plain, 0.25);
  report.add_count("samples lost in a quarter of an hour", static_cast<double>(ring.overruns()), "of",
                   static_cast<double>(produced), "samples", 1e-12);
  // A MiB a minute at most.
  constexpr int kMeasured = kMinutes - kFilled;
  report.add_count("G19 memory after a quarter of an hour", resident_mib(), "MiB", memory, "MiB after ten minutes",
                   1.0 + kMeasured / memory);
}

/// The window holds still for five seconds, and for longer than the ring reaches.
void bench_blocked(RatioReport& report) {
  for (const int seconds : {5, 10}) {
    SampleRing ring;
    Producer producer;
    const auto cycles = static_cast<std::size_t>(seconds * kSecond / kCycle);
    for (std::size_t i = 0; i < cycles; ++i) (void)ring.push(producer.next());
    std::vector<CycleSample> samples;
    ring.pop(samples);
    const auto missing = cycles - samples.size();
    report.add_count(fmt::format("G15 window blocked for {} s: samples missing", seconds), static_cast<double>(missing),
                     "of", static_cast<double>(cycles), "samples", seconds == 5 ? 1e-12 : 0);
    if (missing != ring.overruns()) report.add_failure("samples missing", "the ring counts others than are missing");
  }
}

/// What of a core a recording takes: its thread encodes, writes and commits once a second of the run.
void bench_recording(RatioReport& report) {
  const test::TemporaryFolder folder;
  auto about = about_run(machine());
  auto writer = RecordingWriter::create(folder.file("run.slrec"), about);
  if (!writer) return report.add_failure("recording", describe(writer.error()));
  Producer producer;
  const auto second = [&] {
    RecordingBatch batch;
    batch.samples.resize(static_cast<std::size_t>(kSecond / kCycle));
    for (auto& sample : batch.samples) sample = producer.next();
    return batch;
  };
  double written = 0;
  constexpr int kSeconds = 60;
  for (int i = 0; i < kSeconds; ++i) {
    const auto batch = second();
    const auto begin = processor_seconds();
    if (auto status = writer->write(batch); !status) return report.add_failure("recording", describe(status.error()));
    written += processor_seconds() - begin;
  }
  report.add("recording 200 slaves at 8 kHz", written / kSeconds * 1e9, "a second", 1e9, 0.02);
}

/// The slowest of a thousand, against the slowest of a thousand readings of the clock.
void bench_push(RatioReport& report) {
  constexpr int kRounds = 200'000;
  SampleRing ring;
  Producer producer;
  const auto sample = producer.next();
  std::vector<CycleSample> drained;
  drained.reserve(1U << 16);
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * kSecond + time.tv_nsec;
  };
  const auto slow = [&](auto&& call) {
    std::vector<Nanoseconds> took(kRounds);
    for (int i = 0; i < kRounds; ++i) {
      const auto begin = now();
      call();
      took[static_cast<std::size_t>(i)] = now() - begin;
      if (i % 1024 == 0) {
        drained.clear();
        ring.pop(drained);
      }
    }
    const auto place = took.begin() + kRounds / 1000 * 999;
    std::nth_element(took.begin(), place, took.end());
    return static_cast<double>(*place);
  };
  const auto read = slow([&] { (void)now(); });
  const auto push = slow([&] { (void)ring.push(sample); });
  report.add("G14 sample through the ring, p99.9", push, "reading the clock, p99.9", read, 10);
  // Of a recording the cyclic thread knows nothing: what is written is what comes out of the ring.
  report.add("the same, all that a recording asks of the cyclic thread", push, "a microsecond", kMicrosecond, 1);
}

/// A cyclic thread on the real clock: how late it woke, each cycle.
class RealProducer {
 public:
  RealProducer(SampleRing& ring, Producer& producer)
      : thread_([this, &ring, &producer](const std::stop_token& stop) {
          const RealTimeScope real_time;
          RealClock clock;
          auto next = clock.now();
          while (!stop.stop_requested()) {
            clock.sleep_until(next += kCycle);
            const auto late = clock.now() - next;
            (void)ring.push(producer.next());
            // A cycle that came too late for the next one leaves it out, as the master does.
            if (late > kCycle) next += late / kCycle * kCycle;
            if (late_.size() < late_.capacity()) late_.push_back(late);
          }
        }) {}
  /// Ends it; p99.9 in ns.
  double finish() {
    thread_.request_stop();
    thread_.join();
    const auto place = late_.begin() + static_cast<std::ptrdiff_t>(late_.size() * 999 / 1000);
    std::nth_element(late_.begin(), place, late_.end());
    return static_cast<double>(*place);
  }

 private:
  static std::vector<Nanoseconds> room() {
    std::vector<Nanoseconds> result;
    result.reserve(1U << 20);
    return result;
  }
  std::vector<Nanoseconds> late_ = room();
  std::jthread thread_;
};

/// Whether plots make the cyclic thread later: with and without them in turn, the median of five pairs.
void bench_producer(RatioReport& report) {
  constexpr int kPairs = 5, kTicks = 90;
  const auto next_tick = [](Nanoseconds& time) {
    time += kTick;
    const auto left = time - RealClock().now();
    if (left > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(left));
  };
  std::vector<double> headless, shown;
  Dashboard dashboard;
  Producer samples;
  for (int pair = 0; pair < kPairs; ++pair) {
    for (const bool plots : {false, true}) {
      SampleRing ring;
      RealProducer producer(ring, samples);
      std::vector<CycleSample> drained;
      auto time = RealClock().now();
      for (int tick = 0; tick < kTicks; ++tick) {
        next_tick(time);
        if (plots) {
          dashboard.tick(ring);
        } else {
          drained.clear();
          ring.pop(drained);
        }
      }
      (plots ? shown : headless).push_back(producer.finish());
    }
  }
  const auto median = [](std::vector<double>& of) {
    std::nth_element(of.begin(), of.begin() + kPairs / 2, of.end());
    return of[kPairs / 2];
  };
  const auto without = median(headless);
  report.add("G16 cyclic thread late with six plots, p99.9", median(shown), "without a window, p99.9", without, 2);
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  syncline::ui::theme::apply(syncline::ui::theme::Mode::kLight);
  syncline::bench::RatioReport report;
  syncline::bench::bench_push(report);
  syncline::bench::bench_producer(report);
  syncline::bench::bench_blocked(report);
  syncline::bench::bench_recording(report);
  syncline::bench::bench_dashboard(report);
  return report.finish("The monitor, 200 slaves at 8 kHz");
}
