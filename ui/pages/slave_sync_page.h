// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class SyncSettingsEditor;

/// What starts a device's cycle and what it does when that is missed, with or without distributed clocks: its
/// synchronisation objects, the CAN cycle of a gateway, the output pins of a drive.
class SlaveSyncPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveSyncPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot&) override {}

 private:
  SyncSettingsEditor* sync_;
};

}  // namespace syncline::ui
