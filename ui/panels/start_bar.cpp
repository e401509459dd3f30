// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/start_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "ui/session/start_refusal.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

StartBar::StartBar(StartRefusal& refusal, QWidget* parent)
    : NoticeBar(theme::Tone::kBad, Qt::TopEdge, parent), refusal_(refusal) {
  setObjectName(QStringLiteral("startBar"));
  setAccessibleName(tr("Start that failed"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 5, 10, 5);
  layout->setSpacing(8);
  text_ = named(new QLabel, "startBarText", tr("Why the machine did not start"));
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  slave_ = named(new QPushButton(tr("Show the Slave")), "startBarSlave", tr("Show the slave that it is about"));
  scan_ = named(new QPushButton(tr("Scan and Compare…")), "startBarScan", tr("Scan the bus and compare"));
  scan_->setToolTip(tr("Looks what is on the bus and shows it beside the project: missing, more, another revision"));
  for (auto* button : {slave_, scan_}) button->setAutoDefault(false);
  close_ = named(new QToolButton, "startBarClose", tr("Close"));
  close_->setToolTip(tr("Close; the messages keep it"));
  close_->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close_->setAutoRaise(true);
  layout->addWidget(text_, 1);
  layout->addWidget(slave_);
  layout->addWidget(scan_);
  layout->addWidget(close_);
  connect(slave_, &QPushButton::clicked, this, [this] {
    if (refusal_.reason()) Q_EMIT slaveWanted(refusal_.reason()->slave);
  });
  connect(scan_, &QPushButton::clicked, this, &StartBar::scanWanted);
  connect(close_, &QToolButton::clicked, &refusal_, &StartRefusal::forget);
  connect(&refusal_, &StartRefusal::changed, this, &StartBar::refresh);
  refresh();
}

void StartBar::refresh() {
  setVisible(refusal_.isRefused());
  if (!refusal_.isRefused()) return;
  const auto& reason = refusal_.reason();
  auto text = reason ? tr("The machine did not start. %1: %2").arg(reason->source, reason->text)
                     : tr("The machine did not start; the messages say how far it came.");
  if (const int more = refusal_.furtherSlaves(); more > 0)
    text += u' ' + tr("(%n further slave(s) in the messages)", nullptr, more);
  text_->setText(text);
  slave_->setVisible(reason && reason->slave >= 0);
}

}  // namespace syncline::ui
