// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// What of its process data a device leaves open beside the PDOs: oversampling, Sync Units.
class SlaveDataPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveDataPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}
};

}  // namespace syncline::ui
