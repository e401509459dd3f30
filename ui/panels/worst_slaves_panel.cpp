// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/worst_slaves_panel.h"

#include "ui/plots/plot_colors.h"

namespace syncline::ui {

WorstSlavesPanel::WorstSlavesPanel(const QString& title, const TracePlot::Options& options, std::size_t shown,
                                   TimeView* view, CursorSet* cursors, QWidget* parent)
    : TracePanel(title, options, view, cursors, parent), slots_(shown) {}

void WorstSlavesPanel::addCurves(SeriesItem::Shape shape) {
  for (int i = 0; i < kMostSlaves; ++i) curves_.push_back(plot()->addItem({}, shape));
  hideAll(curves_);
}

void WorstSlavesPanel::hideAll(const std::vector<SeriesItem*>& items) {
  for (auto* item : items) {
    item->setSeries(nullptr);
    item->setVisible(false);
  }
}

bool WorstSlavesPanel::chooseWorst(const std::vector<double>& scores, Signal signal) {
  if (!slots_.update(scores, pickedSlave())) return false;
  hideAll(curves_);
  for (std::size_t i = 0; i < worst().size(); ++i) {
    const int slave = worst()[i].slave;
    draw(curve(i), signal, static_cast<std::size_t>(slave));
    curve(i).setTitle(slaveName(slave));
    curve(i).setVisible(true);
  }
  return true;
}

void WorstSlavesPanel::forgetWorst() {
  slots_.clear();
  hideAll(curves_);
}

void WorstSlavesPanel::setSlavesShown(int count) {
  forgetWorst();
  slots_.setCount(static_cast<std::size_t>(count));
  cleared();
  plot()->markDirty();
  refreshText(true);
}

void WorstSlavesPanel::colorWorst() {
  for (std::size_t i = 0; i < worst().size(); ++i) {
    curve(i).setColor(plot_colors::trace(palette(), worst()[i].color));
  }
}

}  // namespace syncline::ui
