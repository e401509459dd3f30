// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/recording_bar.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/session/opened_recording.h"
#include "ui/text/recorded_text.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr int kLeastOfText = 14;  // of the text, so that it says what is shown

}  // namespace

RecordingBar::RecordingBar(OpenedRecording& recording, QWidget* transport, QWidget* parent)
    : NoticeBar(theme::Tone::kBusy, Qt::BottomEdge, parent), recording_(recording) {
  setObjectName(QStringLiteral("recordingBar"));
  setAccessibleName(tr("Recording that is shown"));
  // One row, for height is what a small screen lacks: what it has no room for is told by pointing at it, and the title
  // of the window names the file.
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 3, 8, 3);
  layout->setSpacing(2);
  layout->addWidget(transport, 4);
  text_ = named(new ValueLabel, "recordingBarText", tr("Recording that is shown"));
  // Its length is no reason to take room from the slider.
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  text_->setMinimumWidth(kLeastOfText * fontMetrics().averageCharWidth());
  layout->addSpacing(4);
  layout->addWidget(text_, 1);
  auto* close = named(new QToolButton, "recordingBarClose", tr("Close the recording"));
  close->setText(tr("Close"));
  close->setToolTip(tr("Shows the project and its machine again"));
  close->setFocusPolicy(Qt::StrongFocus);
  connect(close, &QToolButton::clicked, &recording_, &OpenedRecording::close);
  layout->addWidget(close);
  connect(&recording_, &OpenedRecording::changed, this, &RecordingBar::refresh);
  refresh();
}

void RecordingBar::refresh() {
  setVisible(recording_.isOpen());
  if (!recording_.isOpen()) return;
  text_->setText(
      tr("Recording %1 (not live): %2").arg(QFileInfo(recording_.path()).fileName(), recordingText(recording_.run())));
  text_->setToolTip(recording_.path());
}

}  // namespace syncline::ui
