// SPDX-License-Identifier: Apache-2.0
// No text of the window is cut, in any of its languages, on the smallest screen and the usual one; with
// SYNCLINE_WINDOW_SIZE=3840x2160 on a screen of so many dots instead, which the scale makes fewer points of. With
// SYNCLINE_PICTURES=FOLDER each page is also painted there.
#include <gtest/gtest.h>

#include <QAction>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "support/artificial_language.h"
#include "support/cut_texts.h"
#include "support/speak.h"
#include "support/ui_test_support.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/cycle_dialog.h"
#include "ui/dialogs/file_commands.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/free_view.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/slaves_view.h"
#include "ui/panels/stability_view.h"
#include "ui/session/workspace.h"
#include "ui/window_overlay.h"

namespace syncline::ui {
namespace {

std::vector<QSize> windowSizes() {
  const auto wish = qEnvironmentVariable("SYNCLINE_WINDOW_SIZE").split(u'x');
  if (wish.size() == 2) return {QSize(wish[0].toInt(), wish[1].toInt()) / qApp->devicePixelRatio()};
  return {{1024, 640}, {1280, 800}};
}

/// An artificial language whose texts are a third longer: the next one that somebody translates.
constexpr std::string_view kNextLanguage = "next";

/// Before the window is made.
class ShownLanguage {
 public:
  explicit ShownLanguage(std::string_view language) {
    if (language == kNextLanguage)
      next_.emplace(test::ArtificialLanguage::Length::kLonger);
    else
      known_.emplace(QString::fromUtf8(language.data(), static_cast<qsizetype>(language.size())));
  }

 private:
  std::optional<test::Speak> known_;
  std::optional<test::ArtificialLanguage> next_;
};

class Clipping : public ::testing::TestWithParam<const char*> {
 protected:
  Clipping() : language_(GetParam()), workspace_(test::virtualEnvironment()), window_(workspace_) {
    workspace_.live().setAutoAdvance(false);
    window_.show();
  }
  ~Clipping() override {
    workspace_.live().shutDown();
    workspace_.document().undoStack().setClean();
  }
  void startDemo() {
    window_.bus().startDemo();
    ASSERT_TRUE(test::waitFor([this] { return workspace_.live().phase() != LiveSession::Phase::kOffline; }));
    for (int i = 0; i < 40; ++i) workspace_.live().advance(100 * kMillisecond);
  }
  void settle() {
    window_.liveStrip().refresh();
    static_cast<void>(test::waitFor([this] { return !workspace_.eni().isComputing(); }));
    for (int round = 0; round < 3; ++round) QApplication::processEvents();
  }
  void look(const QString& page) {
    settle();
    const auto where = QStringLiteral("%1-%2-%3").arg(QLatin1String(GetParam())).arg(window_.width()).arg(page);
    const auto pictures = qEnvironmentVariable("SYNCLINE_PICTURES");
    if (!pictures.isEmpty()) window_.grab().save(QDir(pictures).filePath(where + QStringLiteral(".png")));
    const test::CutTexts cut(window_);
    for (const auto& text : cut.found()) {
      // What stands outside of the pages is told once.
      if (told_.contains(text)) continue;
      told_.insert(text);
      ADD_FAILURE() << qPrintable(where) << ": " << qPrintable(text);
    }
  }
  void lookAtStability() {
    auto& strip = window_.liveStrip();
    strip.showBody(LiveStrip::Body::kStability);
    for (const auto figure : {StabilityView::Figure::kMtie, StabilityView::Figure::kSpectrum}) {
      strip.stability()->setFigure(figure);
      static_cast<void>(test::waitFor([&strip] {
        strip.refresh();
        return strip.stability()->complete();
      }));
      look(figure == StabilityView::Figure::kMtie ? QStringLiteral("mtie") : QStringLiteral("spectrum"));
    }
    strip.showBody(LiveStrip::Body::kPlots);
  }
  void lookAtSlaves() {
    auto& strip = window_.liveStrip();
    strip.showBody(LiveStrip::Body::kSlaves);
    static_cast<void>(test::waitFor([&strip] {
      strip.refresh();
      return strip.slaves()->complete();
    }));
    look(QStringLiteral("slaves"));
    strip.showBody(LiveStrip::Body::kPlots);
  }
  void lookAtOwnPlots() {
    auto& strip = window_.liveStrip();
    strip.showBody(LiveStrip::Body::kFree);
    for (int view = 0; view < 4; ++view) {
      strip.free()->chooseUsual(view);
      look(QStringLiteral("own-%1").arg(view));
    }
    strip.showBody(LiveStrip::Body::kPlots);
  }
  static void lookAtCells(const QTableWidget& table) {
    for (int row = 0; row < table.rowCount(); ++row) {
      for (int column = 0; column < table.columnCount(); ++column) {
        const auto* item = table.item(row, column);
        const int wide = QFontMetrics(item->font()).horizontalAdvance(item->text());
        EXPECT_LE(wide, table.columnWidth(column)) << GetParam() << ": " << qPrintable(item->text());
      }
    }
  }
  void lookAtDialog(const QDialog& dialog, const char* name) {
    QApplication::processEvents();
    const test::CutTexts cut(dialog);
    for (const auto& text : cut.found()) ADD_FAILURE() << GetParam() << ' ' << name << ": " << qPrintable(text);
  }
  void lookAtDialogOf(const char* name) {
    auto* action = window_.findChild<QAction*>(QLatin1String(name));
    ASSERT_NE(action, nullptr) << name;
    ASSERT_TRUE(action->isEnabled()) << name;
    int seen = 0;
    QTimer::singleShot(0, &window_, [&] {
      for (auto* dialog : window_.findChildren<QDialog*>()) {
        if (!dialog->isVisible()) continue;
        ++seen;
        lookAtDialog(*dialog, name);
        for (const auto* table : dialog->findChildren<QTableWidget*>()) lookAtCells(*table);
        dialog->reject();
      }
    });
    action->trigger();
    settle();
    EXPECT_EQ(seen, 1) << name;
  }
  void lookAtPages(int node) {
    window_.selectNode(node);
    auto* tabs = window_.editor().tabs();
    for (int i = 0; i < tabs->count(); ++i) {
      tabs->setCurrentIndex(i);
      look(QStringLiteral("%1-%2").arg(node).arg(tabs->widget(i)->objectName()));
    }
  }

