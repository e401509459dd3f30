// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ui/editors/page.h"

namespace syncline {
struct Finding;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class MachineDraft;

/// A step of the wizard: a page for the master of the draft, with fields as everywhere.
class WizardStep : public Page {
  Q_OBJECT

 public:
  /// `explanation`: what is decided here, a sentence or two.
  WizardStep(MachineDraft& draft, const char* object_name, const QString& title, const QString& explanation);

  [[nodiscard]] const QString& explanation() const { return explanation_; }
  /// Why the wizard cannot go on from here, a sentence; empty: it can.
  [[nodiscard]] virtual QString whyNotOn() const { return {}; }
  /// Shows the draft as it is now, with what the compiler finds wrong beside the fields.
  void showDraft(const std::vector<Finding>& findings);
  /// Enter in it is its own and does not lead on.
  [[nodiscard]] virtual bool keepsEnter() const { return false; }
  /// Where the keyboard begins.
  [[nodiscard]] virtual QWidget* firstField() const = 0;

  [[nodiscard]] bool appliesTo(int) const override { return true; }
  void showLive(const Snapshot&) override {}

 protected:
  [[nodiscard]] MachineDraft& draft() const { return draft_; }

 private:
  MachineDraft& draft_;
  QString explanation_;
};

}  // namespace syncline::ui
