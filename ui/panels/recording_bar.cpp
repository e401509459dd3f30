// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/recording_bar.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/session/opened_recording.h"
#include "ui/text/recorded_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

RecordingBar::RecordingBar(OpenedRecording& recording, QWidget* parent) : QFrame(parent), recording_(recording) {
  setObjectName(QStringLiteral("recordingBar"));
  setAccessibleName(tr("Recording that is shown"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 5, 10, 5);
  layout->setSpacing(8);
  text_ = named(new QLabel, "recordingBarText", tr("Recording that is shown"));
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(text_, 1);
  auto* close = named(new QPushButton(tr("Close")), "recordingBarClose", tr("Close the recording"));
  close->setToolTip(tr("Shows the project and its machine again"));
  close->setAutoDefault(false);
  connect(close, &QPushButton::clicked, &recording_, &OpenedRecording::close);
  layout->addWidget(close);
  connect(&recording_, &OpenedRecording::changed, this, &RecordingBar::refresh);
  refresh();
}

void RecordingBar::refresh() {
  setVisible(recording_.isOpen());
  if (!recording_.isOpen()) return;
  text_->setText(tr("<b>Recording %1</b> – %2. Nothing here is live.")
                     .arg(QFileInfo(recording_.path()).fileName().toHtmlEscaped(),
                          recordingText(recording_.run()).toHtmlEscaped()));
  text_->setToolTip(recording_.path());
}

void RecordingBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::toneFill(palette(), theme::Tone::kBusy));
  painter.setPen(theme::outline(palette()));
  painter.drawLine(rect().bottomLeft(), rect().bottomRight());
}

void RecordingBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace syncline::ui
