// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/pages/page.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace syncline::ui {

class Card;
class Pill;
class TimeEdit;

/// Distributed clocks of the master: who leads, who follows, and within which limit.
class MasterDcPage final : public Page {
  Q_OBJECT

 public:
  explicit MasterDcPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  void refresh() override;
  void showLive(const Snapshot& snapshot) override;

 private:
  void buildClocks(Card& card);
  void buildShift(Card& card);
  void buildWindow(Card& card);
  void buildLive(Card& slaves, Card& master);
  void refreshReferenceClocks();
  QCheckBox* addSwitch(Card& card, const char* object_name, const QString& text, const char* key, const QString& tip);

  QComboBox* reference_;
  QCheckBox *enabled_, *wide_time_, *monitoring_, *set_value_auto_;
  QButtonGroup* mode_;
  TimeEdit* set_value_;
  QSpinBox *exponent_, *settle_, *dcm_limit_, *dcm_settle_;
  QLabel* limit_;
  Pill *dc_state_, *dcm_state_;
  QLabel *deviation_, *reading_, *settled_, *leader_;
  QLabel *error_, *error_statistics_, *frame_error_, *drift_, *locked_after_;
};

}  // namespace syncline::ui
