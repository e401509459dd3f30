// SPDX-License-Identifier: Apache-2.0
// Whoever does not see the window hears what its painted widgets show: each has a name, and says its value.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAccessible>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QSet>
#include <memory>

#include "support/running_window.h"
#include "tests/support/source_dir.h"
#include "ui/editors/page.h"
#include "ui/panels/figure_card.h"
#include "ui/panels/live_strip.h"
#include "ui/plots/heat_map_plot.h"
#include "ui/plots/trace_plot.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/spoken_value.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;

QString spoken(QWidget& widget, QAccessible::Text kind) {
  auto* interface = QAccessible::queryAccessibleInterface(&widget);
  return interface == nullptr ? QString() : interface->text(kind);
}
QString valueOf(QWidget& widget) { return spoken(widget, QAccessible::Value); }

/// The classes of ui/ that paint themselves: whoever adds one is found by its header.
QSet<QString> paintedClasses() {
  QSet<QString> names;
  static const QRegularExpression kClass(QStringLiteral("\\nclass (\\w+)[^;{]*\\{"));
  QDirIterator headers(QString::fromStdString(test::source_dir()) + QStringLiteral("/ui"), {QStringLiteral("*.h")},
                       QDir::Files, QDirIterator::Subdirectories);
  while (headers.hasNext()) {
    QFile file(headers.next());
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const auto text = QString::fromUtf8(file.readAll());
    const auto paints = text.indexOf(QStringLiteral("void paintEvent("));
    if (paints < 0) continue;
    QString last;
    for (auto found = kClass.globalMatch(text); found.hasNext();) {
      const auto one = found.next();
      if (one.capturedStart() < paints) last = one.captured(1);
    }
    names.insert(QStringLiteral("syncline::ui::") + last);
  }
  // They paint a background, and their parts stand on it; or Qt knows how to say what they hold.
  for (const char* name : {"Card", "NoticeBar", "OverlayBar", "TopologyView", "ReplaySlider"}) {
    EXPECT_TRUE(names.remove(QStringLiteral("syncline::ui::") + QLatin1String(name))) << name;
  }
  return names;
}

/// As where a screen reader runs before the window is there: what it asks for is known from then on.
class ScreenReader {
 public:
  ScreenReader() : before_(QAccessible::isActive()) { QAccessible::setActive(true); }
  ~ScreenReader() { QAccessible::setActive(before_); }

 private:
  bool before_;
};

class SpokenValues : private ScreenReader, public test::RunningWindow {
 protected:
  /// All of the window that is painted and all labels that have a name: what lacks something, by its path.
  QStringList silent(bool shown_alone) {
    QStringList lacking;
    for (auto* widget : window_.findChildren<QWidget*>()) {
      if (shown_alone && !widget->isVisible()) continue;
      const auto kind = QString::fromLatin1(widget->metaObject()->className());
      const auto* label = qobject_cast<QLabel*>(widget);
      const bool painted = painted_.contains(kind) || widget->inherits("QwtPlot");
      const bool named_label = label != nullptr && label->buddy() == nullptr && !label->accessibleName().isEmpty();
      if (label != nullptr ? !named_label || label->text().isEmpty() : !painted) continue;
      seen_.insert(kind);
      QString lack;
      if (spoken(*widget, QAccessible::Name).isEmpty()) lack = QStringLiteral("no name");
      if (valueOf(*widget).isEmpty()) lack = QStringLiteral("no value");
      if (shown_alone && valueOf(*widget) == QStringLiteral("Nothing is shown")) lack = QStringLiteral("says nothing");
      if (lack.isEmpty()) continue;
      QString path = kind;
      for (auto* above = widget; above != nullptr; above = above->parentWidget())
        if (!above->objectName().isEmpty()) path += QStringLiteral(" < ") + above->objectName();
      lacking << path + QStringLiteral(": ") + lack;
    }
    lacking.removeDuplicates();
    return lacking;
  }

  const QSet<QString> painted_ = paintedClasses();
  QSet<QString> seen_;
};

