// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/page.h"

#include "ui/editors/field_binder.h"
#include "ui/session/workspace.h"
#include "ui/text/finding_text.h"

namespace syncline::ui {

Page::Page(Workspace& workspace, const char* object_name, const QString& title)
    : workspace_(workspace), fields_(new FieldBinder(*this)), title_(title) {
  setObjectName(QLatin1String(object_name));
  setAccessibleName(title);
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  viewport()->setAutoFillBackground(false);
}

void Page::setNode(int slave) {
  // What was typed belongs to the node that was shown.
  if (slave != slave_ && !fields_->commit()) fields_->revert();
  slave_ = slave;
  refresh();
  showLive(workspace_.live().snapshot());
}

void Page::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  showLive(workspace_.live().snapshot());
}

const Project& Page::project() const { return workspace_.document().project(); }

bool Page::expert() const { return workspace_.expert(); }

QString Page::set(const QString& text, std::vector<SettingEdit> edits) {
  const auto status = workspace_.document().set(text, std::move(edits));
  const auto refused = status ? std::nullopt : std::optional(status.error());
  // Offered once more as it is, by Enter or by undo, it is not told once more.
  const bool told = refused && refused_ && refused->subject == refused_->subject && refused->detail == refused_->detail;
  refused_ = refused;
  if (!refused) return {};
  if (!told) workspace_.report(status.error(), Severity::kWarning, tr("Project"));
  refresh();
  return reasonText(status.error().detail);
}

}  // namespace syncline::ui
