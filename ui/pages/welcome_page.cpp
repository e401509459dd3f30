// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/welcome_page.h"

#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

constexpr int kRecentWidth = 500, kMostShown = 6;

}  // namespace

WelcomePage::WelcomePage(const QList<QAction*>& beginnings, WindowMemory& memory, QWidget* parent)
    : QWidget(parent), memory_(memory) {
  setObjectName(QStringLiteral("welcomePage"));
  setAccessibleName(tr("Welcome"));
  auto* layout = new QVBoxLayout(this);
  layout->addStretch(2);
  mark_ = new QLabel;
  mark_->setAlignment(Qt::AlignCenter);
  layout->addWidget(mark_);
  drawMark();
  auto* title = new QLabel(tr("Configure a machine, run it, and see it in sync"));
  title->setAlignment(Qt::AlignCenter);
  auto font = title->font();
  font.setPointSizeF(font.pointSizeF() * 1.35);
  font.setWeight(QFont::DemiBold);
  title->setFont(font);
  layout->addWidget(title);
  auto* hint = new QLabel(
      tr("Begin with the simulated demonstration machine, a bus, devices of the catalogue, or a project file."));
  hint->setAlignment(Qt::AlignCenter);
  hint->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(hint);
  layout->addSpacing(14);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addStretch(1);
  for (auto* action : beginnings) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setObjectName(QStringLiteral("welcome_") + action->objectName());
    button->setAccessibleName(action->toolTip());
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(QSize(32, 32));
    button->setMinimumSize(124, 76);
    button->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(button);
  }
  row->addStretch(1);
  layout->addLayout(row);
  layout->addSpacing(18);
  recent_ = new QWidget;
  recent_->setObjectName(QStringLiteral("welcomeRecent"));
  recent_->setLayout(new QVBoxLayout);
  recent_->layout()->setContentsMargins(0, 0, 0, 0);
  recent_->layout()->setSpacing(2);
  recent_->setFixedWidth(kRecentWidth);
  layout->addWidget(recent_, 0, Qt::AlignHCenter);
  layout->addStretch(3);
  connect(&memory_, &WindowMemory::recentChanged, this, &WelcomePage::showRecent, Qt::QueuedConnection);
  showRecent();
}

void WelcomePage::showRecent() {
  while (auto* item = recent_->layout()->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const auto& recent = memory_.recent();
  recent_->setVisible(!recent.isEmpty());
  for (int row = 0; row < std::min<int>(static_cast<int>(recent.size()), kMostShown); ++row)
    recent_->layout()->addWidget(makeRecent(row, recent[row].path, recent[row].pinned));
}

/// A project and its pin.
QWidget* WelcomePage::makeRecent(int row, const QString& path, bool pinned) {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  const QFileInfo file(path);
  auto* open = new QToolButton;
  open->setObjectName(QStringLiteral("recentOpen%1").arg(row));
  open->setAutoRaise(true);
  open->setFocusPolicy(Qt::StrongFocus);
  open->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  const auto shown = QStringLiteral("%1  \u2013  %2").arg(file.fileName(), file.path());
  open->setText(
      open->fontMetrics().elidedText(shown, Qt::ElideMiddle, kRecentWidth - 60).replace(u'&', QStringLiteral("&&")));
  open->setAccessibleName(tr("Open %1").arg(path));
  open->setToolTip(path);
  open->setEnabled(file.exists());
  connect(open, &QToolButton::clicked, this, [this, path] { Q_EMIT fileWanted(path); });
  auto* pin = new QToolButton;
  pin->setObjectName(QStringLiteral("recentPin%1").arg(row));
  pin->setAutoRaise(true);
  pin->setFocusPolicy(Qt::StrongFocus);
  pin->setCheckable(true);
  pin->setChecked(pinned);
  pin->setText(pinned ? QStringLiteral("\u2605") : QStringLiteral("\u2606"));
  pin->setAccessibleName(tr("Pin %1").arg(path));
  pin->setToolTip(pinned ? tr("Stays in the list") : tr("Keep it in the list"));
  connect(pin, &QToolButton::clicked, &memory_, [this, path](bool on) { memory_.pin(path, on); });
  layout->addWidget(open, 1);
  layout->addWidget(pin);
  return area;
}

void WelcomePage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) drawMark();
}

void WelcomePage::drawMark() { mark_->setPixmap(QIcon(QStringLiteral(":/icons/syncline.svg")).pixmap(72, 72)); }

}  // namespace syncline::ui