TEST_F(SpokenValues, AreThereOnEveryPageAndViewOfTheWindow) {
  EXPECT_GE(painted_.size(), 10);
  EXPECT_EQ(silent(false).join(u'\n').toStdString(), "") << "before anything is loaded";
  goOnline();
  run(2 * kSecond);
  for (const int node : {-1, kCoupler, kServo}) {
    window_.selectNode(node);
    for (auto* page : window_.editor().pages()) {
      if (!page->appliesTo(node)) continue;
      auto* tabs = window_.editor().tabs();
      if (const int tab = tabs->indexOf(page); tab >= 0) tabs->setCurrentIndex(tab);
      run(100 * kMillisecond);
      EXPECT_EQ(silent(true).join(u'\n').toStdString(), "") << page->objectName().toStdString() << " of " << node;
    }
  }
  auto& strip = *window_.findChild<LiveStrip*>();
  using Body = LiveStrip::Body;
  for (const auto body : {Body::kPlots, Body::kDistribution, Body::kStability, Body::kSlaves, Body::kCycle}) {
    strip.showBody(body);
    run(2 * kSecond);
    EXPECT_TRUE(test::waitFor([&] {
      run(20 * kMillisecond);
      return silent(true).isEmpty();
    })) << static_cast<int>(body)
        << ": " << silent(true).join(u'\n').toStdString();
  }
  EXPECT_EQ(silent(false).join(u'\n').toStdString(), "");
  for (const auto& kind : painted_) EXPECT_TRUE(seen_.contains(kind)) << qPrintable(kind) << " is on no page";
}

TEST_F(SpokenValues, SayWhatIsDrawnAndWhetherTheLimitIsKept) {
  goOnline();
  run(2 * kSecond);
  auto& strip = *window_.findChild<LiveStrip*>();
  strip.showBody(LiveStrip::Body::kPlots);
  auto& plot = field<TracePlot>("deviationPlot");
  EXPECT_TRUE(test::waitFor([&] {
    run(20 * kMillisecond);
    return valueOf(plot).contains(QStringLiteral("largest")) && valueOf(plot).contains(QStringLiteral("limit of"));
  })) << qPrintable(valueOf(plot));
  strip.showBody(LiveStrip::Body::kSlaves);
  auto& map = field<HeatMapPlot>("slavesHeatMap");
  EXPECT_TRUE(test::waitFor([&] {
    run(20 * kMillisecond);
    return valueOf(map).contains(QStringLiteral("Farthest off is"));
  })) << qPrintable(valueOf(map));
  auto& card = field<FigureCard>("overviewDeviation");
  EXPECT_THAT(valueOf(card).toStdString(), HasSubstr(card.mainText().toStdString()));
}

TEST(SpokenValue, OfAPillAndOfALabelIsWhatStandsInIt) {
  installSpokenValues();
  const ScreenReader reader;
  Pill pill;
  pill.setAccessibleName(QStringLiteral("State"));
  EXPECT_EQ(valueOf(pill).toStdString(), "Nothing is shown");
  pill.setState(theme::Tone::kGood, QStringLiteral("OP"));
  EXPECT_EQ(valueOf(pill).toStdString(), "OP");
  EXPECT_EQ(spoken(pill, QAccessible::Name).toStdString(), "State");
  ValueLabel label;
  label.setAccessibleName(QStringLiteral("Lines"));
  label.setText(QStringLiteral("<b>3</b> added"));
  EXPECT_EQ(valueOf(label).toStdString(), "3 added");
  EXPECT_EQ(spoken(label, QAccessible::Name).toStdString(), "Lines");
  QLabel plain(QStringLiteral("&Cycle"));
  EXPECT_EQ(spoken(plain, QAccessible::Name).toStdString(), "&Cycle");
  plain.setBuddy(&label);
  EXPECT_EQ(spoken(plain, QAccessible::Name).toStdString(), "Cycle");
  EXPECT_EQ(valueOf(plain).toStdString(), "");
  const auto fields = QAccessible::queryAccessibleInterface(&plain)->relations(QAccessible::Labelled);
  ASSERT_EQ(fields.size(), 1);
  EXPECT_EQ(fields.front().first->object(), &label) << "as Qt ties a label to its field";
}

}  // namespace
}  // namespace syncline::ui
