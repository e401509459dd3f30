// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

class QCheckBox;
class QLineEdit;

namespace syncline {
struct AxisLimits;
}  // namespace syncline

namespace syncline::ui {

/// Limits of a value axis: automatic, or from and to as they are typed.
class LimitFields final : public QWidget {
  Q_OBJECT

 public:
  /// `name`: of the objects; `spoken`: which axis. `times`: ns, or with a unit behind the number.
  LimitFields(const QString& name, const QString& spoken, QWidget* parent = nullptr);
  void setTimes(bool times, const QString& unit);
  /// `shown`: what is proposed when they are to be fixed.
  void setLimits(const std::optional<AxisLimits>& limits, const AxisLimits& shown);
  [[nodiscard]] std::optional<AxisLimits> limits() const;
  /// What stands there are limits, or none are wanted.
  [[nodiscard]] bool isValid() const;

 Q_SIGNALS:
  void changed();

 private:
  void showState();

  QCheckBox* fixed_;
  QLineEdit *low_, *high_;
  bool times_ = false;
};

}  // namespace syncline::ui
