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

constexpr int kRecentWidth = 500, kMostShown = 6, kMostTemplates = 3;

QWidget* welcomeList(const char* object_name) {
  auto* area = new QWidget;
  area->setObjectName(QLatin1String(object_name));
  area->setLayout(new QVBoxLayout);
  area->layout()->setContentsMargins(0, 0, 0, 0);
  area->layout()->setSpacing(2);
  area->setFixedWidth(kRecentWidth);
  return area;
}

void emptyList(const QWidget& list) {
  while (auto* item = list.layout()->takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

}  // namespace

WelcomePage::WelcomePage(const QList<QAction*>& beginnings, WindowMemory& memory, TemplateStore& templates,
                         QWidget* parent)
    : QWidget(parent), memory_(memory), templates_(templates) {
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
  title->setWordWrap(true);
  layout->addWidget(title);
  auto* hint = new QLabel(
      tr("Begin with the simulated demonstration machine, a bus, devices of the catalogue, or a project file."));
  hint->setAlignment(Qt::AlignCenter);
  hint->setWordWrap(true);  // also while another page is shown, the window is as wide as this one needs
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
    button->setMinimumSize(112, 76);
    button->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(button);
  }
  row->addStretch(1);
  layout->addLayout(row);
  layout->addSpacing(18);
  recent_ = welcomeList("welcomeRecent");
  layout->addWidget(recent_, 0, Qt::AlignHCenter);
  own_ = welcomeList("welcomeTemplates");
  layout->addWidget(own_, 0, Qt::AlignHCenter);
  layout->addStretch(3);
  connect(&memory_, &WindowMemory::recentChanged, this, &WelcomePage::showRecent, Qt::QueuedConnection);
  connect(&templates_, &TemplateStore::changed, this, &WelcomePage::showTemplates, Qt::QueuedConnection);
  showRecent();
  showTemplates();
}

void WelcomePage::showTemplates() {
  emptyList(*own_);
  const auto entries = templates_.entries();
  own_->setVisible(!entries.isEmpty());
  if (entries.isEmpty()) return;
  auto* title = new QLabel(tr("New from a template of yours"));
  title->setForegroundRole(QPalette::PlaceholderText);
  own_->layout()->addWidget(title);
  for (int row = 0; row < std::min<int>(static_cast<int>(entries.size()), kMostTemplates); ++row)
    own_->layout()->addWidget(makeTemplate(row, entries[row]));
  if (entries.size() > kMostTemplates) {
    auto* more = new QLabel(tr("%n more in New Machine", nullptr, static_cast<int>(entries.size()) - kMostTemplates));
    more->setForegroundRole(QPalette::PlaceholderText);
    own_->layout()->addWidget(more);
  }
}

QWidget* WelcomePage::makeTemplate(int row, const TemplateStore::Entry& entry) {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  auto* begin = new QToolButton;
  begin->setObjectName(QStringLiteral("templateBegin%1").arg(row));
  begin->setAutoRaise(true);
  begin->setFocusPolicy(Qt::StrongFocus);
  begin->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  begin->setText(begin->fontMetrics()
                     .elidedText(entry.name, Qt::ElideRight, kRecentWidth - 60)
                     .replace(u'&', QStringLiteral("&&")));
  begin->setAccessibleName(tr("New from the template %1").arg(entry.name));
  begin->setToolTip(entry.path);
  connect(begin, &QToolButton::clicked, this, [this, entry] { Q_EMIT templateWanted(entry); });
  auto* remove = new QToolButton;
  remove->setObjectName(QStringLiteral("templateRemove%1").arg(row));
  remove->setAutoRaise(true);
  remove->setFocusPolicy(Qt::StrongFocus);
  remove->setText(QStringLiteral("\u2715"));
  remove->setAccessibleName(tr("Remove the template %1").arg(entry.name));
  remove->setToolTip(tr("Remove this template"));
  connect(remove, &QToolButton::clicked, this, [this, entry] { Q_EMIT templateRemoveWanted(entry); });
  layout->addWidget(begin, 1);
  layout->addWidget(remove);
  return area;
}

void WelcomePage::showRecent() {
  emptyList(*recent_);
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
