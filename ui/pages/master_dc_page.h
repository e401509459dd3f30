// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "ui/editors/page.h"

class QButtonGroup;
class QCheckBox;
class QLabel;

namespace syncline {
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class Card;
class ChoiceEdit;
class NumberEdit;
class Pill;
class SyncWindowFields;

/// Distributed clocks of the master: who leads, who follows, and within which limit.
class MasterDcPage final : public Page {
  Q_OBJECT

 public:
  explicit MasterDcPage(Workspace& workspace);
  ~MasterDcPage() override;
  [[nodiscard]] bool appliesTo(int slave) const override;
  [[nodiscard]] PagePurpose purpose() const override { return PagePurpose::kBoth; }
  void refresh() override;
  void showLive(const Snapshot& snapshot) override;

 private:
  void buildClocks(Card& card);
  void buildShift(Card& card);
  void buildLive(Card& slaves, Card& master);

  ChoiceEdit* reference_;
  QCheckBox *wide_time_, *set_value_auto_;
  QButtonGroup* mode_;
  NumberEdit *set_value_, *dcm_limit_, *dcm_settle_;
  std::unique_ptr<SyncWindowFields> window_;
  Pill *dc_state_, *dcm_state_;
  QLabel *deviation_, *reading_, *settled_, *leader_;
  QLabel *error_, *error_statistics_, *frame_error_, *drift_, *external_, *locked_after_;
  Card* master_;  // live
};

}  // namespace syncline::ui
