// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/free_view.h"

#include <QHBoxLayout>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <utility>

#include "ui/dialogs/plot_dialog.h"
#include "ui/panels/free_plot.h"
#include "ui/panels/usual_views.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/series_csv.h"
#include "ui/plots/view_signals.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr int kLeastPlot = 140, kBetween = 6;  // logical pixels
/// So many arrival phases are drawn at most: ArrivalSeries::kMostKept are kept at once, and other views need some.
constexpr int kMostDerived = 12;
constexpr int kHeightSum = 100;  // of a plot, on average

/// Bands have room for their names, and curves for themselves below them.
int leastHeight(const ViewPlot& plot) {
  constexpr int kAround = 84, kBand = 15, kBandBesideCurves = 30;
  const auto states = static_cast<int>(std::ranges::count_if(plot.signals, isState));
  const bool alone = static_cast<std::size_t>(states) == plot.signals.size();
  return std::max(kLeastPlot, kAround + states * (alone ? kBand : kBandBesideCurves));
}

AxisLimits shownBy(const TracePlot& plot, TracePlot::Side side) {
  return {plot.axis(side).low(), plot.axis(side).high()};
}

}  // namespace

FreeView::FreeView(TimeView* view, CursorSet* cursors, QWidget* parent)
    : QWidget(parent), view_(view), cursors_(cursors) {
  setObjectName(QStringLiteral("freeView"));
  setAccessibleName(tr("Own plots"));
  choice_ = named(new QToolButton, "freeViewChoice", tr("View"));
  choice_->setPopupMode(QToolButton::InstantPopup);
  choice_->setToolTip(tr("Which view is shown; new ones, other names"));
  choice_->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(choice_);
  menu->setObjectName(QStringLiteral("freeViewMenu"));
  choice_->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
  add_ = named(new QToolButton, "freeViewAdd", tr("Add a plot"));
  add_->setText(tr("Add Plot"));
  add_->setToolTip(tr("One more plot below the others"));
  add_->setFocusPolicy(Qt::TabFocus);
  for (auto* button : {choice_, add_}) button->setAutoRaise(true);
  connect(add_, &QToolButton::clicked, this, &FreeView::addPlot);
  hint_ = named(new ValueLabel, "freeViewHint", tr("Whose view it is"));
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(0, 0, 0, 0);
  head->addWidget(choice_);
  head->addWidget(add_);
  head->addWidget(hint_, 1);
  splitter_ = new QSplitter(Qt::Vertical);
  splitter_->setObjectName(QStringLiteral("freeViewSplitter"));
  splitter_->setChildrenCollapsible(false);
  splitter_->setHandleWidth(kBetween);
  connect(splitter_, &QSplitter::splitterMoved, this, &FreeView::readHeights);
  scroll_ = named(new QScrollArea, "freeViewScroll", tr("Own plots"));
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setWidget(splitter_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(head);
  layout->addWidget(scroll_, 1);
}

FreeView::~FreeView() = default;

QWidget* FreeView::canvas() const { return splitter_; }

void FreeView::setRecord(const RunRecord* record, bool recorded) {
  record_ = record;
  recorded_ = recorded;
  for (auto* plot : plots_) plot->setSource(record);
  if (showsUsual()) return chooseUsual(usual_);
  showCurrent();
}

std::vector<MonitorView> FreeView::usual() const {
  if (record_ == nullptr) return {};
  auto views = offered_;
  std::ranges::move(usualViews(*record_, picked_), std::back_inserter(views));
  return views;
}

void FreeView::setOffered(std::vector<MonitorView> views) {
  if (views == offered_) return;
  offered_ = std::move(views);
  if (showsUsual()) chooseUsual(0);
}

void FreeView::setViews(const std::vector<MonitorView>& views) {
  if (views == views_) return;
  const auto before = showsUsual() ? std::string() : current().name;
  // What was put together for a machine is what one wants to see of it.
  const bool others = views_.empty() && !views.empty() && showsUsual();
  views_ = views;
  const auto same = std::ranges::find(views_, before, &MonitorView::name);
  if (!showsUsual() && same != views_.end()) return choose(static_cast<int>(same - views_.begin()));
  if (others || (!showsUsual() && !views_.empty())) return choose(0);
  chooseUsual(std::max(usual_, 0));
}

/// The counters that are proposed are those of the slave that is chosen.
void FreeView::setPickedSlave(int position) {
  if (position == std::exchange(picked_, position) || record_ == nullptr || !showsUsual()) return;
  chooseUsual(usual_);
}

void FreeView::setMarks(const std::vector<EventMark>* marks) {
  marks_ = marks;
  for (auto* plot : plots_) plot->plot()->marks().setMarks(marks);
}

MonitorView FreeView::current() const {
  if (showsUsual()) return made_;
  return chosen_ >= 0 && static_cast<std::size_t>(chosen_) < views_.size() ? views_[static_cast<std::size_t>(chosen_)]
                                                                           : MonitorView{};
}

void FreeView::choose(int view) {
  if (view < 0 || static_cast<std::size_t>(view) >= views_.size()) return;
  chosen_ = view;
  usual_ = -1;
  showCurrent();
}

void FreeView::chooseUsual(int number) {
  const auto all = usual();
  usual_ = std::max(number, 0);
  chosen_ = -1;
  made_ = all.empty() ? MonitorView{} : all[std::min(static_cast<std::size_t>(usual_), all.size() - 1)];
  showCurrent();
}

std::string FreeView::uniqueName(const std::string& wanted) const {
  const auto has = [this](const std::string& name) {
    return std::ranges::find(views_, name, &MonitorView::name) != views_.end();
  };
  if (!has(wanted)) return wanted;
  for (int number = 2;; ++number) {
    if (const auto name = wanted + " (" + std::to_string(number) + ")"; !has(name)) return name;
  }
}

/// A usual view that is changed is the project's from now on.
void FreeView::change(MonitorView view) {
  if (view == current()) return;
  if (showsUsual()) {
    view.name = uniqueName(view.name);
    views_.push_back(std::move(view));
    chosen_ = static_cast<int>(views_.size()) - 1;
    usual_ = -1;
  } else {
    views_[static_cast<std::size_t>(chosen_)] = std::move(view);
  }
  showCurrent();
  Q_EMIT viewsEdited(views_);
}

void FreeView::addView(const MonitorView& view) {
  views_.push_back(view);
  views_.back().name = {};
  views_.back().name = uniqueName(view.name);
  choose(static_cast<int>(views_.size()) - 1);
  Q_EMIT viewsEdited(views_);
}

void FreeView::renameView(const QString& name) {
  const auto wanted = name.trimmed().toStdString();
  if (showsUsual() || wanted.empty() || wanted == current().name) return;
  auto& view = views_[static_cast<std::size_t>(chosen_)];
  view.name = uniqueName(wanted);
  showCurrent();
  Q_EMIT viewsEdited(views_);
}

void FreeView::duplicateView() { addView(current()); }

void FreeView::removeView() {
  if (showsUsual()) return;
  views_.erase(views_.begin() + chosen_);
  if (views_.empty()) {
    chooseUsual(0);
  } else {
    choose(std::min(chosen_, static_cast<int>(views_.size()) - 1));
  }
  Q_EMIT viewsEdited(views_);
}

void FreeView::addPlot() {
  auto view = current();
  view.plots.emplace_back();
  change(std::move(view));
  if (plots_.empty()) return;
  plots_.back()->plot()->setFocus();
  // It has its place when the layout has made it.
  const auto bring = [this] {
    if (!plots_.empty()) scroll_->ensureWidgetVisible(plots_.back());
  };
  QMetaObject::invokeMethod(scroll_, bring, Qt::QueuedConnection);
}

void FreeView::changePlot(int number, const ViewPlot& plot) {
  auto view = current();
  view.plots.at(static_cast<std::size_t>(number)) = plot;
  change(std::move(view));
}

void FreeView::movePlot(int number, int by) {
  auto view = current();
  const int place = number + by;
  const auto from = static_cast<std::size_t>(number);
  const auto to = static_cast<std::size_t>(place);
  if (place < 0 || to >= view.plots.size()) return;
  std::swap(view.plots[from], view.plots[to]);
  change(std::move(view));
}

void FreeView::removePlot(int number) {
  auto view = current();
  view.plots.erase(view.plots.begin() + number);
  change(std::move(view));
}

void FreeView::readHeights() {
  if (showsUsual()) return;  // to make room is not to change what it shows
  const auto sizes = splitter_->sizes();
  auto view = current();
  if (sizes.size() != static_cast<qsizetype>(view.plots.size())) return;
  const int sum = std::max(1, std::accumulate(sizes.begin(), sizes.end(), 0));
  for (qsizetype i = 0; i < sizes.size(); ++i) {
    const auto share = sizes[i] * kHeightSum * static_cast<int>(sizes.size()) / sum;
    view.plots[static_cast<std::size_t>(i)].height = static_cast<std::uint16_t>(std::clamp(share, 1, 10'000));
  }
  if (view == current()) return;
  views_[static_cast<std::size_t>(chosen_)] = std::move(view);
  Q_EMIT viewsEdited(views_);
}

void FreeView::makePlots(std::size_t count) {
  if (plots_.size() == count) return;
  while (plots_.size() > count) {
    auto* gone = plots_.back();
    plots_.pop_back();
    gone->setSource(nullptr);
    gone->setParent(nullptr);
    gone->deleteLater();  // its own menu may have asked for it
  }
  while (plots_.size() < count) {
    const auto number = static_cast<int>(plots_.size());
    auto* plot = new FreePlot(view_, cursors_);
    plot->plot()->marks().setMarks(marks_);
    plot->setSource(record_);
    connect(plot, &FreePlot::edited, this, [this, number](const ViewPlot& wanted) { changePlot(number, wanted); });
    connect(plot, &FreePlot::moveWanted, this, [this, number](int by) { movePlot(number, by); });
    connect(plot, &FreePlot::removeWanted, this, [this, number] { removePlot(number); });
    connect(plot, &FreePlot::settingsWanted, this, [this, number] { openSettings(number); });
    splitter_->addWidget(plot);
    plots_.push_back(plot);
  }
  Q_EMIT plotsChanged();
}

void FreeView::showCurrent() {
  const auto view = current();
  makePlots(view.plots.size());
  const bool right = std::ranges::any_of(view.plots, [](const ViewPlot& plot) {
    return std::ranges::any_of(plot.signals, [](const ViewSignal& one) { return one.right && !isState(one); });
  });
  for (auto* plot : plots_) plot->plot()->setRightReserved(right);
  QList<int> heights;
  int least = 0, derived = kMostDerived;
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    plots_[i]->setMinimumHeight(leastHeight(view.plots[i]));
    plots_[i]->setMostDerived(std::max(derived, 0));
    derived -= FreePlot::derivedOf(view.plots[i]);
    least += plots_[i]->minimumHeight() + kBetween;
    plots_[i]->setPlot(view.plots[i], static_cast<int>(i), static_cast<int>(plots_.size()));
    heights << view.plots[i].height * 10;
  }
  splitter_->setMinimumHeight(least);
  const auto now = splitter_->sizes();
  const int sum = std::max(1, std::accumulate(now.begin(), now.end(), 0));
  const int wanted = std::max(1, std::accumulate(heights.begin(), heights.end(), 0));
  bool moved = now.size() != heights.size();
  for (qsizetype i = 0; !moved && i < now.size(); ++i)
    moved = std::abs(now[i] * static_cast<double>(wanted) / sum - heights[i]) > 0.02 * wanted;
  if (moved) splitter_->setSizes(heights);
  choice_->setText(view.name.empty() ? tr("View") : QString::fromStdString(view.name));
  choice_->setAccessibleName(tr("View: %1").arg(choice_->text()));
  hint_->setText(showsUsual()         ? tr("Proposed; becomes the project's when it is changed")
                 : view.plots.empty() ? tr("No plot yet: Add Plot")
                                      : QString());
  auto colors = palette();
  colors.setColor(QPalette::WindowText, theme::mutedText(palette()));
  hint_->setPalette(colors);
}

void FreeView::fillMenu(QMenu& menu) {
  menu.clear();
  const auto offer = [&](const MonitorView& view, bool shown, auto go) {
    auto name = QString::fromStdString(view.name);
    auto* action = menu.addAction(name.replace(u'&', QStringLiteral("&&")), this, go);
    action->setCheckable(true);
    action->setChecked(shown);
  };
  menu.addSection(tr("Views of the project"));
  for (int i = 0; i < static_cast<int>(views_.size()); ++i)
    offer(views_[static_cast<std::size_t>(i)], i == chosen_, [this, i] { choose(i); });
  if (views_.empty()) menu.addAction(tr("None yet"))->setEnabled(false);
  menu.addSection(tr("Proposed"));
  const auto all = usual();
  for (int i = 0; i < static_cast<int>(all.size()); ++i)
    offer(all[static_cast<std::size_t>(i)], i == usual_, [this, i] { chooseUsual(i); });
  menu.addSeparator();
  menu.addAction(tr("New view"), this, [this] { addView({tr("Own view").toStdString(), {ViewPlot{}}}); });
  menu.addAction(tr("Rename…"), this, &FreeView::askForName)->setEnabled(!showsUsual());
  menu.addAction(tr("Duplicate"), this, &FreeView::duplicateView);
  menu.addAction(tr("Delete"), this, &FreeView::removeView)->setEnabled(!showsUsual());
  if (recorded_) return;
  menu.addSeparator();
  menu.addAction(tr("Watch variables…"), this, &FreeView::variablesWanted);
}

void FreeView::askForName() {
  bool ok = false;
  const auto name = QInputDialog::getText(this, tr("Rename View"), tr("Name of the view"), QLineEdit::Normal,
                                          QString::fromStdString(current().name), &ok);
  if (ok) renameView(name);
}

/// Meanwhile another run may have begun, and another project may be open.
void FreeView::openSettings(int number) {
  if (record_ == nullptr) return;
  const auto before = current();
  const auto at = static_cast<std::size_t>(number);
  const auto& canvas = *plots_.at(at)->plot();
  PlotDialog dialog(*record_, before.plots.at(at), shownBy(canvas, TracePlot::kLeft),
                    shownBy(canvas, TracePlot::kRight), this);
  if (dialog.exec() == QDialog::Accepted && current() == before) changePlot(number, dialog.plot());
}

void FreeView::refresh() {
  for (auto* plot : plots_) {
    plot->follow();
    plot->refresh();
  }
}

void FreeView::setForPicture(bool on) {
  for (auto* plot : plots_) {
    plot->setButtons(!on);
    if (on) plot->renew();
  }
  for (auto* plot : plots_) plot->plot()->redraw();
}

CsvTable FreeView::table(Nanoseconds from, Nanoseconds to) const {
  if (record_ == nullptr) return {{}, {}, 0, 0, 0};
  std::vector<CsvColumn> columns;
  for (auto* plot : plots_) {
    for (auto& column : plot->columns()) {
      // In several plots it is one signal all the same.
      const bool there = std::ranges::any_of(columns, [&](const auto& one) { return one.name == column.name; });
      if (!there) columns.push_back(std::move(column));
    }
  }
  const auto& samples = record_->samples();
  const auto cycle = [&samples](Nanoseconds time) { return samples.cycle_at(time); };
  return {std::move(columns), cycle, view_->origin(), from, to + 1};
}

}  // namespace syncline::ui
