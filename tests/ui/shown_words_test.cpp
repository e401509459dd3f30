// SPDX-License-Identifier: Apache-2.0
// Every word of the pages, plots and views of the monitor goes through a translation: shown in a language in which each
// letter has a mark, those that have none are names of the machine, units and the few words that are the same
// everywhere.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPointer>
#include <QTabWidget>
#include <set>

#include "support/artificial_language.h"
#include "support/plain_words.h"
#include "support/running_window.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/cycle_view.h"
#include "ui/panels/free_view.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overview_panel.h"
#include "ui/panels/slaves_view.h"
#include "ui/panels/stability_view.h"
#include "ui/session/eni_preview.h"

namespace syncline::ui {
namespace {

using test::ArtificialLanguage;

TEST(ArtificialLanguage, MarksWordsAndKeepsPlaces) {
  EXPECT_EQ(
      ArtificialLanguage::marked(QStringLiteral("Deviation of <b>%1</b> &amp; {count:# frame|# frames} of {slave}")),
      QStringLiteral("Đéṽîåţîöñ öƒ <b>%1</b> &amp; {count:# ƒŕåḿé|# ƒŕåḿéš} öƒ {slave}"));
  EXPECT_EQ(ArtificialLanguage::marked(QStringLiteral("%n of &Open"), ArtificialLanguage::Length::kLonger),
            QStringLiteral("%n ööƒ &Ööþééñ"));
  EXPECT_EQ(ArtificialLanguage::marked(QStringLiteral("SYNC0 in OP: master.cycle_time_us, a (*.xml)")),
            QStringLiteral("SYNC0 îñ OP: master.cycle_time_us, å (*.xml)"));
  const ArtificialLanguage language;
  EXPECT_EQ(QCoreApplication::translate("Any", "Open"), QStringLiteral("Öþéñ"));
}

TEST(PlainWords, AreThoseThatNoTranslationMade) {
  test::PlainWords words;
  const auto project = test::smallProject();
  EXPECT_EQ(words.in(QStringLiteral("Ţĥé &Open <b>Servo</b> drive, 0xABCD after 2 ms in a.xml of SYNC0")),
            (QStringList{QStringLiteral("Open"), QStringLiteral("Servo"), QStringLiteral("drive"),
                         QStringLiteral("after"), QStringLiteral("in"), QStringLiteral("of")}));
  words.addNames(project);
  EXPECT_EQ(words.in(QStringLiteral("Servo drive ƒöûñđ, Controlword lost")), QStringList{QStringLiteral("lost")});
  QLabel label(QStringLiteral("Öþéñ file"));
  label.show();
  words.look(label);
  EXPECT_EQ(words.marked(), 1);
  EXPECT_EQ(words.takeFound().size(), 1) << "painted and spoken by one widget";
  EXPECT_TRUE(words.takeFound().isEmpty());
}

/// Before the window is made.
class Spoken {
  ArtificialLanguage language_;
};

class ShownWords : private Spoken, public test::RunningWindow {
 protected:
  void look(QWidget& view) {
    for (int round = 0; round < 3; ++round) QApplication::processEvents();
    words_.look(view);
    const auto parts = view.findChildren<QWidget*>();
    for (const auto& part : QList<QPointer<QWidget>>(parts.begin(), parts.end())) {
      if (part && part->isVisible()) words_.lookAtTips(*part);
    }
    tell();
  }
  void look(const QString& text, const char* where) {
    words_.look(text, QLatin1String(where));
    tell();
  }
  void tell() {
    for (const auto& text : words_.takeFound()) ADD_FAILURE() << qPrintable(text);
  }
  LiveStrip& strip() { return window_.liveStrip(); }
  /// Until a view has all of its figures, which a thread makes.
  template <class View>
  void complete(View& view) {
    EXPECT_TRUE(test::waitFor([&] {
      strip().refresh();
      return view.complete();
    }));
  }

  test::PlainWords words_;
};

TEST_F(ShownWords, OfTheMonitorAreTranslated) {
  goOnline();
  run(3 * kSecond);
  words_.addNames(project());
  window_.resize(1600, 1000);
  strip().timeView()->setSpan(2 * kSecond);
  const auto now = workspace_.live().snapshot().time;
  strip().cursors()->set(CursorSet::kA, now - kSecond);
  strip().cursors()->set(CursorSet::kB, now - kSecond / 2);
  strip().cursors()->setPointer(now - kSecond / 3);
  strip().refresh();
  auto& overview = *window_.findChild<OverviewPanel*>();
  look(overview);
  look(overview.text(), "figures of the overview");
  look(overview.picture().title, "picture of the overview");
  look(strip());
  look(strip().figures(), "figures of the plots");
  look(strip().picture().title, "picture of the plots");
  using Body = LiveStrip::Body;
  strip().showBody(Body::kDistribution);
  run(kSecond);
  look(strip());
  strip().showBody(Body::kStability);
  using Figure = StabilityView::Figure;
  for (const auto figure : {Figure::kAdev, Figure::kTdev, Figure::kMtie, Figure::kSpectrum}) {
    strip().stability()->setFigure(figure);
    complete(*strip().stability());
    look(strip());
  }
  strip().showBody(Body::kSlaves);
  complete(*strip().slaves());
  look(strip());
  strip().showBody(Body::kCycle);
  for (const auto figure : {CycleView::Figure::kArrivals, CycleView::Figure::kBathtub}) {
    strip().cycle()->setFigure(figure);
    run(kSecond);
    look(strip());
  }
  strip().showBody(Body::kFree);
  for (int view = 0; view < 4; ++view) {
    strip().free()->chooseUsual(view);
    run(200 * kMillisecond);
    look(strip());
  }
  EXPECT_GT(words_.seen(), 1'000);
  EXPECT_GT(words_.marked(), 200);
}

/// All pages, one slave of each device, while the machine runs.
TEST_F(ShownWords, OfThePagesAreTranslated) {
  goOnline();
  run(kSecond);
  words_.addNames(project());
  workspace_.setExpert(true);
  window_.resize(1600, 1000);
  strip().hide();  // it has its own test
  std::set<std::uint32_t> seen;
  for (int node = -1; node < static_cast<int>(project().slaves.size()); ++node) {
    if (node >= 0 && !seen.insert(project().slaves[static_cast<std::size_t>(node)].device.identity.product_code).second)
      continue;
    window_.selectNode(node);
    auto* tabs = window_.editor().tabs();
    for (int i = 0; i < tabs->count(); ++i) {
      tabs->setCurrentIndex(i);
      EXPECT_TRUE(test::waitFor([this] { return !workspace_.eni().isComputing(); }));
      SCOPED_TRACE(qPrintable(QStringLiteral("node %1 %2").arg(node).arg(tabs->currentWidget()->objectName())));
      look(*tabs->currentWidget());
    }
  }
  EXPECT_GT(words_.seen(), 1'000);
  EXPECT_GT(words_.marked(), 500);
}

TEST_F(ShownWords, OfTheTimingOfACycleAreTranslated) {
  goOnline();
  words_.addNames(project());
  show(kServo, "slaveDcPage");
  look(field("slaveTiming"));
  EXPECT_GT(words_.seen(), 5);
  EXPECT_GE(words_.marked(), 2);
}

}  // namespace
}  // namespace syncline::ui
