// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "ui/plots/slave_slots.h"
#include "ui/plots/trace_panel.h"

namespace syncline::ui {

/// A plot in which a few of many slaves have a curve of their own: the worst ones and the one the user picked.
class WorstSlavesPanel : public TracePanel {
  Q_OBJECT

 public:
  WorstSlavesPanel(const QString& title, const TracePlot::Options& options, std::size_t shown, TimeView* view,
                   CursorSet* cursors, QWidget* parent);
  [[nodiscard]] const std::vector<SlaveSlots::Slot>& worst() const { return slots_.slots(); }
  [[nodiscard]] int slavesShown() const override { return static_cast<int>(slots_.count()); }
  void setSlavesShown(int count) override;

 protected:
  /// Once, when the curves that lie below those of the slaves are there.
  void addCurves(SeriesItem::Shape shape);
  /// Of the slave with that place in worst().
  [[nodiscard]] SeriesItem& curve(std::size_t place) const { return *curves_[place]; }
  /// Draws `signal` of the slaves with the highest scores; `scores` by slave, negative: has no data. False: they are
  /// the same as before.
  bool chooseWorst(const std::vector<double>& scores, Signal signal);
  /// Draws no slave until the next choice; the places are those of others then.
  void forgetWorst();
  void colorWorst();
  /// No slave is drawn any more; nothing to do by default.
  virtual void cleared() {}
  static void hideAll(const std::vector<SeriesItem*>& items);

 private:
  std::vector<SeriesItem*> curves_;
  SlaveSlots slots_;
};

}  // namespace syncline::ui
