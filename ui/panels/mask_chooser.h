// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "trace/stability_mask.h"

class QComboBox;
class QLineEdit;

namespace syncline::ui {

/// What a figure of the stability is held against: the limit of the signal, a part of the cycle, or what the user
/// types.
class MaskChooser final : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { kLimit, kCycle, kOwn };
  /// LinuxCNC's default for how far its cycle may be away from the slaves': the cycle time divided by this.
  static constexpr double kPartOfCycle = 25;

  explicit MaskChooser(QWidget* parent = nullptr);
  void setKind(Kind kind);
  [[nodiscard]] Kind kind() const;
  void setOwn(const QString& text);
  /// Of the kind kOwn; empty where nothing was typed, or what nobody understands: problem() says what.
  [[nodiscard]] StabilityMask own(StabilityFigure figure) const;
  [[nodiscard]] QString problem(StabilityFigure figure) const;

 Q_SIGNALS:
  void changed();

 private:
  QComboBox* kind_;
  QLineEdit* own_;
};

}  // namespace syncline::ui
