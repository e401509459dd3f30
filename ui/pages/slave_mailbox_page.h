// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// Mailbox of a slave, and what its Ethernet (EoE) and ADS (AoE) protocols get at start-up.
class SlaveMailboxPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveMailboxPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}
};

}  // namespace syncline::ui
