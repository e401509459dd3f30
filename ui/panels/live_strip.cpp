// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/live_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QStackedLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "record/run_record.h"
#include "trace/fault_log.h"
#include "trace/sync_overview.h"
#include "ui/panels/csv_export.h"
#include "ui/panels/cycle_view.h"
#include "ui/panels/distribution_view.h"
#include "ui/panels/free_plot.h"
#include "ui/panels/free_view.h"
#include "ui/panels/live_strip_panels.h"
#include "ui/panels/live_strip_toolbar.h"
#include "ui/panels/overlay_figures.h"
#include "ui/panels/slaves_view.h"
#include "ui/panels/stability_view.h"
#include "ui/panels/variables_row.h"
#include "ui/plots/trigger_level_item.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kTickMs = 33;
constexpr int kLeastHeight = 160, kLeastWithVariables = 270, kLeastGiven = 30;
constexpr unsigned kTextEvery = 6;         // ticks between updates of numbers: faster cannot be read
constexpr unsigned kPointedTextEvery = 2;  // the same while a cursor moves
constexpr unsigned kChooseEvery = 30;      // ticks between choices of the worst slaves

using Body = LiveStrip::Body;
using View = LiveStripToolbar::View;
constexpr std::array kViews{std::pair{View::kNone, Body::kPlots},
                            std::pair{View::kFree, Body::kFree},
                            std::pair{View::kDistribution, Body::kDistribution},
                            std::pair{View::kStability, Body::kStability},
                            std::pair{View::kSlaves, Body::kSlaves},
                            std::pair{View::kCycle, Body::kCycle}};

Body bodyOf(View view) { return std::ranges::find(kViews, view, &std::pair<View, Body>::first)->second; }
View viewOf(Body body) { return std::ranges::find(kViews, body, &std::pair<View, Body>::second)->first; }

}  // namespace

