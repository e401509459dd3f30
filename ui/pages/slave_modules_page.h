// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// What is plugged into the slots of a modular device.
class SlaveModulesPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveModulesPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}
};

}  // namespace syncline::ui
