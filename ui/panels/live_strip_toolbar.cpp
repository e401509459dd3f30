// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/live_strip_toolbar.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "ui/plots/cursor_item.h"
#include "ui/plots/time_view.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {

LiveStripToolbar::LiveStripToolbar(TimeView* view, CursorSet* cursors, QWidget* parent)
    : QWidget(parent), view_(view), cursors_(cursors), state_(new ValueLabel), delta_(new ValueLabel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  struct Choice {
    const char* name;
    QString text;
    Nanoseconds span;
  };
  for (const auto& choice :
       {Choice{"span1s", tr("1 s"), kSecond}, Choice{"span10s", tr("10 s"), 10 * kSecond},
        Choice{"span60s", tr("60 s"), 60 * kSecond}, Choice{"span10min", tr("10 min"), 600 * kSecond}}) {
    auto* button = addButton(layout, choice.name, choice.text, tr("Show the last %1").arg(choice.text));
    button->setCheckable(true);
    connect(button, &QToolButton::clicked, view_, [this, span = choice.span] {
      view_->setSpan(span);
      showState();
    });
    lengths_.push_back({button, choice.span});
  }
  layout->addSpacing(10);
  live_ = addButton(layout, "liveButton", tr("Live"), tr("Follow the newest sample (End)"));
  live_->setCheckable(true);
  connect(live_, &QToolButton::clicked, view_, &TimeView::goLive);
  freeze_ = addButton(layout, "freezeButton", tr("Freeze"), tr("Stop the picture, not the acquisition (Space)"));
  freeze_->setCheckable(true);
  connect(freeze_, &QToolButton::clicked, view_, [this](bool on) { on ? view_->freeze() : view_->goLive(); });
  measure_ = addButton(layout, "cursorsButton", tr("Cursors"),
                       tr("Two cursors to drag (keys A and B put them at the pointer)"));
  measure_->setCheckable(true);
  connect(measure_, &QToolButton::clicked, this, &LiveStripToolbar::cursorsToggled);
  auto* fit = addButton(layout, "fitButton", tr("Fit"), tr("Fit the value axes to what is shown (F)"));
  connect(fit, &QToolButton::clicked, this, &LiveStripToolbar::fitRequested);
  addView(layout, View::kFree, "freeButton", tr("Own Plots"),
          tr("Any signals in as many plots as you like, instead of these; kept with the project"));
  addView(layout, View::kDistribution, "distributionButton", tr("Distribution"),
          tr("How often which value came, instead of the plots over time"));
  addView(layout, View::kStability, "stabilityButton", tr("Stability"),
          tr("How steady signals are over observation times, and their spectrum, instead of the plots"));
  addView(layout, View::kSlaves, "slavesButton", tr("Slaves"),
          tr("The deviations of all slaves as a heat map, and their figures, instead of the plots"));
  addView(layout, View::kCycle, "cycleButton", tr("Cycle"),
          tr("Where in the SYNC0 period of a slave its outputs come, instead of the plots"));
  buildViews(layout);
  auto* trigger = addButton(layout, "triggerButton", tr("Trigger"),
                            tr("Stops or moves the plots where a signal or an event does what you wait for"));
  connect(trigger, &QToolButton::clicked, this, &LiveStripToolbar::triggerWanted);
  layout->addSpacing(6);
  layout->addWidget(named(state_, "liveStateLabel", tr("State of the plots")));
  layout->addStretch(1);
  layout->addWidget(named(delta_, "cursorDeltaLabel", tr("Time between the cursors")));
  for (auto* label : {state_, delta_}) label->setLeastCharacters(12);
  QToolButton* menu = addButton(layout, "liveMenuButton", QStringLiteral("\u22EF"), tr("Export, axes and cursors"));
  menu->setAccessibleName(tr("Menu of the live plots"));
  connect(menu, &QToolButton::clicked, this,
          [this, menu] { Q_EMIT menuRequested(menu->mapToGlobal(menu->rect().bottomLeft())); });
  fold_ = addButton(layout, "foldButton", {}, tr("Leave only the figures of the plots"));
  fold_->setAccessibleName(fold_->toolTip());
  fold_->setArrowType(Qt::DownArrow);
  connect(fold_, &QToolButton::clicked, this, &LiveStripToolbar::foldWanted);
  connect(view_, &TimeView::modeChanged, this, &LiveStripToolbar::showState);
  connect(cursors_, &CursorSet::changed, this, &LiveStripToolbar::showState);
  showState();
}

void LiveStripToolbar::addView(QHBoxLayout* layout, View view, const char* name, const QString& text,
                               const QString& tip) {
  auto* button = addButton(layout, name, text, tip);
  button->setCheckable(true);
  connect(button, &QToolButton::clicked, this, [this, view](bool on) { Q_EMIT viewToggled(view, on); });
  view_buttons_.push_back({view, button});
}