LiveStrip::LiveStrip(QWidget* parent) : QWidget(parent), toolbar_(new LiveStripToolbar(&view_, &cursors_)) {
  setObjectName(QStringLiteral("liveStrip"));
  setAccessibleName(tr("Live plots"));
  setFocusPolicy(Qt::ClickFocus);
  plots_ = new QWidget;
  auto* rows = new QVBoxLayout(plots_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(6);
  auto* row = new QHBoxLayout;
  row->setSpacing(14);
  panels_ = {new DeviationPanel(&view_, &cursors_), new Sm2Panel(&view_, &cursors_), new DcmPanel(&view_, &cursors_)};
  for (auto* panel : panels_) row->addWidget(panel, 1);
  unfold_ = named(new QToolButton, "unfoldButton", tr("Show the plots"));
  unfold_->setToolTip(unfold_->accessibleName());
  unfold_->setArrowType(Qt::UpArrow);
  unfold_->setAutoRaise(true);
  unfold_->hide();
  panels_.back()->addToHead(unfold_);
  connect(unfold_, &QToolButton::clicked, this, [this] { Q_EMIT foldWanted(false); });
  variables_ = new VariablesRow(&view_, &cursors_);
  rows->addLayout(row, 1);
  rows->addWidget(variables_, 1);
  overlay_figures_ = new OverlayFigures(&view_);
  rows->addWidget(overlay_figures_);
  fixed_panels_.assign(panels_.begin(), panels_.end());
  fixed_panels_.insert(fixed_panels_.end(), variables_->panels().begin(), variables_->panels().end());
  for (auto* panel : fixed_panels_) {
    adopt(panel);
    connect(panel->plot(), &TracePlot::overlayDragged, this, &LiveStrip::overlayMoved);
    panel->plot()->marks().setMarks(&marks_);
  }
  free_ = new FreeView(&view_, &cursors_);
  free_->setMarks(&marks_);
  connect(free_, &FreeView::plotsChanged, this, &LiveStrip::gatherPanels);
  connect(free_, &FreeView::viewsEdited, this, &LiveStrip::viewsEdited);
  connect(free_, &FreeView::variablesWanted, this, &LiveStrip::variablesWanted);
  gatherPanels();
  empty_ = named(new QLabel(tr("No data: go online")), "liveEmptyLabel", tr("Live plots"));
  empty_->setAlignment(Qt::AlignCenter);
  auto* body = new QWidget;
  stack_ = new QStackedLayout(body);
  stack_->addWidget(empty_);
  stack_->addWidget(plots_);
  distribution_ = new DistributionView(&view_, &cursors_);
  stack_->addWidget(distribution_);
  stability_ = new StabilityView(&view_, &cursors_);
  stack_->addWidget(stability_);
  slaves_ = new SlavesView(&view_, &cursors_);
  stack_->addWidget(slaves_);
  cycle_ = new CycleView(&view_);
  stack_->addWidget(cycle_);
  stack_->addWidget(free_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(4);
  layout->addWidget(toolbar_);
  layout->addWidget(body, 1);

  connect(variables_, &VariablesRow::changed, this, [this] { setMinimumHeight(leastHeight()); });
  connect(toolbar_, &LiveStripToolbar::fitRequested, this, [this] {
    for (auto* panel : all_panels_) panel->plot()->fitValues();
  });
  connect(toolbar_, &LiveStripToolbar::cursorsToggled, this, [this](bool on) {
    if (!on) return cursors_.clear();
    cursors_.set(CursorSet::kA, view_.begin() + view_.span() / 3);
    cursors_.set(CursorSet::kB, view_.begin() + view_.span() * 2 / 3);
  });
  connect(toolbar_, &LiveStripToolbar::viewToggled, this,
          [this](LiveStripToolbar::View view, bool on) { showBody(on ? bodyOf(view) : Body::kPlots); });
  connect(toolbar_, &LiveStripToolbar::distanceWanted, this, &LiveStrip::askForDistance);
  slaves_->setMarks(&marks_);
  connect(slaves_, &SlavesView::eventClicked, this, &LiveStrip::showEventAt);
  connect(slaves_, &SlavesView::menuRequested, this,
          [this](const QPoint& global, Nanoseconds time) { openMenu(global, time); });
  connect(slaves_, &SlavesView::momentChosen, this, [this](int slave, Nanoseconds time) {
    setPickedSlave(slave);
    Q_EMIT slaveWanted(slave);
    goTo(time);
  });
  connect(toolbar_, &LiveStripToolbar::triggerWanted, this, &LiveStrip::triggerWanted);
  connect(toolbar_, &LiveStripToolbar::foldWanted, this, [this] { Q_EMIT foldWanted(true); });
  connect(distribution_, &DistributionView::variablesWanted, this, &LiveStrip::variablesWanted);
  connect(stability_, &StabilityView::variablesWanted, this, &LiveStrip::variablesWanted);
  connect(distribution_, &DistributionView::momentChosen, this, &LiveStrip::goTo);
  connect(toolbar_, &LiveStripToolbar::menuRequested, this,
          [this](const QPoint& global) { openMenu(global, cursorPlace()); });
  for (const auto signal : {&CursorSet::changed, &CursorSet::pointerMoved}) {
    connect(&cursors_, signal, this, [this] { text_wanted_ = true; });
  }
  connect(&view_, &TimeView::changed, this, [this] { cursors_.follow(view_.begin(), view_.span()); });
  connect(&tick_, &QTimer::timeout, this, &LiveStrip::tick);
  tick_.setInterval(kTickMs);
  setRecord(nullptr);
  applyTheme();
}

LiveStrip::~LiveStrip() = default;

void LiveStrip::setRecord(const RunRecord* record, bool recorded) {
  if (csv_export_ != nullptr) csv_export_->cancel();
  record_ = record;
  marks_.clear();
  marked_ = 0;
  noted_ = 0;
  recorded_ = recorded;
  setOverlay({});
  for (auto* panel : panels_) panel->setSource(record_);
  variables_->setRecord(record_, recorded);
  attachViews();
  cursors_.clear();
  view_.setClocks(record_ == nullptr
                      ? TimeView::Clocks{}
                      : TimeView::Clocks{[this](Nanoseconds time) { return record_->samples().cycle_at(time); },
                                         [this](Nanoseconds time) { return record_->reference_times().at(time); }});
  free_->setRecord(record_, recorded);
  view_.reset();
  view_.setFollowable(!recorded);
  toolbar_->setReplayed(false);
  if (recorded && hasSamples()) {
    followRecord();
    view_.showAll();
    for (auto* panel : all_panels_) {
      panel->followTime();
      panel->refreshText(true);
    }
  }
  showState();
}

/// What counts samples as they come begins anew.
void LiveStrip::attachViews() {
  distribution_->setRecord(record_, recorded_);
  stability_->setRecord(record_, recorded_);
  slaves_->setRecord(record_);
  cycle_->setRecord(record_);
}

/// Two rows of plots need more than one, and give some to the bar of an overlay; without a record there is a line.
int LiveStrip::leastHeight() const {
  if (record_ == nullptr) return empty_->sizeHint().height() + layout()->contentsMargins().top() * 2;
  if (folded_) return plots_->minimumSizeHint().height() + layout()->contentsMargins().top() * 2;
  const bool overlaid = panels_.front()->overlay().record != nullptr;
  return (variables_->isHidden() ? kLeastHeight : kLeastWithVariables) - (overlaid ? kLeastGiven : 0);
}

void LiveStrip::setFolded(bool folded) {
  if (folded == std::exchange(folded_, folded)) return;
  unfold_->setVisible(folded);
  variables_->setFolded(folded);
  for (auto* panel : panels_) {
    panel->plot()->setVisible(!folded);
    panel->layout()->activate();  // from the inside outwards: the height is wanted now
  }
  plots_->layout()->activate();
  showState();
  refresh();
}

void LiveStrip::setFoldable(bool foldable) { toolbar_->setFoldable(foldable); }

void LiveStrip::setOverlay(const TracePanel::Overlay& overlay) {
  const bool other = overlay.record != panels_.front()->overlay().record;
  for (auto* panel : panels_) panel->setOverlay(overlay);
  overlay_figures_->setSources(record_, overlay);
  distribution_->setOverlay(overlay);
  if (other) setMinimumHeight(leastHeight());
}

void LiveStrip::showMoment(bool back) {
  if (record_ == nullptr || !recorded_) return;
  const bool replayed = record_->shown_at().has_value();
  if (replayed != view_.isFollowable()) {
    // A close look stays as close; all of it would not be left to be looked at.
    const auto span = view_.span();
    const bool all = span >= view_.last() - view_.first();
    view_.setFollowable(replayed);
    if (replayed && !all) view_.setSpan(span);
    toolbar_->setReplayed(replayed);
    followRecord();
    if (!replayed) view_.showAll();
  }
  if (back) {
    const int slave = cycle_->slave();
    attachViews();
    free_->setRecord(record_, recorded_);  // rates are counted as time goes on
    if (slave >= 0) cycle_->select(slave);
  }
  for (auto* panel : all_panels_) panel->plot()->markDirty();
  slaves_->plot()->markDirty();
  refresh();
}

void LiveStrip::adopt(TracePanel* panel) {
  connect(panel->plot(), &TracePlot::menuRequested, this,
          [this, panel](const QPoint& global, Nanoseconds time) { openMenu(global, time, panel); });
  connect(panel->plot(), &TracePlot::triggerLevelDragged, this, &LiveStrip::triggerLevelDragged);
  connect(panel->plot(), &TracePlot::eventClicked, this, &LiveStrip::showEventAt);
  connect(panel->plot(), &TracePlot::limitDragged, this, [this, panel](double magnitude) {
    if (const auto signal = panel->limitSignal()) Q_EMIT limitWanted(*signal, magnitude);
    panel->showWantedLimits(wanted_limits_);
  });
}

void LiveStrip::setWantedLimits(const std::optional<RunLimits>& limits) {
  wanted_limits_ = limits;
  for (auto* panel : all_panels_) panel->showWantedLimits(wanted_limits_);
}

void LiveStrip::gatherPanels() {
  const auto before = std::exchange(all_panels_, fixed_panels_);
  for (auto* panel : free_->plots()) {
    if (std::ranges::find(before, panel) == before.end()) {
      adopt(panel);
      panel->applyTheme();
    }
    all_panels_.push_back(panel);
  }
}

std::vector<TracePanel*> LiveStrip::shownPanels() const {
  if (body_ != Body::kFree) return fixed_panels_;
  return {free_->plots().begin(), free_->plots().end()};
}

TimeView& LiveStrip::activeView() {
  for (auto* panel : shownPanels()) {
    if (panel->plot()->hasFocus()) return *panel->plot()->timeView();
  }
  return view_;
}

void LiveStrip::setOfferedViews(std::vector<MonitorView> views) { free_->setOffered(std::move(views)); }

void LiveStrip::setViews(const std::vector<MonitorView>& views) { free_->setViews(views); }

void LiveStrip::setPickedSlave(int position) {
  for (auto* panel : panels_) panel->setPickedSlave(position);
  slaves_->select(position);
  cycle_->select(position);
  free_->setPickedSlave(position);
}

void LiveStrip::goTo(Nanoseconds time) {
  if (!hasSamples()) return;
  if (body_ != Body::kFree) showBody(Body::kPlots);
  mark(time);
}

void LiveStrip::mark(Nanoseconds time) {
  if (folded_) Q_EMIT plotsWanted();
  view_.goTo(time);
  cursors_.set(CursorSet::kA, time);
}

/// Where it was clicked: the heat map has the same time.
void LiveStrip::showEventAt(Nanoseconds time) {
  mark(time);
  Q_EMIT eventClicked(time);
}

void LiveStrip::showRange(Nanoseconds from, Nanoseconds to, Nanoseconds moment, bool freeze) {
  if (!hasSamples()) return;
  if (body_ != Body::kFree) showBody(Body::kPlots);
  if (folded_) Q_EMIT plotsWanted();
  followRecord();
  view_.setSpan(to - from);
  view_.goTo(from + (to - from) / 2);
  cursors_.set(CursorSet::kA, moment);
  if (freeze && view_.isFollowable()) view_.freeze();
}

void LiveStrip::setTriggerLevel(const TriggerLevel& level) {
  level_ = level;
  showTriggerLevel();
}

/// Which slaves are drawn changes as they do.
void LiveStrip::showTriggerLevel() {
  for (auto* panel : all_panels_) panel->showTriggerLevel(level_.signal, level_.slave, level_.level);
}

/// Events that came since it looked last. What they say in words stands in the messages.
void LiveStrip::collectMarks() {
  if (record_ == nullptr) return;
  const auto& told = record_->events();
  const auto all = record_->forgotten_events() + told.size();
  if (all == marked_) return;
  if (all < marked_) {
    // A recording that was set back.
    marks_.clear();
    marked_ = noted_ = 0;
  }
  const auto fresh = std::min<std::uint64_t>(all - marked_, told.size());
  for (auto event = told.end() - static_cast<std::ptrdiff_t>(fresh); event != told.end(); ++event) {
    const auto meaning = meaning_of(*event);
    if (meaning == EventMeaning::kNews) continue;
    const EventMark mark{event->time, meaning == EventMeaning::kFault, event->slave};
    marks_.insert(std::ranges::upper_bound(marks_, mark.time, {}, &EventMark::time), mark);
  }
  if (marks_.size() > RunRecord::kMostEvents) {
    marks_.erase(marks_.begin(), marks_.end() - static_cast<std::ptrdiff_t>(RunRecord::kMostEvents));
  }
  marked_ = all;
  for (auto* panel : all_panels_) panel->plot()->markDirty();
  slaves_->plot()->markDirty();
}

void LiveStrip::collectNotes() {
  if (record_ == nullptr) return;
  const auto& all = record_->notes();
  const auto later = std::ranges::upper_bound(all, record_->shown_at().value_or(INT64_MAX), {}, &RunNote::time);
  const auto count = static_cast<std::size_t>(later - all.begin());
  if (noted_ == record_->notes_changed() && notes_marked_ == count) return;
  noted_ = record_->notes_changed();
  notes_marked_ = count;
  std::erase_if(marks_, [](const EventMark& mark) { return mark.note; });
  for (const auto& note : std::span(all).first(count)) {
    const EventMark mark{note.time, false, -1, true};
    marks_.insert(std::ranges::upper_bound(marks_, mark.time, {}, &EventMark::time), mark);
  }
  for (auto* panel : all_panels_) panel->plot()->markDirty();
  slaves_->plot()->markDirty();
}

/// The note within a few pixels is meant, else the place itself.
Nanoseconds LiveStrip::notePlace(Nanoseconds time) const {
  constexpr int kReachParts = 150;  // of what is shown
  Nanoseconds nearest = time, distance = view_.span() / kReachParts;
  for (const auto& note : record_->notes()) {
    if (const auto away = std::llabs(note.time - time); away <= distance) {
      distance = away;
      nearest = note.time;
    }
  }
  return nearest;
}

void LiveStrip::followRecord() {
  view_.setOrigin(record_->overview().begin);
  view_.setBounds(record_->samples().first_time(), record_->samples().last_time());
  for (auto* panel : all_panels_) panel->followTime();
}

void LiveStrip::refresh() {
  ticks_ = 0;
  tick();
}

void LiveStrip::tick() {
  if (window()->isMinimized()) return;
  if (hasSamples()) followRecord();
  variables_->follow();
  if (ticks_ % kTextEvery == 0 || (text_wanted_ && ticks_ % kPointedTextEvery == 0)) {
    text_wanted_ = false;
    const bool moving = view_.mode() == TimeView::Mode::kLive;
    const bool choose = moving && ticks_ % kChooseEvery == 0;
    refreshTexts(choose);
    showTriggerLevel();
    for (auto* panel : shownPanels()) panel->showWantedLimits(wanted_limits_);
    showState();
  }
  ++ticks_;
  collectMarks();
  collectNotes();
  if (body_ == Body::kDistribution && isVisible()) return distribution_->refresh();
  if (body_ == Body::kStability && isVisible()) return stability_->refresh();
  if (body_ == Body::kSlaves && isVisible()) return slaves_->refresh();
  if (body_ == Body::kCycle && isVisible()) return cycle_->refresh();
  if (body_ == Body::kFree && isVisible()) return free_->refresh();
  for (auto* panel : fixed_panels_) panel->plot()->refresh();
  overlay_figures_->refresh();
}

/// Of what is shown: another view has words of its own.
void LiveStrip::refreshTexts(bool choose) {
  if (body_ == Body::kPlots || folded_) {
    for (auto* panel : fixed_panels_) panel->refreshText(choose);
  } else if (body_ == Body::kFree && isVisible()) {
    for (auto* panel : free_->plots()) panel->refreshText(choose);
  }
}

void LiveStrip::showState() {
  stack_->setCurrentWidget(!hasSamples() ? empty_ : folded_ ? plots_ : body());
  toolbar_->setEnabled(hasSamples());
  toolbar_->setVisible(record_ != nullptr && !folded_);
  toolbar_->showState();
  setMinimumHeight(leastHeight());
}

QWidget* LiveStrip::body() const {
  QWidget* const bodies[] = {plots_, distribution_, stability_, slaves_, cycle_, free_};
  return bodies[static_cast<std::size_t>(body_)];
}

void LiveStrip::showBody(Body body) {
  if (body == std::exchange(body_, body)) return;
  toolbar_->setWanted(viewOf(body));
  if (folded_) Q_EMIT plotsWanted();
  showState();
  for (auto* panel : all_panels_) panel->plot()->markDirty();
  refreshTexts(view_.mode() == TimeView::Mode::kLive);
  refresh();
}

void LiveStrip::applyTheme() {
  for (auto* panel : all_panels_) panel->applyTheme();
  auto colors = empty_->palette();
  colors.setColor(QPalette::WindowText, theme::mutedText(palette()));
  empty_->setPalette(colors);
  toolbar_->showState();
}

void LiveStrip::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyTheme();
}

void LiveStrip::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  for (auto* panel : all_panels_) panel->plot()->markDirty();
  tick_.start();
}

