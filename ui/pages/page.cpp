// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/page.h"

#include "ui/session/workspace.h"

namespace syncline::ui {

Page::Page(Workspace& workspace, const char* object_name, const QString& title)
    : workspace_(workspace), title_(title) {
  setObjectName(QLatin1String(object_name));
  setAccessibleName(title);
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  viewport()->setAutoFillBackground(false);
}

void Page::setNode(int slave) {
  slave_ = slave;
  refresh();
  showLive(workspace_.live().snapshot());
}

void Page::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  showLive(workspace_.live().snapshot());
}

void Page::edit(const QString& text, const QString& key, const QString& value) { edit(text, QStringList{key, value}); }

void Page::edit(const QString& text, const QStringList& keys_and_values) {
  std::vector<SettingValue> settings;
  for (qsizetype i = 0; i + 1 < keys_and_values.size(); i += 2) {
    settings.push_back({keys_and_values[i].toStdString(), keys_and_values[i + 1].toStdString()});
  }
  if (auto status = workspace_.document().set(text, std::move(settings)); !status) {
    workspace_.report(status.error(), Severity::kWarning, tr("Project"));
    refresh();
  }
}

}  // namespace syncline::ui
