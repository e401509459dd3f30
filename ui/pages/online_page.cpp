// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/online_page.h"

#include <QLabel>
#include <utility>

#include "ui/dialogs/questions.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"

namespace syncline::ui {

OnlinePage::OnlinePage(Workspace& workspace, const char* object_name, const QString& title)
    : Page(workspace, object_name, title), hint_(new QLabel) {
  hint_->setObjectName(QLatin1String(object_name) + QStringLiteral("Hint"));
  hint_->setWordWrap(true);
  hint_->setTextFormat(Qt::PlainText);
  hint_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  connect(&workspace.live(), &LiveSession::recordChanged, this, &OnlinePage::forget);
}

OnlinePage::~OnlinePage() { workspace().requests().drop(*this); }

const SlaveSettings* OnlinePage::settings() const {
  const auto at = static_cast<std::size_t>(node());
  return node() < 0 || at >= project().slaves.size() ? nullptr : &project().slaves[at];
}

void OnlinePage::refresh() {
  const auto* slave = settings();
  if (slave == nullptr) return;
  if (shown_ == node() && station_ == slave->station_address && identity_ == slave->device.identity) {
    return projectChanged();
  }
  shown_ = node();
  station_ = slave->station_address;
  identity_ = slave->device.identity;
  forget();
}

void OnlinePage::forget() {
  workspace().requests().drop(*this);
  if (settings() != nullptr) slaveChanged();
}

QString OnlinePage::obstacle() const {
  using Phase = LiveSession::Phase;
  if (!workspace().requests().possible()) {
    return tr("Offline. Go online (F5), in whatever state, to ask the slave itself.");
  }
  if (workspace().live().phase() == Phase::kStopping) return tr("The bus is going offline.");
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
  tick(snapshot, why);
}

void OnlinePage::post(SlaveRequest request, SlaveRequests::Done done, RequestUrgency urgency) {
  workspace().requests().post(std::move(request), *this, std::move(done), urgency);
}

bool OnlinePage::mayDisturb(const QString& what, const QString& more, const QString& on) {
  const auto slave = running();
  if (!slave) return false;
  if (!slave->drives()) return true;
  const auto text = tr("%1 is in %2. %3").arg(nodeName(project(), node()), stateName(slave->state()), what);
  return ask(*window(), "disturbQuestion", text, more, on) && running().has_value();
}

}  // namespace syncline::ui