void LiveStrip::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  tick_.stop();
}

Nanoseconds LiveStrip::cursorPlace() const { return cursors_.pointer().value_or(view_.begin() + view_.span() / 2); }

void LiveStrip::zoomAtMiddle(double factor) {
  auto& view = activeView();
  view.zoom(factor, view.begin() + view.span() / 2);
}

void LiveStrip::keyPressEvent(QKeyEvent* event) {
  const bool far = event->modifiers().testFlag(Qt::ShiftModifier);
  auto& view = activeView();
  const auto page = view.span() / (far ? 1 : 10);
  const bool moves_overlay = event->modifiers().testFlag(Qt::ControlModifier);
  const auto step = std::max<Nanoseconds>(view_.span() / (far ? 20 : 200), 1);
  switch (event->key()) {
    case Qt::Key_Left:
      return moves_overlay ? Q_EMIT overlayMoved(-step) : view.pan(-page);
    case Qt::Key_Right:
      return moves_overlay ? Q_EMIT overlayMoved(step) : view.pan(page);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoomAtMiddle(0.5);
    case Qt::Key_Minus:
      return zoomAtMiddle(2);
    case Qt::Key_Home:
      return view.goToStart();
    case Qt::Key_End:
      return view.goLive();
    case Qt::Key_Space:
      return view.mode() == TimeView::Mode::kLive ? view.freeze() : view.goLive();
    case Qt::Key_F:
      for (auto* panel : all_panels_) panel->plot()->fitValues();
      return;
    case Qt::Key_A:
      return cursors_.set(CursorSet::kA, cursorPlace());
    case Qt::Key_B:
      return cursors_.set(CursorSet::kB, cursorPlace());
    case Qt::Key_D:
      if (hasSamples()) askForDistance();
      return;
    case Qt::Key_N:
      if (hasSamples()) Q_EMIT noteWanted(notePlace(cursorPlace()));
      return;
    case Qt::Key_Escape:
      if (cursors_.any()) return cursors_.clear();
      Q_EMIT escaped();
      break;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace syncline::ui
