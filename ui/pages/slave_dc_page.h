// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "ui/editors/page.h"

class QLabel;

namespace syncline {
struct Sm2MissedStatus;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class Card;
class DcReadBack;
class Pill;
class SyncUnitEditor;
class TimingDiagram;

/// Distributed clocks of a slave: operation mode, Sync Unit Cycles and shifts, the registers that
/// follow from them, one cycle of it to scale, and what the slave measures.
class SlaveDcPage final : public Page {
  Q_OBJECT

 public:
  explicit SlaveDcPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override;
  [[nodiscard]] PagePurpose purpose() const override { return PagePurpose::kBoth; }
  void refresh() override;
  void showLive(const Snapshot& snapshot) override;

 private:
  void buildMode(Card& card);
  void buildRegisters(Card& card);
  void buildLive(Card& card);
  void buildTiming(Card& card);
  void refreshRegisters();
  void refreshTiming();
  [[nodiscard]] static QString missedText(const Sm2MissedStatus& missed);
  void showRegister(QLabel& label, const QString& compiled, const std::optional<QString>& read);

  QLabel *description_, *assign_activate_, *bus_cycle_;
  QList<Card*> units_;
  SyncUnitEditor *sync0_, *sync1_;
  QLabel *register_activation_, *register_cycle0_, *register_cycle1_, *register_shift_;
  DcReadBack* read_back_;
  TimingDiagram* timing_;
  QLabel *margin_, *compute_;
  Pill* role_;
  QLabel *deviation_, *delay_, *missed_;
};

}  // namespace syncline::ui
