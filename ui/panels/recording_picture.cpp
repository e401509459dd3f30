// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/recording_picture.h"
#include "support/whole_file.h"

#include <QCoreApplication>
#include <QLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "reasons/because.h"
#include "record/replay_run.h"
#include "trace/named_signal.h"
#include "ui/panels/cycle_view.h"
#include "ui/panels/distribution_view.h"
#include "ui/panels/free_plot.h"
#include "ui/panels/free_view.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/live_strip_toolbar.h"
#include "ui/panels/overlay_figures.h"
#include "ui/panels/overview_panel.h"
#include "ui/panels/picture_file.h"
#include "ui/panels/slaves_view.h"
#include "ui/panels/usual_views.h"
#include "ui/plots/cycle_plot.h"
#include "ui/plots/histogram_plot.h"
#include "ui/session/recorded_views.h"
#include "ui/text/signal_text.h"
#include "ui/widgets/wait_until.h"

namespace syncline::ui {
namespace {

constexpr qint64 kTimeoutMs = 60'000;
constexpr QSize kUsual(1280, 460), kUsualOfSlaves(1760, 460);  // all columns of the table
constexpr int kCaptionRoom = 60;                               // with some more for the plots
constexpr QSize kLeastRoom(600, 160);                          // the window lets no view have less

struct ViewName {
  PictureView view;
  const char* name;
};
constexpr std::array kPictureViews{ViewName{PictureView::kOverview, "overview"},
                                   ViewName{PictureView::kPlots, "plots"},
                                   ViewName{PictureView::kDistribution, "distribution"},
                                   ViewName{PictureView::kStability, "stability"},
                                   ViewName{PictureView::kCycle, "cycle"},
                                   ViewName{PictureView::kSlaves, "slaves"},
                                   ViewName{PictureView::kFree, "free"}};

LiveStrip::Body bodyOf(PictureView view) {
  switch (view) {
    case PictureView::kDistribution:
      return LiveStrip::Body::kDistribution;
    case PictureView::kStability:
      return LiveStrip::Body::kStability;
    case PictureView::kCycle:
      return LiveStrip::Body::kCycle;
    case PictureView::kSlaves:
      return LiveStrip::Body::kSlaves;
    case PictureView::kFree:
      return LiveStrip::Body::kFree;
    default:
      return LiveStrip::Body::kPlots;
  }
}

/// As if it were seen, on no screen.
void showUnseen(QWidget& widget) {
  widget.setAttribute(Qt::WA_DontShowOnScreen);
  widget.show();
  for (int round = 0; round < 3; ++round) QCoreApplication::processEvents();  // layouts ask for another one
}

/// Gives the widget the size with which its picture has the wanted one.
template <class Widget>
void fit(Widget& widget, const QSize& wanted) {
  for (int round = 0; round < 3 && widget.picture().size != wanted; ++round) {
    widget.resize(widget.size() + wanted - widget.picture().size);
    QCoreApplication::processEvents();
  }
}

/// What the picture is of.
const QWidget& bodyOf(const LiveStrip& strip, PictureView view) {
  switch (view) {
    case PictureView::kDistribution:
      return *strip.distribution();
    case PictureView::kStability:
      return *strip.stability();
    case PictureView::kCycle:
      return *strip.cycle();
    case PictureView::kSlaves:
      return *strip.slaves();
    case PictureView::kFree:
      return *strip.free()->canvas();
    default:
      return *strip.panels().front()->parentWidget();
  }
}

bool isComplete(const LiveStrip& strip, PictureView view) {
  switch (view) {
    case PictureView::kDistribution:
      return strip.distribution()->complete();
    case PictureView::kStability:
      return strip.stability()->complete();
    case PictureView::kSlaves:
      return strip.slaves()->complete();
    case PictureView::kPlots:
      return strip.overlayFigures()->complete();
    default:
      return true;
  }
}

Status writeOverview(const ReplayedRun& run, const RecordingPicture& wanted, const QString& path) {
  OverviewPanel panel;
  panel.setRecord(run.record.get(), true);
  panel.setFindings(run.record->findings());
  showUnseen(panel);
  const int width = wanted.size.isEmpty() ? kUsual.width() : wanted.size.width();
  panel.resize(width, panel.layout()->totalHeightForWidth(width));
  fit(panel, wanted.size.isEmpty() ? QSize(width, panel.picture().size.height()) : wanted.size);
  if (!wanted.size.isEmpty() && panel.picture().size != wanted.size) {
    return fail(ErrorCode::kBadValue, "--size",
                because("the view needs more room; leave the size out to have what suits it"));
  }
  return writePicture(panel.picture(), path);
}

/// Signals that were named, a view of the project in the recording, or what is proposed first.
Status chooseView(FreeView& free, const ReplayedRun& run, const RecordingPicture& wanted) {
  if (!wanted.sources.empty()) {
    free.setViews({viewOf(*run.record, wanted.sources)});
    free.choose(0);
    return {};
  }
  const auto views = recordedViews(run.info.about);
  free.setViews(views);
  if (wanted.own_view.isEmpty()) {
    free.choose(0);
    return {};
  }
  const auto named = std::ranges::find(views, wanted.own_view.toStdString(), &MonitorView::name);
  if (named == views.end()) {
    return fail(ErrorCode::kBadValue, wanted.own_view.toStdString(),
                because("the project in the recording has no view of that name"));
  }
  free.choose(static_cast<int>(named - views.begin()));
  return {};
}

Status prepare(LiveStrip& strip, const ReplayedRun& run, const RecordingPicture& wanted) {
  const auto& record = *run.record;
  strip.setRecord(&record, true);
  if (wanted.view == PictureView::kFree) {
    if (auto status = chooseView(*strip.free(), run, wanted); !status) return status;
  }
  if (wanted.slave >= 0) strip.setPickedSlave(wanted.slave);
  strip.setOverlay(wanted.overlay);
  if (!wanted.sources.empty()) {
    strip.distribution()->setSources(wanted.sources);
    strip.stability()->setSources(wanted.sources);
  }
  if (wanted.figure) strip.stability()->setFigure(*wanted.figure);
  if (wanted.cycle_figure) strip.cycle()->setFigure(*wanted.cycle_figure);
  if (wanted.view == PictureView::kCycle &&
      (strip.cycle()->slave() < 0 || (wanted.slave >= 0 && strip.cycle()->slave() != wanted.slave)))
    return fail(ErrorCode::kBadValue, "cycle", because("no slave with SYNC0 whose arrivals are known"));
  strip.showBody(bodyOf(wanted.view));
  if (!wanted.range) return {};
  strip.refresh();  // knows its bounds then
  strip.timeView()->setSpan(std::max(wanted.range->end - wanted.range->begin, TimeView::kMinSpan));
  strip.timeView()->goTo(wanted.range->begin + strip.timeView()->span() / 2);
  return {};
}

}  // namespace

std::optional<PictureView> pictureViewOf(const QString& name) {
  const auto* found =
      std::ranges::find_if(kPictureViews, [&name](const ViewName& of) { return name == QLatin1String(of.name); });
  return found == kPictureViews.end() ? std::nullopt : std::optional(found->view);
}

QStringList pictureViewNames() {
  QStringList names;
  for (const auto& of : kPictureViews) names << QLatin1String(of.name);
  return names;
}

std::optional<StabilityView::Figure> stabilityFigureOf(const QString& name) {
  using Figure = StabilityView::Figure;
  constexpr std::array kFigures{std::pair{"adev", Figure::kAdev}, std::pair{"tdev", Figure::kTdev},
                                std::pair{"mtie", Figure::kMtie}, std::pair{"spectrum", Figure::kSpectrum}};
  for (const auto& [key, figure] : kFigures) {
    if (name == QLatin1String(key)) return figure;
  }
  return std::nullopt;
}

std::optional<CycleView::Figure> cycleFigureOf(const QString& name) {
  if (name == QLatin1String("arrivals")) return CycleView::Figure::kArrivals;
  if (name == QLatin1String("bathtub")) return CycleView::Figure::kBathtub;
  return std::nullopt;
}

Result<SignalSource> signalSourceOf(const QString& text, const RunRecord& record) {
  const auto named = named_signal(text.toStdString(), record.samples());
  const auto there = [&record](const NamedSignal& of) {
    const auto& row = info(of.signal);
    if (row.scope == SignalInfo::Scope::kBus) return !signalText(row.id).isEmpty();
    if (row.id == Signal::kArrivalPhase) return record.samples().sync0(of.slave).period > 0;
    return row.id == Signal::kSlaveDeviation && !seriesOf(record, {row.id, of.slave}).empty();
  };
  if (named && there(*named)) return SignalSource{named->signal, named->slave};
  return fail(ErrorCode::kBadValue, text.toStdString(),
              because("it is no signal that can be shown here, such as dcm_error_ns or deviation_ns@1"));
}

Result<SignalSource> drawnSignalOf(const QString& text, const RunRecord& record) {
  const auto named = named_signal(text.toStdString(), record.samples());
  if (named) return SignalSource{named->signal, named->slave};
  return fail(
      ErrorCode::kBadValue, text.toStdString(),
      because("it is no signal that can be drawn, such as lost_frames_total, al_status@1 or a variable's name"));
}

Status writeRecordingPicture(const ReplayedRun& run, const RecordingPicture& wanted, const QString& path) {
  const bool table = path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive);
  const bool possible = table ? wanted.view != PictureView::kOverview : pictureFormOf(path).has_value();
  if (!possible) return writePicture({}, path);
  if (wanted.view == PictureView::kOverview) return writeOverview(run, wanted, path);
  LiveStrip strip;
  strip.findChild<LiveStripToolbar*>()->hide();  // no part of the picture, and wider than many are to be
  if (auto status = prepare(strip, run, wanted); !status) return status;
  auto usual = wanted.view == PictureView::kSlaves ? kUsualOfSlaves : kUsual;
  // As many plots as there are have room.
  if (wanted.view == PictureView::kFree)
    usual.setHeight(std::max(usual.height(), strip.free()->canvas()->minimumHeight() + kCaptionRoom));
  const auto size = wanted.size.isEmpty() ? usual : wanted.size;
  strip.setMinimumSize(1, 1);  // that of the view alone counts
  strip.resize(size);
  showUnseen(strip);
  fit(strip, size);
  const auto& body = bodyOf(strip, wanted.view);
  const auto least = body.minimumSizeHint().boundedTo(kLeastRoom);
  if (strip.picture().size != size || body.size() != body.size().expandedTo(least)) {
    return fail(ErrorCode::kBadValue, "--size",
                because("the view needs more room; leave the size out to have what suits it"));
  }
  const bool complete = waitUntil(
      [&] {
        strip.refresh();
        return isComplete(strip, wanted.view);
      },
      kTimeoutMs);
  if (!complete) return fail(ErrorCode::kTimeout, "picture");
  if (table) return write_whole_file(path.toStdString(), strip.csv());
  for (auto* panel : strip.panels()) panel->refreshText(true);
  for (auto* plot : strip.free()->plots()) plot->refreshText(true);
  QCoreApplication::processEvents();  // what a legend says by now may need more room
  strip.refresh();
  return writePicture(strip.picture(), path);
}

}  // namespace syncline::ui
