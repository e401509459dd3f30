// SPDX-License-Identifier: Apache-2.0
// Pictures of recordings without a window: what is drawn, and the program that writes them where there is no display.
#include "ui/panels/recording_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QProcess>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "eni/project/project_file.h"
#include "record/replay_run.h"
#include "support/ui_test_support.h"
#include "tests/app/cli_runner.h"
#include "ui/panels/overview_panel.h"
#include "ui/panels/picture_file.h"
#include "ui/plots/heat_legend.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;

constexpr Nanoseconds kPictureEpoch = 830'000'000 * kSecond;

class RecordingPictureTest : public testing::Test {
 protected:
  void SetUp() override {
    NetworkConfig config;
    config.cyclic.resize(1);
    config.cyclic[0].cycle_time = kMillisecond;
    for (const char* name : {"Coupler", "Servo"}) config.slaves.emplace_back().name = name;
    config.dc.enabled = true;
    run.record = std::make_unique<RunRecord>(std::move(config), 20'000, RunLimits{kMillisecond, 127, 4000}, 0x1000);
    run.info.about.slaves = {{"Coupler", 2, 3, 4}, {"Servo", 2, 5, 6}};
    std::vector<CycleSample> samples(10'000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      auto& sample = samples[i];
      const auto part = static_cast<std::int32_t>(i % 37) - 18;
      sample.cycle = i;
      sample.send_time = kPictureEpoch + static_cast<Nanoseconds>(i) * kMillisecond;
      sample.flags = CycleSample::kFollowersRead | CycleSample::kDcmActive | CycleSample::kReferenceValid |
                     CycleSample::kSlaveFollows;
      sample.deviation_ns = i == 7000 ? 100U : 30U;
      sample.slave_position = 1;
      sample.slave_deviation_ns = part;
      sample.dcm_error_ns = 40 * part;
      sample.dcm_error_filtered_ns = 10 * part;
      sample.master_state = static_cast<std::uint8_t>(AlState::kOp);
      sample.slaves_sync = sample.master_sync = SyncState::kInSync;
    }
    run.record->add(samples);
  }
  QString path(const char* name) { return folder.filePath(QLatin1String(name)); }
  QByteArray written(const RecordingPicture& wanted, const char* name) {
    const auto status = writeRecordingPicture(run, wanted, path(name));
    EXPECT_TRUE(status.has_value()) << name << ": " << status.error().subject << " " << status.error().detail.text();
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  QTemporaryDir folder;
  ReplayedRun run;
};

/// The words of an SVG, a line each.
std::string wordsOf(const QByteArray& svg) {
  static const QRegularExpression words(QStringLiteral(">([^<>]+)</text>"));
  QStringList all;
  for (auto matches = words.globalMatch(QString::fromUtf8(svg)); matches.hasNext();) all << matches.next().captured(1);
  return all.join(u'\n').replace(u'\u00A0', u' ').toStdString();
}

TEST_F(RecordingPictureTest, PlotsHaveLimitsDateAndCycle) {
  const auto svg = written({}, "plots.svg");
  EXPECT_EQ(QSvgRenderer(svg).viewBox().size(), QSize(1280, 460));
  const auto words = wordsOf(svg);
  EXPECT_THAT(words, HasSubstr("DC deviation"));
  EXPECT_THAT(words, HasSubstr("limit \u00B1127 ns"));
  EXPECT_THAT(words, HasSubstr("Syncline, 2026-04-20 11:33:20.000 \u2013 11:33:29.999 UTC, cycle 1 ms"));
  EXPECT_THAT(words, HasSubstr("Servo"));
}

TEST_F(RecordingPictureTest, OfASimulatedMachineSayThatItIsOne) {
  EXPECT_THAT(wordsOf(written({}, "real.svg")), testing::Not(HasSubstr("simulated")));
  run.record->set_link("sim:demo/machine.toml?virtual");
  EXPECT_THAT(wordsOf(written({}, "simulated.svg")), HasSubstr("Syncline, simulated machine, 2026-04-20"));
  RecordingPicture overview;
  overview.view = PictureView::kOverview;
  EXPECT_THAT(wordsOf(written(overview, "overview.svg")), HasSubstr("simulated machine"));
}

TEST_F(RecordingPictureTest, ARangeIsAllThatIsShown) {
  RecordingPicture wanted;
  wanted.range = {kPictureEpoch + 2 * kSecond, kPictureEpoch + 3 * kSecond};
  const auto words = wordsOf(written(wanted, "range.svg"));
  EXPECT_THAT(words, HasSubstr("11:33:22.000 \u2013 11:33:23.000 UTC"));
  EXPECT_THAT(words, HasSubstr("peak 30 ns")) << "what lies outside does not count";
  EXPECT_THAT(wordsOf(written({}, "all.svg")), HasSubstr("peak 100 ns"));
}

TEST_F(RecordingPictureTest, EveryViewIsWrittenInEveryForm) {
  for (const auto& name : pictureViewNames()) {
    if (name == QStringLiteral("cycle")) continue;  // nobody has SYNC0
    RecordingPicture wanted;
    wanted.view = *pictureViewOf(name);
    const auto png = QImage::fromData(written(wanted, "view.png"));
    ASSERT_FALSE(png.isNull()) << name.toStdString();
    EXPECT_EQ(png.width(), 2 * (wanted.view == PictureView::kSlaves ? 1760 : 1280)) << name.toStdString();
    EXPECT_EQ(png.pixel(1, 1), qRgb(255, 255, 255));
    int inked = 0;
    for (int y = 0; y < png.height(); y += 2) {
      for (int x = 0; x < png.width(); x += 2) inked += qGray(png.pixel(x, y)) < 128 ? 1 : 0;
    }
    EXPECT_GT(inked, 500) << name.toStdString();
    EXPECT_THAT(wordsOf(written(wanted, "view.svg")), HasSubstr("cycle 1 ms")) << name.toStdString();
    EXPECT_TRUE(written(wanted, "view.pdf").startsWith("%PDF-")) << name.toStdString();
  }
}

/// What a view shows as a table, without a window.
TEST_F(RecordingPictureTest, WhatIsShownIsWrittenAsATable) {
  RecordingPicture wanted;
  wanted.view = PictureView::kDistribution;
  wanted.sources = {{Signal::kDcmError, 0}};
  const auto bars = written(wanted, "bars.csv");
  EXPECT_TRUE(bars.startsWith("from")) << bars.left(80).toStdString();
  EXPECT_TRUE(bars.contains("dcm_error_ns")) << bars.left(80).toStdString();
  EXPECT_GT(bars.count('\n'), 20);
  wanted = {};
  wanted.view = PictureView::kStability;
  EXPECT_GT(written(wanted, "stability.csv").count('\n'), 5);
  wanted.view = PictureView::kSlaves;
  EXPECT_TRUE(written(wanted, "slaves.csv").contains("Servo"));
  wanted.view = PictureView::kOverview;
  EXPECT_FALSE(writeRecordingPicture(run, wanted, path("overview.csv")));
  EXPECT_EQ(cycleFigureOf(QStringLiteral("bathtub")), CycleView::Figure::kBathtub);
  EXPECT_FALSE(cycleFigureOf(QStringLiteral("mtie")));
}

TEST_F(RecordingPictureTest, TheLegendOfTheHeatMapIsWhole) {
  RecordingPicture wanted;
  wanted.view = PictureView::kSlaves;
  const auto png = QImage::fromData(written(wanted, "legend.png"));
  HeatLegend legend;
  legend.setScale(127, true);
  const int words = 2 * legend.sizeHint().width(), lines = 2 * legend.sizeHint().height();
  int last = 0;
  for (int y = 0; y < lines; ++y) {
    for (int x = 0; x < words + 40; ++x) {
      if (qGray(png.pixel(x, y)) < 200) last = std::max(last, x);
    }
  }
  EXPECT_GT(last, words - 20) << "its last words stand there";
}

/// Points are 1/72 of an inch, pixels of the screen 1/96.
TEST_F(RecordingPictureTest, ThePageIsAsLargeAsItWasAskedFor) {
  RecordingPicture wanted;
  wanted.size = {1600, 800};
  EXPECT_EQ(QImage::fromData(written(wanted, "large.png")).size(), QSize(3200, 1600));
  const auto pdf = written(wanted, "large.pdf");
  static const QRegularExpression box(QStringLiteral("/MediaBox \\[0 0 ([\\d.]+) ([\\d.]+)\\]"));
  const auto match = box.match(QString::fromLatin1(pdf));
  ASSERT_TRUE(match.hasMatch());
  const double dpi = QWidget().logicalDpiX();
  EXPECT_NEAR(match.captured(1).toDouble(), 1600 * 72 / dpi, 1);
  EXPECT_NEAR(match.captured(2).toDouble(), 800 * 72 / dpi, 1);
  wanted.size = {900, 400};
  EXPECT_EQ(QImage::fromData(written(wanted, "narrow.png")).size(), QSize(1800, 800));
  wanted.size = {120, 120};
  const auto small = writeRecordingPicture(run, wanted, path("small.png"));
  ASSERT_FALSE(small.has_value());
  EXPECT_EQ(small.error().code, ErrorCode::kBadValue);
  EXPECT_FALSE(QFile::exists(path("small.png")));
}

TEST_F(RecordingPictureTest, SignalsAreChosenByTheirKeys) {
  const auto error = signalSourceOf(QStringLiteral("dcm_error_ns"), *run.record);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(*error, (SignalSource{Signal::kDcmError, 0}));
  const auto servo = signalSourceOf(QStringLiteral("deviation_ns@1"), *run.record);
  ASSERT_TRUE(servo.has_value());
  EXPECT_EQ(*servo, (SignalSource{Signal::kSlaveDeviation, 1}));
  for (const char* none : {"poem", "deviation_ns@0", "deviation_ns@2", "deviation_ns@", "deviation_ns@1@1",
                           "arrival_phase_ns@1", "cycle", "wkc_expected"})
    EXPECT_FALSE(signalSourceOf(QLatin1String(none), *run.record).has_value()) << none;
  RecordingPicture wanted;
  wanted.view = PictureView::kDistribution;
  wanted.sources = {*error, *servo};
  const auto words = wordsOf(written(wanted, "distribution.svg"));
  EXPECT_THAT(words, HasSubstr("DCM error"));
  EXPECT_THAT(words, HasSubstr("#1 Servo"));
  wanted.view = PictureView::kStability;
  wanted.figure = StabilityView::Figure::kMtie;
  EXPECT_THAT(wordsOf(written(wanted, "mtie.svg")), HasSubstr("MTIE over the observation time"));
}

TEST_F(RecordingPictureTest, OwnPlotsAreOfAnySignals) {
  RecordingPicture wanted;
  wanted.view = PictureView::kFree;
  for (const char* key : {"wkc_received", "dcm_error_ns", "deviation_ns@0", "al_status@1", "port3_lost_links@1"}) {
    const auto source = drawnSignalOf(QLatin1String(key), *run.record);
    ASSERT_TRUE(source.has_value()) << key;
    wanted.sources.push_back(*source);
  }
  for (const char* none :
       {"poem", "cycle", "al_status", "al_status@2", "al_status@", "al_status@1@1", "dcm_error_ns@0"})
    EXPECT_FALSE(drawnSignalOf(QLatin1String(none), *run.record).has_value()) << none;
  const auto words = wordsOf(written(wanted, "own.svg"));
  for (const char* name : {"Working counter, received", "DCM error", "#0 Coupler: Deviation", "#1 Servo: AL state"})
    EXPECT_THAT(words, HasSubstr(name));
}

TEST_F(RecordingPictureTest, OwnPlotsAreThoseOfTheProjectThatWasRun) {
  Project project;
  for (const char* name : {"First", "Second"}) {
    ViewPlot plot;
    plot.title = std::string(name) + " plot";
    plot.signals = {{ViewSignal::Of::kBus, "drift_ppm", 0, false, false, false}};
    project.views.push_back({name, {plot}});
  }
  run.info.about.documents = {{"project", "m.syncline", eni::write_project(project)}};
  RecordingPicture wanted;
  wanted.view = PictureView::kFree;
  EXPECT_THAT(wordsOf(written(wanted, "first.svg")), HasSubstr("First plot"));
  wanted.own_view = QStringLiteral("Second");
  EXPECT_THAT(wordsOf(written(wanted, "second.svg")), HasSubstr("Second plot"));
  wanted.own_view = QStringLiteral("Third");
  const auto none = writeRecordingPicture(run, wanted, path("third.svg"));
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::kBadValue);
}

TEST_F(RecordingPictureTest, SaysWhatIsMissing) {
  RecordingPicture wanted;
  const auto name = writeRecordingPicture(run, wanted, path("plots.bmp"));
  ASSERT_FALSE(name.has_value());
  EXPECT_EQ(name.error().code, ErrorCode::kBadValue);
  const auto place = writeRecordingPicture(run, wanted, path("none/plots.png"));
  ASSERT_FALSE(place.has_value());
  EXPECT_EQ(place.error().code, ErrorCode::kFileNotWritable);
  wanted.view = PictureView::kCycle;
  const auto view = writeRecordingPicture(run, wanted, path("cycle.png"));
  ASSERT_FALSE(view.has_value());
  EXPECT_EQ(view.error().code, ErrorCode::kBadValue);
}

/// The same in the dark theme, whose widgets are as they were afterwards.
TEST_F(RecordingPictureTest, TheOverviewIsLightAndHasNoButtons) {
  OverviewPanel panel;
  panel.setRecord(run.record.get(), true);
  panel.resize(1200, 240);
  panel.show();
  const auto light = pictureFile(panel.picture(), PictureForm::kPng);
  EXPECT_THAT(wordsOf(pictureFile(panel.picture(), PictureForm::kSvg)), testing::Not(HasSubstr("Re-arm")));
  theme::apply(theme::Mode::kDark);
  QApplication::processEvents();
  panel.refresh();
  ASSERT_LT(qGray(panel.grab().toImage().pixel(2, 2)), 100);
  const auto dark = panel.grab().toImage();
  EXPECT_TRUE(QImage::fromData(pictureFile(panel.picture(), PictureForm::kPng)) == QImage::fromData(light));
  EXPECT_TRUE(panel.grab().toImage() == dark);
  theme::apply(theme::Mode::kLight);
}

TEST_F(RecordingPictureTest, FiguresAreCopiedAsText) {
  OverviewPanel panel;
  panel.setRecord(run.record.get(), true);
  panel.resize(1200, 240);
  panel.show();
  test::find<QToolButton>(panel, "overviewMenuButton")->click();
  auto* menu = panel.findChild<QMenu*>(QStringLiteral("overviewMenu"));
  ASSERT_NE(menu, nullptr);
  menu->findChild<QAction*>(QStringLiteral("actionCopyFigures"))->trigger();
  const auto text = QApplication::clipboard()->text().replace(u'\u00A0', u' ').toStdString();
  EXPECT_THAT(text, HasSubstr("DC deviation, max\t100 ns at 7.000 s\n"));
  EXPECT_THAT(text, HasSubstr("\nSlaves\tAt the end: In sync\t"));
  EXPECT_THAT(text, testing::Not(HasSubstr("<"))) << "no markup";
}

/// The program as it is installed, where there is no display.
class PictureProgram : public testing::Test {
 protected:
  void SetUp() override {
    const auto run = test::cli_run(
        {"project", "create", path("m.syncline"), "--scan", test::demo(), "--cycle", "1000", "--sync-window", "on"});
    ASSERT_EQ(run.code, cli::kDone) << run.err;
    const auto recorded = test::cli_run({"run", path("m.syncline"), "--link", test::demo("?virtual&seed=5"), "--for",
                                         "4s", "--record", path("run.slrec")});
    ASSERT_EQ(recorded.code, cli::kDone) << recorded.err;
  }
  std::string path(const char* name) { return folder.filePath(QLatin1String(name)).toStdString(); }
  int start(const std::vector<std::string>& arguments) {
    QStringList words;
    for (const auto& argument : arguments) words << QString::fromStdString(argument);
    QProcess process;
    auto environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR"})
      environment.remove(QLatin1String(name));
    environment.insert(QStringLiteral("HOME"), folder.path());
    process.setProcessEnvironment(environment);
    process.start(QCoreApplication::applicationDirPath() + QStringLiteral("/syncline"), words);
    EXPECT_TRUE(process.waitForFinished(60'000));
    err = process.readAllStandardError().toStdString();
    return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
  }

  QTemporaryDir folder;
  std::string err;
};

TEST_F(PictureProgram, WritesAPictureWithoutADisplay) {
  EXPECT_EQ(start({path("run.slrec"), "--picture", path("a.svg"), "--from", "500ms", "--to", "2s"}), 0) << err;
  EXPECT_EQ(err, "");
  EXPECT_GT(QFileInfo(QString::fromStdString(path("a.svg"))).size(), 10'000);
  EXPECT_EQ(start({path("run.slrec"), "--picture", path("b.pdf"), "--view", "cycle", "--slave", "3"}), 0) << err;
  EXPECT_EQ(start({path("run.slrec"), "--picture", path("d.svg"), "--overlay", path("run.slrec"), "--align", "armed",
                   "--offset", "-20ms"}),
            0)
      << err;
  EXPECT_EQ(start({path("run.slrec"), "--picture", path("c.png"), "--view", "overview", "--language", "de"}), 0) << err;
  EXPECT_FALSE(QImage(QString::fromStdString(path("c.png"))).isNull());
}

/// Its picture is made of what is left, and what is lost is told; of two, by the name of which.
TEST_F(PictureProgram, SaysWhatIsLostOfARecording) {
  const auto cut = path("cut.slrec");
  std::filesystem::copy_file(path("run.slrec"), cut);
  std::filesystem::resize_file(cut, std::filesystem::file_size(cut) * 19 / 20);
  EXPECT_EQ(start({cut, "--picture", path("a.svg")}), 0) << err;
  EXPECT_THAT(err, HasSubstr("cut.slrec: The file is cut off: "));
  EXPECT_EQ(start({path("run.slrec"), "--picture", path("b.svg"), "--overlay", cut}), 0) << err;
  EXPECT_THAT(err, HasSubstr("cut.slrec: The file is cut off: "));
  EXPECT_THAT(err, testing::Not(HasSubstr("run.slrec")));
}

TEST_F(PictureProgram, SaysWhatItCannotDo) {
  const auto refused = [this](const std::vector<std::string>& arguments, int code, const char* words) {
    EXPECT_EQ(start(arguments), code) << words;
    EXPECT_THAT(err, HasSubstr(words));
  };
  const auto file = path("run.slrec"), out = path("out.png");
  refused({file, "--picture", out, "--view", "poem"}, 2, "take one of overview, plots");
  refused({file, "--picture", path("out.bmp")}, 2, ".png, .svg, .pdf or .csv");
  refused({file, "--picture", out, "--from", "1h"}, 2, "it holds nothing of the recording");
  refused({file, "--picture", out, "--from", "soon"}, 2, "use a duration");
  refused({file, "--picture", out, "--offset", "3s"}, 2, "--overlay");
  refused({file, "--picture", out, "--overlay", file, "--align", "moon"}, 2, "begin, armed");
  refused({file, "--picture", out, "--overlay", file, "--offset", "soon"}, 2, "1.5s");
  refused({file, "--picture", out, "--overlay", file, "--view", "slaves"}, 2, "plots");
  refused({file, "--picture", out, "--overlay", path("none.slrec")}, 3, "none.slrec");
  refused({file, "--picture", out, "--signal", "dcm_error_ns"}, 2, "distribution and stability");
  refused({file, "--picture", out, "--view", "distribution", "--signal", "poem"}, 2, "dcm_error_ns");
  refused({file, "--picture", out, "--size", "9x9"}, 2, "--size 9x9");
  refused({file, "--picture", out, "--slave", "99"}, 2, "counted from 0");
  refused({"--picture", out}, 2, "name a recording");
  refused({file, "--picture", out, "--poem"}, 2, "poem");
  refused({path("none.slrec"), "--picture", out}, 3, "none.slrec");
  refused({path("m.syncline"), "--picture", out}, 3, "another kind of file");
  refused({file, "--picture", path("none/out.png")}, 3, "none");
  const auto cut = path("damaged.slrec");
  std::filesystem::copy_file(file, cut);
  const auto size = std::filesystem::file_size(cut);
  std::filesystem::resize_file(cut, size / 20);
  refused({cut, "--picture", out}, 3, "damaged or cut off (no whole cycle of it is left)");
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace syncline::ui