QToolButton* LiveStripToolbar::addButton(QHBoxLayout* layout, const char* name, const QString& text,
                                         const QString& tip) {
  auto* button = named(new QToolButton, name, text);
  button->setText(text);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  // Space and the arrows belong to the plots.
  button->setFocusPolicy(Qt::TabFocus);
  layout->addWidget(button);
  return button;
}

/// In place of the buttons of the views where there is no room for all of them.
void LiveStripToolbar::buildViews(QHBoxLayout* layout) {
  views_ = addButton(layout, "viewsButton", tr("View"), tr("What is shown instead of the plots over time"));
  views_->setPopupMode(QToolButton::InstantPopup);
  views_->setCheckable(true);
  views_->hide();
  auto* menu = new QMenu(views_);
  menu->setObjectName(QStringLiteral("viewsMenu"));
  views_->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const auto& [view, button] : view_buttons_) {
      auto* action = menu->addAction(button->text(), button, &QToolButton::click);
      action->setCheckable(true);
      action->setChecked(button->isChecked());
    }
  });
  connect(menu, &QMenu::aboutToHide, this, &LiveStripToolbar::showViews);
}

void LiveStripToolbar::showViews() {
  const auto shown = std::ranges::find_if(view_buttons_, [](const ViewButton& one) { return one.button->isChecked(); });
  views_->setChecked(shown != view_buttons_.end());
  views_->setText(shown != view_buttons_.end() ? shown->button->text() : tr("View"));
}

/// Of the buttons that make room for one, more than that one.
int LiveStripToolbar::spare() const {
  int width = -views_->sizeHint().width();
  for (const auto& [view, button] : view_buttons_) width += button->sizeHint().width() + layout()->spacing();
  return width - layout()->spacing();
}

QSize LiveStripToolbar::minimumSizeHint() const {
  auto size = layout()->minimumSize();
  if (!narrow_) size.rwidth() -= spare();
  return size;
}

void LiveStripToolbar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool narrow = width() < minimumSizeHint().width() + spare();
  if (narrow == std::exchange(narrow_, narrow)) return;
  for (const auto& [view, button] : view_buttons_) button->setVisible(!narrow);
  views_->setVisible(narrow);
  showViews();
}

void LiveStripToolbar::setWanted(View view) {
  for (const auto& one : view_buttons_) one.button->setChecked(one.view == view);
  showViews();
}

void LiveStripToolbar::setFoldable(bool foldable) { fold_->setVisible(foldable); }

void LiveStripToolbar::setReplayed(bool replayed) {
  replayed_ = replayed;
  live_->setText(replayed ? tr("Now") : tr("Live"));
  live_->setAccessibleName(live_->text());
  showState();
}

void LiveStripToolbar::showState() {
  using Mode = TimeView::Mode;
  for (const auto& length : lengths_) length.button->setChecked(view_->span() == length.span);
  live_->setChecked(view_->mode() == Mode::kLive);
  freeze_->setChecked(view_->mode() == Mode::kFrozen);
  const bool follows = view_->isFollowable();
  const bool ended = follows && !replayed_ && !view_->goesOn();
  live_->setEnabled(follows);
  freeze_->setEnabled(follows && !ended);
  live_->setToolTip(replayed_ ? tr("Follow the moment of the replay (End)")
                    : ended   ? tr("Show the end of the run (End)")
                    : follows ? tr("Follow the newest sample (End)")
                              : tr("A recording has no newest sample to follow"));
  freeze_->setToolTip(replayed_ ? tr("Stop the picture, not the replay (Space)")
                      : ended   ? tr("The run has ended: its picture stands still")
                      : follows ? tr("Stop the picture, not the acquisition (Space)")
                                : tr("A recording stands still"));
  measure_->setChecked(cursors_->any());
  QString text, shorter;
  auto tone = theme::Tone::kNeutral;
  if (!follows) {
    text = tr("Recording");
  } else if (view_->mode() != Mode::kLive) {
    const auto behind =
        timeText(std::max<Nanoseconds>(view_->behind(), 0) / (100 * kMillisecond) * (100 * kMillisecond));
    text = (ended                            ? tr("Ended, %1 before the end")
            : view_->mode() == Mode::kFrozen ? tr("Frozen, %1 behind")
                                             : tr("History, %1 behind"))
               .arg(behind);
    shorter = QStringLiteral("\u2212") + behind;
    tone = ended ? theme::Tone::kNeutral : theme::Tone::kWarning;
  } else if (ended) {
    text = tr("Ended");
  } else if (replayed_) {
    text = tr("Replay");
    tone = theme::Tone::kBusy;
  }
  auto colors = state_->palette();
  colors.setColor(QPalette::WindowText, theme::toneColor(palette(), tone));
  state_->setPalette(colors);
  state_->setText(text, shorter);
  QString delta;
  if (cursors_->both()) {
    const auto time = cursors_->delta();
    delta = tr("B−A %1").arg(signedTimeText(time));
    if (time != 0)
      delta += tr("   1/\u0394t %1 Hz").arg(QLocale().toString(1e9 / std::abs(static_cast<double>(time)), 'g', 6));
  }
  delta_->setText(delta);
}

}  // namespace syncline::ui