  ShownLanguage language_;
  Workspace workspace_;
  MainWindow window_;
  QSet<QString> told_;
};

TEST_P(Clipping, NoTextIsCut) {
  for (const auto size : windowSizes()) {
    window_.resize(size);
    look(QStringLiteral("welcome"));
  }
  startDemo();
  ASSERT_FALSE(HasFatalFailure());
  workspace_.setExpert(true);
  const auto& slaves = workspace_.document().project().slaves;
  for (const auto size : windowSizes()) {
    told_.clear();
    window_.resize(size);
    settle();
    EXPECT_EQ(window_.size(), size) << "it does not become so small";
    std::set<std::uint32_t> seen;  // one of each device
    lookAtPages(-1);
    lookAtStability();
    lookAtSlaves();
    lookAtOwnPlots();
    for (std::size_t i = 0; i < slaves.size(); ++i) {
      if (seen.insert(slaves[i].device.identity.product_code).second) lookAtPages(static_cast<int>(i));
    }
  }
}

/// A recording that is played, with another one over it.
TEST_P(Clipping, NoTextOfARecordingIsCut) {
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("run.slrec")),
             other = folder.filePath(QStringLiteral("other.slrec"));
  startDemo();
  ASSERT_FALSE(HasFatalFailure());
  bool ended = false;
  const auto told = QObject::connect(&workspace_.disk(), &DiskRecording::ended, &window_, [&ended] { ended = true; });
  ASSERT_TRUE(workspace_.disk().start(path));
  for (int i = 0; i < 40; ++i) workspace_.live().advance(100 * kMillisecond);
  workspace_.document().undoStack().setClean();
  workspace_.runs().shutDown();
  ASSERT_TRUE(test::waitFor([&ended] { return ended; }));
  QObject::disconnect(told);
  ASSERT_TRUE(QFile::copy(path, other));
  window_.files().openAny(path);
  ASSERT_TRUE(test::waitFor([this] { return workspace_.recording().isOpen(); }));
  for (const auto size : windowSizes()) {
    told_.clear();
    window_.resize(size);
    settle();
    settle();
    look(QStringLiteral("recording"));
    workspace_.replay().seek(workspace_.replay().begin() + 3 * kSecond);
    look(QStringLiteral("replay"));
    EXPECT_EQ(window_.size(), size) << "it does not become so small";
    window_.overlay().open(other);
    ASSERT_TRUE(test::waitFor([this] { return workspace_.overlay().isOpen(); }));
    for (int round = 0; round < 3; ++round) window_.liveStrip().refresh();
    settle();
    window_.resize(size);
    look(QStringLiteral("overlay"));
    EXPECT_EQ(window_.size(), size) << "it does not become so small";
    workspace_.overlay().close();
    workspace_.replay().leave();
  }
}

/// What the menus open, in the size that it opens in.
TEST_P(Clipping, NoTextOfADialogIsCut) {
  startDemo();
  ASSERT_FALSE(HasFatalFailure());
  for (const char* name :
       {"actionGoTo", "actionCommissioning", "actionMemory", "actionBlackBox", "actionAbout", "actionCompare"})
    lookAtDialogOf(name);
  workspace_.runs().shutDown();
  workspace_.document().undoStack().setClean();
  window_.selectNode(3);
  settle();
  for (const char* name : {"actionScan", "actionChooseLink", "actionReplaceSlave"}) lookAtDialogOf(name);
  CycleDialog cycles(workspace_.document().project());
  ImportDialog import(
      QStringLiteral("/captures/a_capture_whose_name_is_long_and_has_no_place_for_the_end_of_a_line.pcapng"));
  for (QDialog* dialog : std::initializer_list<QDialog*>{&cycles, &import}) {
    dialog->show();
    lookAtDialog(*dialog, qPrintable(dialog->objectName()));
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, Clipping, ::testing::Values("en", "de", "zh_CN", kNextLanguage.data()),
                         [](const auto& language) { return std::string(language.param); });

}  // namespace
}  // namespace syncline::ui
