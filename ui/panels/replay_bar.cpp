// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/replay_bar.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>
#include <utility>

#include "ui/editors/choice_edit.h"
#include "ui/panels/replay_slider.h"
#include "ui/session/recording_replay.h"
#include "ui/text/menu_key.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kReplayIcon = 18;

QString secondsText(Nanoseconds time) { return QLocale().toString(static_cast<double>(time) / 1e9, 'f', 6); }

}  // namespace

ReplayBar::ReplayBar(RecordingReplay& replay, QWidget* parent) : QWidget(parent), replay_(replay) {
  setObjectName(QStringLiteral("replayBar"));
  setAccessibleName(tr("Replay of the recording"));
  begin_ = command("actionReplayBegin", tr("To the &Beginning"), tr("To the beginning of the recording"),
                   "replay-begin", QKeySequence(Qt::ALT | Qt::Key_Home));
  last_mark_ = command("actionReplayLastEvent", tr("Pre&vious Event"), tr("To the event or note before"),
                       "replay-last-event", QKeySequence(Qt::ALT | Qt::Key_PageUp));
  last_cycle_ = command("actionReplayLastCycle", tr("Cycle B&ack"), tr("A cycle back"), "replay-last-cycle",
                        QKeySequence(Qt::ALT | Qt::Key_Left));
  play_ = command("actionReplayPlay", tr("&Play"), tr("Play the recording as it was live, or pause"), "replay-play",
                  QKeySequence(Qt::CTRL | Qt::Key_P));
  next_cycle_ = command("actionReplayNextCycle", tr("Cycle &Further"), tr("A cycle further"), "replay-next-cycle",
                        QKeySequence(Qt::ALT | Qt::Key_Right));
  next_mark_ = command("actionReplayNextEvent", tr("&Next Event"), tr("To the next event or note"), "replay-next-event",
                       QKeySequence(Qt::ALT | Qt::Key_PageDown));
  end_ = command("actionReplayEnd", tr("To the &End"), tr("To the end of the recording"), "replay-end",
                 QKeySequence(Qt::ALT | Qt::Key_End));
  slower_ = command("actionReplaySlower", tr("&Slower"), tr("Play slower"), "", QKeySequence(Qt::ALT | Qt::Key_Minus));
  faster_ = command("actionReplayFaster", tr("Fas&ter"), tr("Play faster"), "", QKeySequence(Qt::ALT | Qt::Key_Plus));
  whole_ = command("actionReplayWhole", tr("&Whole Recording"),
                   tr("Show the whole recording again (Esc in the plots or in this bar)"), "", {});
  connect(begin_, &QAction::triggered, &replay_, [this] { replay_.seek(replay_.begin()); });
  connect(last_mark_, &QAction::triggered, &replay_, [this] { replay_.stepMark(-1); });
  connect(last_cycle_, &QAction::triggered, &replay_, [this] { replay_.stepCycle(-1); });
  connect(play_, &QAction::triggered, &replay_, [this] { replay_.isPlaying() ? replay_.pause() : replay_.play(); });
  connect(next_cycle_, &QAction::triggered, &replay_, [this] { replay_.stepCycle(1); });
  connect(next_mark_, &QAction::triggered, &replay_, [this] { replay_.stepMark(1); });
  connect(end_, &QAction::triggered, &replay_, [this] { replay_.seek(replay_.end()); });
  connect(slower_, &QAction::triggered, &replay_, [this] { replay_.setSpeed(replay_.speed() - 1); });
  connect(faster_, &QAction::triggered, &replay_, [this] { replay_.setSpeed(replay_.speed() + 1); });
  connect(whole_, &QAction::triggered, &replay_, &RecordingReplay::leave);

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  addButton(*layout, *begin_, "replayBegin");
  addButton(*layout, *last_mark_, "replayLastEvent");
  addButton(*layout, *last_cycle_, "replayLastCycle");
  addButton(*layout, *play_, "replayPlay");
  addButton(*layout, *next_cycle_, "replayNextCycle");
  addButton(*layout, *next_mark_, "replayNextEvent");
  addButton(*layout, *end_, "replayEnd");
  layout->addSpacing(4);
  speed_ = named(new ChoiceEdit, "replaySpeed", tr("Speed of the replay"));
  speed_->setToolTip(tr("How fast the recording is played, against the time of the run (Alt+Minus, Alt+Plus)"));
  for (const auto& speed : RecordingReplay::kSpeeds) {
    const bool real = speed.run == speed.clock;
    speed_->addItem(real              ? tr("Real time")
                    : speed.clock > 1 ? QStringLiteral("\u00D71/%1").arg(speed.clock)
                                      : QStringLiteral("\u00D7%1").arg(speed.run));
  }
  connect(speed_, &QComboBox::activated, &replay_, &RecordingReplay::setSpeed);
  layout->addWidget(speed_);
  layout->addSpacing(4);
  place_ = named(new ReplaySlider(replay), "replayPlace", tr("Moment of the recording"));
  place_->setToolTip(tr("The moment that is shown; ticks are events and notes"));
  connect(place_, &ReplaySlider::momentChosen, &replay_, &RecordingReplay::seek);
  layout->addWidget(place_, 1);
  layout->addSpacing(4);
  time_ = named(new QLabel, "replayTime", tr("Time of the replay"));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(time_);
  layout->addSpacing(4);
  leave_ = named(new QToolButton, "replayLeave", tr("Show the whole recording"));
  leave_->setText(tr("Whole"));
  leave_->setToolTip(whole_->toolTip());
  leave_->setFocusPolicy(Qt::StrongFocus);
  connect(leave_, &QToolButton::clicked, whole_, &QAction::trigger);
  layout->addWidget(leave_);
  connect(&replay_, &RecordingReplay::changed, this, &ReplayBar::refresh);
  connect(&replay_, &RecordingReplay::moved, this, &ReplayBar::showMoment);
  drawIcons();
  refresh();
}

