// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/page.h"

class QLabel;

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class Card;
class Pill;

/// Identity, addresses, checks and time-outs of a slave, and the state it is in.
class SlaveGeneralPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveGeneralPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override { return slave >= 0; }
  [[nodiscard]] PagePurpose purpose() const override { return PagePurpose::kBoth; }
  void refresh() override;
  void showLive(const Snapshot& snapshot) override;

 private:
  void buildIdentity(Card& card);
  void buildAddresses(Card& card);
  void buildPlace(Card& card);
  void buildState(Card& card);
  void buildTimeouts(Card& card);

  QLabel *type_, *vendor_, *product_, *revision_, *serial_, *source_;
  QLabel *auto_increment_, *previous_;
  QLabel *status_code_, *meaning_, *preop_, *safeop_op_, *to_init_, *to_safeop_;
  Pill* state_;
};

}  // namespace syncline::ui
