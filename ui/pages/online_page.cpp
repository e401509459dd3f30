// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/online_page.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {

OnlinePage::OnlinePage(Workspace& workspace, const char* object_name, const QString& title)
    : Page(workspace, object_name, title), hint_(new QLabel) {
  hint_->setObjectName(QLatin1String(object_name) + QStringLiteral("Hint"));
  hint_->setWordWrap(true);
  hint_->setTextFormat(Qt::PlainText);
  hint_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  connect(&workspace.live(), &LiveSession::recordChanged, this, [this] {
    machineChanged();
    forget();
  });
  connect(&workspace.document(), &ProjectDocument::taken, this, [this] {
    machineChanged();
    stopAsking();
    shown_ = -1;  // alike as the slaves may be
  });
  // Also of a page that is hidden: what it waits for may be about a slave that is gone.
  connect(&workspace.document(), &ProjectDocument::projectChanged, this, [this] {
    if (node() >= 0 && !same()) forget();
  });
}

OnlinePage::~OnlinePage() { workspace().requests().drop(*this); }

QVBoxLayout* OnlinePage::build() {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(6);
  layout->addWidget(hint_);
  setWidget(content);
  return layout;
}

ValueLabel* OnlinePage::buildStatus(const char* object_name) {
  status_ = named(new ValueLabel, object_name, tr("What became of the last request"));
  status_->setMinimumWidth(60);
  return status_;
}

void OnlinePage::say(const QString& text, bool bad) {
  if (status_ == nullptr) return;
  status_->setText(text);
  auto colors = palette();
  if (bad) colors.setColor(QPalette::WindowText, theme::toneColor(colors, theme::Tone::kBad));
  status_->setPalette(colors);
}

const SlaveSettings* OnlinePage::settings() const {
  const auto at = static_cast<std::size_t>(node());
  return node() < 0 || at >= project().slaves.size() ? nullptr : &project().slaves[at];
}

int OnlinePage::position() const { return workspace().runningSlaves().positionOf(node()); }

bool OnlinePage::same() const {
  const auto* slave = settings();
  return slave != nullptr && shown_ == node() && station_ == slave->station_address &&
         identity_ == slave->device.identity;
}

void OnlinePage::refresh() {
  if (same()) return projectChanged();
  if (settings() != nullptr) forget();
}

void OnlinePage::stopAsking() {
  workspace().requests().drop(*this);
  ended();
}

void OnlinePage::forget() {
  stopAsking();
  say({});
  const auto* slave = settings();
  shown_ = slave == nullptr ? -1 : node();
  if (slave == nullptr) return;
  station_ = slave->station_address;
  identity_ = slave->device.identity;
  slaveChanged();
}

QString OnlinePage::obstacle() const {
  using Phase = LiveSession::Phase;
  if (!workspace().requests().possible()) {
    return tr("Offline. Go online (F5), in whatever state, to ask the slave itself.");
  }
  if (workspace().live().phase() == Phase::kStopping) return tr("The bus is going offline.");
  if (workspace().live().phase() == Phase::kSilent) return tr("The master does not answer.");
  const auto slave = running();
  if (!slave) return tr("The machine was started without this slave: restart it with the project as it is now.");
  if (slave->status == nullptr) return tr("The bus is starting.");
  if (!slave->present()) return tr("The slave does not answer: check its power and the cable in front of it.");
  return ownObstacle(*slave);
}

void OnlinePage::showLive(const Snapshot& snapshot) {
  if (settings() == nullptr) return;
  const auto why = obstacle();
  hint_->setText(why);
  hint_->setVisible(!why.isEmpty());
  possible_ = why.isEmpty();
  // The session's last snapshot is an empty one.
  tick(workspace().requests().possible() ? std::optional(snapshot.time) : std::nullopt);
}

SlaveRequests::Id OnlinePage::post(SlaveRequest request, SlaveRequests::Done done, RequestUrgency urgency) {
  return workspace().requests().post(std::move(request), *this, std::move(done), urgency);
}

bool OnlinePage::speaksCoe(int slave) const {
  const auto at = static_cast<std::size_t>(slave);
  if (slave < 0 || at >= project().slaves.size()) return false;
  const auto& mailbox = project().slaves[at].device.mailbox;
  return mailbox && mailbox->coe;
}

bool OnlinePage::mayDisturb(const QString& what, const QString& more, const QString& on) {
  const auto slave = running();
  if (!slave) return false;
  if (!slave->drives()) return true;
  const auto text = tr("%1 is in %2. %3").arg(nodeName(project(), node()), stateName(slave->state()), what);
  return ask(*window(), "disturbQuestion", text, more, on) && running().has_value();
}

}  // namespace syncline::ui
