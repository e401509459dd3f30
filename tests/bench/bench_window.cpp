// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QTest>
#include <QThread>
#include <QUndoStack>
#include <algorithm>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/ratio_report.h"
#include "compare/line_difference.h"
#include "eni/project/line_wiring.h"
#include "settings/settings_table.h"
#include "tests/support/sample_devices.h"
#include "tests/support/source_dir.h"
#include "ui/main_window.h"
#include "ui/models/eni_model.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/topology_view.h"
#include "ui/session/eni_preview.h"
#include "ui/session/project_copy.h"
#include "ui/session/project_document.h"
#include "ui/session/scan_controller.h"
#include "ui/session/workspace.h"
#include "ui/support/ui_test_support.h"

/// What the window's own thread does about a large project, against a picture of its plots; and the comparison of long
/// texts.
namespace syncline::bench {
namespace {

constexpr double kPicture = 33e6, kSecondNs = 1e9;  // ns

/// Couplers, terminals and drives in the proportions of the small machine, over and over.
Project thousand_slaves() {
  auto machine = sample::small_machine();
  const auto pattern = machine.slaves;
  machine.slaves.clear();
  for (std::size_t i = 0; i < 1'000; ++i)
    machine.slaves.push_back(default_slave(pattern[i % pattern.size()].device, static_cast<std::uint16_t>(i)));
  eni::wire_in_order(machine.slaves);
  return machine;
}

bool wait_for(const std::function<bool()>& done, double& longest) {
  constexpr int kMostRounds = 60'000;
  for (int i = 0; i < kMostRounds && !done(); ++i) {
    const auto begin = processor_seconds();
    QApplication::processEvents(QEventLoop::AllEvents, 1);
    longest = std::max(longest, (processor_seconds() - begin) * 1e9);
    QThread::msleep(1);
  }
  return done();
}

/// An edit while the preview of the ENI is watched: who computes it is another thread.
void bench_preview(RatioReport& report) {
  const std::string what = "ENI preview, 1000 slaves";
  ui::ProjectDocument document;
  document.take({"m", {thousand_slaves()}}, {});
  ui::EniPreview preview(document);
  ui::EniModel model;
  QObject::connect(&preview, &ui::EniPreview::changed, &model, [&] { model.setView(preview.view()); });
  preview.setWatched(true);
  const auto done = [&] { return preview.isCurrent() && preview.check() != nullptr; };
  double longest = 0;
  if (!wait_for(done, longest)) return report.add_failure(what, "no preview came");
  longest = 0;
  const auto begin = processor_seconds();
  const auto edited = document.edit(QStringLiteral("name"), [](Project& project) {
    project.slaves[500].name = "Other";
    return Status{};
  });
  const double edit = (processor_seconds() - begin) * 1e9;
  if (!edited || !wait_for([&] { return !done(); }, longest) || !wait_for(done, longest))
    return report.add_failure(what, "no second preview came");
  report.add(what + ", the edit", edit, "a picture of the plots", kPicture, 1);
  report.add(what + ", longest hold behind it", longest, "a picture of the plots", kPicture, 1);
  const auto first = ui::ProjectCopy::of(document.project(), nullptr);
  report.add("copy of 1000 slaves beside another",
             median_ns([&] { static_cast<void>(ui::ProjectCopy::of(document.project(), first.get())); }),
             "a picture of the plots", kPicture, 1);
}

/// The worst there is: the same hundred thousand lines, in another order; and one line in twenty altered.
void bench_lines(RatioReport& report) {
  std::mt19937 random(1);
  std::vector<std::uint32_t> left(100'000);
  for (auto& token : left) token = static_cast<std::uint32_t>(random() % 300);
  auto right = left;
  std::shuffle(right.begin(), right.end(), random);
  const auto took = [&] { return median_ns([&] { static_cast<void>(line_difference(left, right)); }, 1); };
  report.add("100,000 lines in another order", took(), "a second", kSecondNs, 1);
  right = left;
  for (std::size_t i = 0; i < right.size(); i += 20) right[i] = 1'000 + static_cast<std::uint32_t>(i);
  report.add("100,000 lines, 5,000 altered", took(), "a second", kSecondNs, 1);
}

double once(const std::function<void()>& action) {
  const auto begin = processor_seconds();
  action();
  return (processor_seconds() - begin) * 1e9;
}

constexpr int kRounds = 200;

/// Of so many rounds: what 99 of 100 keep, and the slowest; ns of the window's thread.
struct Slow {
  double p99 = 0, slowest = 0;
};

Slow slow(const std::function<void()>& between, const std::function<void()>& action, int rounds = kRounds) {
  std::vector<double> took;
  for (int i = 0; i < rounds; ++i) {
    between();
    took.push_back(once(action));
  }
  std::ranges::sort(took);
  return {took[static_cast<std::size_t>(0.99 * (rounds - 1))], took.back()};
}

/// The machine of resources/scenarios/thousand.toml, as a scan finds it.
std::optional<Project> scanned(const ui::Environment& environment, const QString& link) {
  ui::ScanController scan(environment.scan_bus, environment.describe_slaves, environment.esi_folders);
  std::optional<Project> found;
  bool over = false;
  QObject::connect(&scan, &ui::ScanController::finished, &scan, [&](const QString&, const ui::ScanOutcome& outcome) {
    found = outcome.built.project;
    over = true;
  });
  QObject::connect(&scan, &ui::ScanController::failed, &scan, [&over] { over = true; });
  scan.start(link);
  double longest = 0;
  static_cast<void>(wait_for([&over] { return over; }, longest));
  return found;
}

/// A thousand slaves in the whole window, as they are worked with, while the machine runs.
class ThousandSlaves {
 public:
  explicit ThousandSlaves(RatioReport& report) : report_(report) {
    workspace_.live().setAutoAdvance(false);
    const auto link = QStringLiteral("sim:") + QString::fromStdString(test::source_dir()) +
                      QStringLiteral("/resources/scenarios/thousand.toml?virtual");
    const auto project = scanned(workspace_.environment(), link);
    if (!project) return;
    project_ = *project;
    window_.resize(1600, 1000);
    window_.show();
    workspace_.setLink(link);
    open();
  }
  ~ThousandSlaves() {
    workspace_.runs().shutDown();
    workspace_.document().undoStack().setClean();
  }
  ThousandSlaves(const ThousandSlaves&) = delete;
  ThousandSlaves& operator=(const ThousandSlaves&) = delete;

  void run() {
    const std::string machine = "1000 slaves";
    if (project_.slaves.size() < 1'000) return report_.add_failure(machine, "the scan found none");
    const auto opened = slow([] {}, [this] { open(); }, 20);
    report_.add(machine + ": open", opened.slowest, "a second", kSecondNs, 0);
    if (!goOnline()) return report_.add_failure(machine, "they do not come to OP");
    auto& explorer = window_.explorer();
    int round = 0;
    add("another view", [&] {
      explorer.setView(round++ % 2 == 0 ? ui::ExplorerPanel::View::kTopology : ui::ExplorerPanel::View::kClassic);
    });
    add("select one", [&] { window_.selectNode(round = (round + 371) % 1000); });
    explorer.setView(ui::ExplorerPanel::View::kTopology);
    add("paint the topology", [&] { explorer.topology().viewport()->repaint(); });
    explorer.setView(ui::ExplorerPanel::View::kClassic);
    add("edit one, until it is compiled", [&] {
      const auto& alias = settings::row("slave.N.alias");
      const settings::Place place{.slave = static_cast<std::size_t>(round = (round + 371) % 1000)};
      static_cast<void>(workspace_.document().set(QStringLiteral("alias"), {{&alias, place, std::int64_t{round}}}));
      static_cast<void>(workspace_.configuration().current());
    });
    addSearch();
    addFrames();
  }

 private:
  void open() {
    workspace_.document().replace(QStringLiteral("load"), project_);
    workspace_.document().undoStack().clear();
    QApplication::processEvents();
  }
  bool goOnline() {
    if (!workspace_.goOnline()) return false;
    for (int i = 0; i < 400 && workspace_.live().snapshot().state != AlState::kOp; ++i)
      workspace_.live().advance(100 * kMillisecond);
    return workspace_.live().snapshot().state == AlState::kOp;
  }
  /// A tick's worth of the machine, whose values the window then shows.
  void tick() { workspace_.live().advance(33 * kMillisecond); }
  void add(const char* what, const std::function<void()>& action) {
    const auto took = slow([this] { tick(); },
                           [&] {
                             action();
                             QApplication::processEvents();
                           });
    report_.add(std::string("1000 slaves, running: ") + what + ", p99 of 200", took.p99, "a tenth of a second", kFluid,
                1);
    report_.add(std::string("1000 slaves, running: ") + what + ", the slowest", took.slowest, "a tenth of a second",
                kFluid, 0);
  }
  /// From key to key.
  void addSearch() {
    window_.findChild<QAction*>(QStringLiteral("actionGoTo"))->trigger();
    auto* words = window_.findChild<QLineEdit*>(QStringLiteral("goToSearch"));
    if (words == nullptr) return report_.add_failure("1000 slaves: search", "there is none");
    const QString typed = QStringLiteral("slave.900.alias");
    int round = 0;
    add("a letter of a search", [&] { words->setText(typed.left(++round % (typed.size() + 1))); });
    add("search an object", [&] { words->setText(QStringLiteral("7000:0%1").arg(++round % 9)); });
    QTest::keyClick(words, Qt::Key_Escape);
  }
  /// Each picture of each view of the live strip, and not only most of them.
  void addFrames() {
    using Body = ui::LiveStrip::Body;
    const std::pair<Body, const char*> bodies[] = {
        {Body::kPlots, "plots"},         {Body::kFree, "own plots"}, {Body::kDistribution, "distribution"},
        {Body::kStability, "stability"}, {Body::kSlaves, "slaves"},  {Body::kCycle, "cycle"}};
    for (const auto& [body, name] : bodies) {
      window_.liveStrip().showBody(body);
      addPictures(name);
    }
  }
  void addPictures(const std::string& view) {
    auto& strip = window_.liveStrip();
    for (int i = 0; i < 30; ++i) {  // what is made once
      tick();
      strip.refresh();
      QApplication::processEvents();
    }
    const auto took = slow([this] { tick(); },
                           [&] {
                             strip.refresh();
                             QApplication::processEvents();
                           });
    report_.add("1000 slaves, running: a picture of the live strip (" + view + "), the slowest of 200", took.slowest,
                "a thirtieth of a second", kPicture, 1);
  }

  static constexpr double kFluid = 100e6;
  RatioReport& report_;
  Project project_;
  ui::Workspace workspace_{test::virtualEnvironment()};
  ui::MainWindow window_{workspace_};
};

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  syncline::bench::RatioReport report;
  syncline::bench::bench_preview(report);
  syncline::bench::bench_lines(report);
  syncline::bench::ThousandSlaves(report).run();
  return report.finish("Large projects in the window");
}
