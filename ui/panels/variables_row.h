// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "ui/plots/trace_panel.h"

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CursorSet;

/// Variables of the process image that are alike, each cycle of them, over one value axis.
class VariablePanel final : public TracePanel {
  Q_OBJECT

 public:
  VariablePanel(int number, TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);

  /// Which of the record's variables, by their numbers, and what they are called together.
  void setVariables(const QString& title, std::vector<std::size_t> variables);
  [[nodiscard]] const std::vector<std::size_t>& variables() const { return variables_; }

 protected:
  void attach() override;
  void colorItems() override;
  [[nodiscard]] std::vector<LegendBar::Entry> entries(Nanoseconds time) const override;
  [[nodiscard]] QString summary(Nanoseconds time) const override;
  [[nodiscard]] const SeriesItem* primary() const override;
  [[nodiscard]] QString valueText(double value) const override;
  [[nodiscard]] QString spreadText(double half) const override;

 private:
  std::vector<SeriesItem*> items_;  // as many as can be watched
  std::vector<std::size_t> variables_;
};

/// The plots of what is watched, a row below those of the clocks: entries of the same name and type share a plot,
/// switches (one bit) do, and what there is no plot for shares the last one. Hidden while nothing is watched.
class VariablesRow final : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kMostPlots = 4;

  VariablesRow(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);

  /// Of a recording all variables are shown that were ever watched, of a run those that are.
  void setRecord(const RunRecord* record, bool recorded);
  /// Hidden as long as that.
  void setFolded(bool folded);
  /// Looks whether others are watched; as often as one likes.
  void follow();
  [[nodiscard]] const std::array<VariablePanel*, kMostPlots>& panels() const { return panels_; }

 Q_SIGNALS:
  /// Others are shown, or none any more.
  void changed();

 private:
  struct Group {
    QString title;
    std::vector<std::size_t> variables;
    bool mixed = false;  // not all alike
  };
  [[nodiscard]] std::vector<Group> groups() const;

  std::array<VariablePanel*, kMostPlots> panels_{};
  const RunRecord* record_ = nullptr;
  bool recorded_ = false;
  bool shown_ = false;  // there are variables
  bool folded_ = false;
  std::size_t lists_ = 0;  // that were looked at
};

}  // namespace syncline::ui
