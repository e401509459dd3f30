// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

class QLabel;
class QPushButton;

namespace syncline {
struct NetworkConfig;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class Card;
class Pill;

/// Name and cycle of the master, its state machine, and what the bus and the configuration are made of.
class MasterGeneralPage final : public Page {
  Q_OBJECT

 public:
  explicit MasterGeneralPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override { return slave < 0; }
  [[nodiscard]] PagePurpose purpose() const override { return PagePurpose::kBoth; }
  void refresh() override;
  void showLive(const Snapshot& snapshot) override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void showCost(const NetworkConfig* config);
  void buildSettings(Card& card);
  void buildRecovery(Card& card);
  void buildStateMachine(Card& card);
  void buildCounters(Card& card);

  Pill* state_;
  QLabel* requested_;
  QList<QPushButton*> state_buttons_;
  QLabel *slaves_, *dc_slaves_, *inputs_, *outputs_, *frame_;
  QLabel *found_, *cycles_, *lost_, *late_, *wkc_, *overruns_;
};

}  // namespace syncline::ui
