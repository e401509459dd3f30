// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/wizard_step.h"

#include "ui/editors/field_binder.h"
#include "ui/text/event_text.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {

WizardStep::WizardStep(MachineDraft& draft, const char* object_name, const QString& title, const QString& explanation)
    : Page(draft.workspace(), object_name, title), draft_(draft), explanation_(explanation) {}

void WizardStep::showDraft(const std::vector<Finding>& findings) {
  refresh();
  fields().showNotes(notesOf(findings, project()));
}

}  // namespace syncline::ui
