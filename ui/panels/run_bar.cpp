// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/run_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/session/run_difference.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

RunBar::RunBar(RunDifference& difference, QWidget* parent)
    : NoticeBar(theme::Tone::kWarning, Qt::TopEdge, parent), difference_(difference) {
  setObjectName(QStringLiteral("runBar"));
  setAccessibleName(tr("Project and running machine"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 5, 10, 5);
  layout->setSpacing(8);
  text_ = named(new QLabel, "runBarText", tr("Project and running machine"));
  text_->setWordWrap(true);
  layout->addWidget(text_, 1);
  show_ = add("runBarShow", tr("Differences…"), tr("What the project says otherwise than the machine that runs"));
  apply_ = add("runBarApply", tr("Apply"), {});
  restart_ = add("runBarRestart", tr("Restart…"), tr("Takes the machine offline and starts it with the project"));
  revert_ = add("runBarRevert", tr("Revert"), tr("Makes the project again what runs; Undo takes that back"));
  connect(show_, &QPushButton::clicked, this, &RunBar::differencesWanted);
  connect(apply_, &QPushButton::clicked, &difference_, &RunDifference::apply);
  connect(restart_, &QPushButton::clicked, this, &RunBar::restartWanted);
  connect(revert_, &QPushButton::clicked, this, &RunBar::revertWanted);
  connect(&difference_, &RunDifference::changed, this, &RunBar::refresh);
  refresh();
}

QPushButton* RunBar::add(const char* object_name, const QString& text, const QString& tip) {
  auto* button = named(new QPushButton(text), object_name, text);
  button->setToolTip(tip);
  button->setAutoDefault(false);
  layout()->addWidget(button);
  return button;
}

void RunBar::refresh() {
  setVisible(difference_.differs());
  if (!difference_.differs()) return;
  const int count = difference_.changes();
  text_->setText(count > 0 ? tr("The machine does not run what the project says: %n change(s).", nullptr, count)
                           : tr("The machine does not run what the project says."));
  apply_->setEnabled(difference_.applicable());
  apply_->setToolTip(difference_.applicable()
                         ? tr("Gives the parameters of the master synchronisation to the running machine")
                         : tr("Only parameters of the master synchronisation can be changed while the machine runs"));
}

}  // namespace syncline::ui
