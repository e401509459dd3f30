// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QTableWidget>

namespace syncline {
struct CycleTimeHelp;
}

namespace syncline::ui {

/// Which bus cycles the slaves accept, and who refuses the others and why; Enter or a double click takes one.
class CycleTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit CycleTable(QWidget* parent = nullptr);
  /// The project's own cycle is bold, and marked when no row was.
  void showHelp(const CycleTimeHelp& help);
  /// Nothing is known of the project as it is.
  void clearHelp() { setRowCount(0); }
  /// Of the marked row; 0: none.
  [[nodiscard]] qint64 markedCycle() const;

 Q_SIGNALS:
  /// ns
  void cycleTaken(qint64 cycle);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitRowHeights();
};

/// "250 µs to 4 ms, in steps of 250 µs"
[[nodiscard]] QString acceptedCycles(const CycleTimeHelp& help);

}  // namespace syncline::ui