QAction* ReplayBar::command(const char* name, const QString& text, const QString& tip, const char* icon,
                            const QKeySequence& keys) {
  auto* action = new QAction(text, this);
  action->setObjectName(QLatin1String(name));
  action->setIconText(withoutMenuKey(text));
  action->setShortcut(keys);
  action->setToolTip(keys.isEmpty() ? tip
                                    : QStringLiteral("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
  action->setProperty("iconName", QLatin1String(icon));
  commands_.append(action);
  return action;
}

void ReplayBar::addButton(QHBoxLayout& layout, QAction& action, const char* name) {
  auto* button = named(new QToolButton, name, action.iconText());
  button->setDefaultAction(&action);
  button->setAutoRaise(true);
  button->setIconSize(QSize(kReplayIcon, kReplayIcon));
  button->setFocusPolicy(Qt::StrongFocus);
  layout.addWidget(button);
}

void ReplayBar::refresh() {
  const bool possible = replay_.isPossible();
  setVisible(possible);
  for (auto* action : commands_) action->setEnabled(possible);
  if (!possible) return;
  play_->setText(replay_.isPlaying() ? tr("&Pause") : tr("&Play"));
  play_->setIconText(withoutMenuKey(play_->text()));
  play_->setProperty("iconName", replay_.isPlaying() ? QStringLiteral("replay-pause") : QStringLiteral("replay-play"));
  play_->setIcon(theme::icon(play_->property("iconName").toString(), palette()));
  slower_->setEnabled(replay_.speed() > 0);
  faster_->setEnabled(replay_.speed() + 1 < static_cast<int>(RecordingReplay::kSpeeds.size()));
  whole_->setEnabled(replay_.isActive());
  leave_->setEnabled(replay_.isActive());
  speed_->setCurrentIndex(replay_.speed());
  place_->update();
  keepRoom();
  fit();
  showMoment();
}

/// Of the time, so that what stands beside it keeps its place while it is played; without the end where there is no
/// room.
void ReplayBar::keepRoom() {
  const auto end = replay_.end() - replay_.begin();
  const auto wide = [this, end](bool narrow) { return time_->fontMetrics().horizontalAdvance(text(end, narrow)) + 4; };
  spare_ = wide(false) - wide(true);
  time_->setMinimumWidth(wide(narrow_));
}

QString ReplayBar::text(Nanoseconds moment, bool narrow) const {
  if (narrow) return QStringLiteral("%1 s").arg(secondsText(moment));
  return tr("%1 of %2 s").arg(secondsText(moment), secondsText(replay_.end() - replay_.begin()));
}

QSize ReplayBar::minimumSizeHint() const {
  auto size = layout()->minimumSize();
  if (!narrow_) size.rwidth() -= spare_;
  return size;
}

void ReplayBar::fit() {
  const bool narrow = width() < minimumSizeHint().width() + spare_;
  if (narrow == std::exchange(narrow_, narrow)) return;
  keepRoom();
  updateGeometry();
}

void ReplayBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool before = narrow_;
  fit();
  if (narrow_ != before) showMoment();
}

void ReplayBar::showMoment() {
  place_->showMoment();
  const auto moment = replay_.moment() - replay_.begin();
  time_->setText(text(moment, narrow_));
  time_->setToolTip(narrow_ ? text(moment, false) : QString());
  const bool first = replay_.moment() <= replay_.begin(), last = replay_.isAtEnd() && replay_.isActive();
  begin_->setEnabled(replay_.isPossible() && !first);
  for (auto* action : {last_mark_, last_cycle_}) action->setEnabled(replay_.isPossible() && !first);
  for (auto* action : {next_cycle_, next_mark_, end_})
    action->setEnabled(replay_.isPossible() && replay_.isActive() && !last);
}

void ReplayBar::drawIcons() {
  for (auto* action : commands_) {
    const auto name = action->property("iconName").toString();
    if (!name.isEmpty()) action->setIcon(theme::icon(name, palette()));
  }
}

void ReplayBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && replay_.isActive()) return replay_.leave();
  QWidget::keyPressEvent(event);
}

void ReplayBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  drawIcons();
  update();
}

}  // namespace syncline::ui
