// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// What of distributed clocks few machines need: measurements, burst, start times, control loops, the controller.
class MasterDcExpertPage final : public Page {
  Q_OBJECT

 public:
  explicit MasterDcExpertPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}
};

}  // namespace syncline::ui
