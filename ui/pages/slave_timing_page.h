// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// Watchdogs of a slave and the times that it is given to change its state and to answer.
class SlaveTimingPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveTimingPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}
};

}  // namespace syncline::ui
