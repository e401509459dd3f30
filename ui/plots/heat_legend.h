// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

namespace syncline::ui {

/// What the colours of the heat map say: from nothing to the limit, over it, and no reading.
class HeatLegend final : public QWidget {
  Q_OBJECT

 public:
  explicit HeatLegend(QWidget* parent = nullptr);
  /// `full`: where the colours end, ns; `is_limit`: that is the limit.
  void setScale(double full, bool is_limit);
  /// What is written on it.
  [[nodiscard]] QString text() const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QString fullText() const;

  double full_ = 0;
  bool is_limit_ = false;
};

}  // namespace syncline::ui
