// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QPointer>

#include "ui/plots/trace_panel.h"

namespace syncline::ui {

class LimitFields;

/// Limits of the value axes of a plot, automatic or typed.
class LimitsDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit LimitsDialog(TracePanel& panel, QWidget* parent = nullptr);
  void accept() override;

 private:
  [[nodiscard]] static LimitFields* addAxis(const TracePanel& panel, TracePlot::Side side, const QString& name,
                                            const QString& spoken);

  QPointer<TracePanel> panel_;                      // a plot of the user's own may go meanwhile
  LimitFields *left_ = nullptr, *right_ = nullptr;  // null: nothing is shown on it
};

}  // namespace syncline::ui
