// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"
#include "ui/editors/page.h"

class QAction;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace syncline {
class ImageContents;
struct NetworkConfig;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

class VariableModel;

class Segments;
class ValueLabel;
class VariableFilter;

/// The process image by its variables, of the whole bus or of one slave: where they stand and, while the machine runs,
/// what is in them. Outputs can be forced, and each can be watched in the monitor.
class VariablesPage final : public Page {
  Q_OBJECT

 public:
  explicit VariablesPage(Workspace& workspace);

  [[nodiscard]] bool appliesTo(int slave) const override;
  [[nodiscard]] PagePurpose purpose() const override { return PagePurpose::kBoth; }
  void refresh() override;
  void showLive(const Snapshot& snapshot) override;
  [[nodiscard]] VariableModel& model() { return *model_; }

 private:
  QWidget* buildChoice();
  QWidget* buildForcing();
  /// That runs or, offline, that the project makes; null when it makes none.
  [[nodiscard]] const NetworkConfig* config() const;
  void showVariables();
  void showHint(const Snapshot& snapshot, const ImageContents* image);
  void showSelected();
  void enableForcing();
  void force();
  void release();
  void releaseAll();
  void showWatched();
  /// The selected one is watched by the monitor from now on, or no more.
  void watch(bool on);
  [[nodiscard]] int current() const;
  [[nodiscard]] std::optional<std::uint64_t> typed() const;

  VariableModel* model_;
  VariableFilter* filter_;
  Segments* kind_;
  QLineEdit *words_, *value_;
  QTableView* table_;
  ValueLabel *hint_, *selected_;
  QPushButton *force_, *release_, *release_all_, *watch_;
  QAction* watch_action_;
  Nanoseconds shown_ = 0;  // time of the image in the table
  bool allowed_ = false;   // the question was answered, for this run
  QString selected_name_;
};

}  // namespace syncline::ui
