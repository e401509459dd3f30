// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "record/run_record.h"
#include "ui/panels/worst_slaves_panel.h"

namespace syncline::ui {

class CursorSet;

/// Wire-ored 0x092C of every cycle (an upper estimate of the largest deviation: magnitudes are ored, not
/// compared) and the signed readings of the worst slaves, with the sync window.
class DeviationPanel final : public WorstSlavesPanel {
  Q_OBJECT

 public:
  DeviationPanel(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  [[nodiscard]] std::optional<Signal> limitSignal() const override { return Signal::kDeviation; }

 protected:
  void attach() override;
  void attachOverlay() override;
  void choose() override;
  void colorItems() override;
  [[nodiscard]] std::vector<LegendBar::Entry> entries(Nanoseconds time) const override;
  [[nodiscard]] QString summary(Nanoseconds time) const override;
  [[nodiscard]] const SeriesItem* primary() const override { return largest_; }
  [[nodiscard]] const SeriesItem* primaryOfOverlay() const override { return other_; }
  [[nodiscard]] QString valueText(double value) const override;
  [[nodiscard]] QString spreadText(double half) const override;
  [[nodiscard]] QString unitText(const SeriesItem& item) const override;

 private:
  [[nodiscard]] QString largestText(double value) const;

  SeriesItem* largest_;
  SeriesItem* other_;  // of the overlay
};

/// Counters of missed SM2 events of the slaves that have one, as steps, and their rate.
class Sm2Panel final : public WorstSlavesPanel {
  Q_OBJECT

 public:
  Sm2Panel(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);

 protected:
  void attach() override;
  void attachOverlay() override;
  void choose() override;
  void cleared() override { hideAll(others_); }
  void colorItems() override;
  [[nodiscard]] std::vector<LegendBar::Entry> entries(Nanoseconds time) const override;
  [[nodiscard]] QString summary(Nanoseconds time) const override;
  [[nodiscard]] const SeriesItem* primary() const override;
  [[nodiscard]] QString valueText(double value) const override;

 private:
  /// Events a second of one slave over the stretch that is shown.
  [[nodiscard]] double rate(const MinMaxSeries& series, Nanoseconds until) const;

  std::vector<SeriesItem*> others_;  // of the overlay, the same slaves
};

/// Error of the DCM controller: every cycle as an envelope, filtered as a line, and the drift.
class DcmPanel final : public TracePanel {
  Q_OBJECT

 public:
  DcmPanel(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  [[nodiscard]] std::optional<Signal> limitSignal() const override { return Signal::kDcmErrorFiltered; }

 protected:
  void attach() override;
  void renew() override;
  void attachOverlay() override;
  void colorItems() override;
  [[nodiscard]] std::vector<LegendBar::Entry> entries(Nanoseconds time) const override;
  [[nodiscard]] QString summary(Nanoseconds time) const override;
  [[nodiscard]] const SeriesItem* primary() const override { return raw_; }
  [[nodiscard]] const SeriesItem* primaryOfOverlay() const override { return other_; }
  [[nodiscard]] QString valueText(double value) const override;
  [[nodiscard]] QString spreadText(double half) const override;
  [[nodiscard]] QString unitText(const SeriesItem& item) const override;
  [[nodiscard]] QString remark(Nanoseconds begin, Nanoseconds end) const override;

 private:
  void showLimit();

  SeriesItem *raw_, *filtered_, *other_;
  RunLimits limits_;  // those that are drawn
};

}  // namespace syncline::ui
