// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/overlay_bar.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <cmath>

#include "ui/editors/choice_edit.h"
#include "ui/plots/plot_colors.h"
#include "ui/session/recording_overlay.h"
#include "ui/session/trigger_monitor.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr double kMostSeconds = 1e6;  // of which a double knows every nanosecond
constexpr int kSwatchSide = 10, kBarLeft = 14;

}  // namespace

OverlayBar::OverlayBar(RecordingOverlay& overlay, const TriggerMonitor& trigger, QWidget* parent)
    : NoticeBar(theme::Tone::kBusy, Qt::BottomEdge, parent), overlay_(overlay), trigger_(trigger) {
  setObjectName(QStringLiteral("overlayBar"));
  setAccessibleName(tr("Recording laid over the one that is shown"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kBarLeft + kSwatchSide + 6, 1, 10, 2);
  layout->setSpacing(6);
  name_ = named(new ValueLabel, "overlayName", tr("Recording laid over the one that is shown"));
  name_->setLeastCharacters(12);
  layout->addWidget(name_, 1);
  auto* by = new QLabel(tr("Aligned by"));
  layout->addWidget(by);
  place_ = named(new ChoiceEdit, "overlayPlace", tr("By what the two recordings are aligned"));
  place_->addItems({tr("Beginnings"), tr("Armed"), tr("First trigger"), tr("Hand")});
  place_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  place_->setMinimumWidth(place_->sizeHint().width());
  place_->setToolTip(
      tr("What lies over each other: the first cycles, the moments at which figures were armed (in OP and in sync), or "
         "the "
         "first episodes of the trigger as it is set in the panel Trigger"));
  by->setBuddy(place_);
  connect(place_, &QComboBox::activated, this, &OverlayBar::align);
  layout->addWidget(place_);
  auto* later = new QLabel(tr("later by"));
  layout->addWidget(later);
  offset_ = named(new QDoubleSpinBox, "overlayOffset", tr("How much later it is drawn"));
  offset_->setToolTip(
      tr("How much later than with both beginnings together; arrow keys move it by a cycle. In the plots "
         "Ctrl and the arrow keys or dragging with Ctrl move it, too"));
  offset_->setRange(-kMostSeconds, kMostSeconds);
  offset_->setDecimals(9);
  offset_->setSuffix(tr(" s"));
  offset_->setKeyboardTracking(false);
  offset_->setFocusPolicy(Qt::StrongFocus);
  offset_->setFixedWidth(140);
  offset_->installEventFilter(this);
  later->setBuddy(offset_);
  connect(offset_, &QDoubleSpinBox::valueChanged, this,
          [this](double seconds) { overlay_.setOffset(std::llround(seconds * 1e9)); });
  layout->addWidget(offset_);
  auto* close = named(new QToolButton, "overlayClose", tr("Take the other recording away"));
  close->setText(tr("Remove"));
  close->setToolTip(tr("Takes the recording that lies over this one away"));
  close->setFocusPolicy(Qt::StrongFocus);
  connect(close, &QToolButton::clicked, &overlay_, &RecordingOverlay::close);
  layout->addWidget(close);
  connect(&overlay_, &RecordingOverlay::changed, this, [this] {
    if (!overlay_.isOpen()) return refresh();
    // Not before the plots have given room for it, or a window that is as small as it can be would grow.
    QTimer::singleShot(0, this, &OverlayBar::refresh);
  });
  connect(&overlay_, &RecordingOverlay::moved, this, &OverlayBar::refresh);
  refresh();
}

void OverlayBar::align(int choice) {
  const auto place = static_cast<RecordingOverlay::Place>(choice);
  if (!overlay_.align(place, trigger_.trigger())) {
    Q_EMIT refused(place == RecordingOverlay::Place::kArmed
                       ? tr("One of the two recordings was not armed: it cannot be aligned so.")
                       : tr("The trigger as it is set does not occur in both recordings."));
  }
  refresh();
}

void OverlayBar::refresh() {
  setVisible(overlay_.isOpen());
  if (!overlay_.isOpen()) return;
  name_->setText(tr("Over it: %1").arg(QFileInfo(overlay_.path()).fileName()));
  name_->setToolTip(overlay_.path());
  place_->setCurrentIndex(static_cast<int>(overlay_.place()));
  const QSignalBlocker quiet(offset_);
  offset_->setSingleStep(static_cast<double>(overlay_.step()) / 1e9);
  offset_->setValue(static_cast<double>(overlay_.offset()) / 1e9);
}

/// The wheel without the focus edits nothing.
bool OverlayBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel && !offset_->hasFocus()) {
    event->ignore();
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

void OverlayBar::paintEvent(QPaintEvent* event) {
  NoticeBar::paintEvent(event);
  QPainter(this).fillRect(QRect(kBarLeft, (height() - kSwatchSide) / 2, kSwatchSide, kSwatchSide),
                          plot_colors::overlay(palette()));
}

}  // namespace syncline::ui
