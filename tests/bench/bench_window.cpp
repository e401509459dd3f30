// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QTest>
#include <QThread>
#include <QUndoStack>
#include <algorithm>
#include <functional>
#include <random>

#include "bench/ratio_report.h"
#include "compare/line_difference.h"
#include "eni/project/line_wiring.h"
#include "tests/support/sample_devices.h"
#include "ui/main_window.h"
#include "ui/models/eni_model.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/topology_view.h"
#include "ui/session/eni_preview.h"
#include "ui/session/project_copy.h"
#include "ui/session/project_document.h"
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

/// The slowest of twenty, in ns of the window's thread.
double slowest(const std::function<void()>& action) {
  double longest = 0;
  for (int i = 0; i < 20; ++i) longest = std::max(longest, once(action));
  return longest;
}

/// A thousand slaves in the whole window, as they are worked with.
void bench_thousand(RatioReport& report) {
  constexpr double kFluid = 100e6;
  ui::Workspace workspace(test::virtualEnvironment());
  ui::MainWindow window(workspace);
  const auto load = once([&] {
    workspace.document().replace(QStringLiteral("load"), thousand_slaves());
    window.show();
    QApplication::processEvents();
  });
  auto& explorer = window.explorer();
  int round = 0;
  const auto add = [&](const char* what, const std::function<void()>& action) {
    report.add(std::string("1000 slaves: ") + what + ", the slowest of 20", slowest(action), "a tenth of a second",
               kFluid, 1);
  };
  report.add("1000 slaves: open", load, "a second", kSecondNs, 0);
  add("another view", [&] {
    explorer.setView(round++ % 2 == 0 ? ui::ExplorerPanel::View::kTopology : ui::ExplorerPanel::View::kClassic);
    QApplication::processEvents();
  });
  add("select one", [&] {
    window.selectNode(round = (round + 371) % 1000);
    QApplication::processEvents();
  });
  explorer.setView(ui::ExplorerPanel::View::kTopology);
  add("paint the topology", [&] { explorer.topology().viewport()->repaint(); });
  window.selectNode(500);
  add("move one", [&] {
    explorer.topology().setFocus();
    QTest::keyClick(&explorer.topology(), Qt::Key_Up, Qt::AltModifier);
    QApplication::processEvents();
  });
  workspace.document().undoStack().setClean();
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  syncline::bench::RatioReport report;
  syncline::bench::bench_preview(report);
  syncline::bench::bench_lines(report);
  syncline::bench::bench_thousand(report);
  return report.finish("Large projects in the window");
}
