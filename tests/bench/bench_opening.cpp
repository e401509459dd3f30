// SPDX-License-Identifier: Apache-2.0
// A recording of ten million cycles, opened in the window: how soon it is seen, and how long the window stands still.
#include <fmt/format.h>

#include <QApplication>
#include <QPointer>
#include <algorithm>
#include <chrono>
#include <filesystem>

#include "bench/long_recording.h"
#include "bench/ratio_report.h"
#include "findings/error_text.h"
#include "record/import_run.h"
#include "tests/support/temporary_folder.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/opening_picture.h"
#include "ui/main_window.h"
#include "ui/plots/trace_plot.h"
#include "ui/session/workspace.h"
#include "ui/support/ui_test_support.h"

namespace syncline::bench {
namespace {

constexpr double kTenth = 100e6;  // ns
constexpr int kTurnsBehind = 60;

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// All curves of the dialog are of the whole recording.
bool is_seen(const ui::MainWindow& window, QPointer<ui::OpeningPicture>& picture) {
  // Looked for once: among all that a window has it costs more than to ask it.
  if (picture == nullptr) picture = window.findChild<ui::OpeningPicture*>();
  if (picture == nullptr) return false;
  return std::ranges::all_of(picture->findChildren<ui::TracePlot*>(), [](const ui::TracePlot* plot) {
    return plot->paintCount() > 0 &&
           std::ranges::all_of(plot->items(), [](const auto* item) { return !item->columns().empty(); });
  });
}

void bench_opening(RatioReport& report) {
  const test::TemporaryFolder folder;
  const auto path = folder.file("run.slrec");
  if (const auto status = write_recording(path); !status) return report.add_failure("write", describe(status.error()));
  const auto reading_clock = clock_seconds();
  const auto reading = all_processor_seconds();
  read_bytes(path);
  const auto bytes_ns = (all_processor_seconds() - reading) * 1e9;
  const auto bytes_clock_ns = (clock_seconds() - reading_clock) * 1e9;

  ui::Workspace workspace(test::virtualEnvironment());
  ui::MainWindow window(workspace);
  window.resize(1600, 900);
  window.show();
  QApplication::processEvents();
  QPointer<ui::OpeningPicture> picture;
  double longest = 0, seen = 0, seen_clock = 0;
  const auto begin_clock = clock_seconds();
  const auto begin = all_processor_seconds();
  window.files().openAny(QString::fromStdString(path));
  const auto turn = [&longest] {
    const auto from = processor_seconds();
    ui::waitForEvents();
    longest = std::max(longest, (processor_seconds() - from) * 1e9);
  };
  while (!workspace.recording().isOpen()) {
    turn();
    if (seen == 0 && is_seen(window, picture)) {
      seen = (all_processor_seconds() - begin) * 1e9;
      seen_clock = (clock_seconds() - begin_clock) * 1e9;
    }
    if (!workspace.recording().isReading() && !workspace.recording().isOpen())
      return report.add_failure("open", "it could not be read");
  }
  const auto opened_clock = (clock_seconds() - begin_clock) * 1e9;
  // The plots of the window are drawn by their tick.
  for (int i = 0; i < kTurnsBehind; ++i) turn();
  if (seen == 0) return report.add_failure("first picture", "it was not seen");
  const auto baseline =
      fmt::format("reading its {:.0f} MiB", static_cast<double>(std::filesystem::file_size(path)) / kMiB);
  report.add("G20 first picture in the window, all threads", seen, baseline, bytes_ns, 3);
  report.add("the same by the clock", seen_clock, baseline, bytes_clock_ns, 0);
  report.add("all of it by the clock", opened_clock, baseline, bytes_clock_ns, 0);
  report.add("G20 longest hold of the window", longest, "a tenth of a second", kTenth, 1);
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  syncline::bench::RatioReport report;
  syncline::bench::bench_opening(report);
  return report.finish("A long recording in the window");
}
