// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace syncline {
class FaultLog;
struct Finding;
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

/// What went wrong first, an episode at a time: the newest one, until the user looks at another.
class FaultBanner final : public QFrame {
  Q_OBJECT

 public:
  explicit FaultBanner(QWidget* parent = nullptr);
  /// Behind the text.
  void addButton(QWidget* button);
  void show(const RunRecord& record, std::span<const Finding> findings);
  void showNothing(const QString& text);
  /// As rich text.
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  /// A moment of the run (host clock, ns) was clicked.
  void momentWanted(qint64 moment);
  /// Another episode is to be shown.
  void turned();

 protected:
  bool event(QEvent* event) override;

 private:
  void turn(int by);
  /// The episode that is shown, in the log; its number from the first one on stays whatever is forgotten.
  [[nodiscard]] std::size_t place(const FaultLog& log);
  void setText(const QString& text);

  QLabel* text_;
  QToolButton *earlier_, *later_;
  QHBoxLayout* row_;
  std::uint64_t shown_ = 0, count_ = 0;  // numbers of episodes, from 1; 0: none
  std::optional<std::uint64_t> chosen_;  // nothing: the newest
};

}  // namespace syncline::ui
