// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "trace/slave_cells.h"
#include "ui/plots/event_marks_item.h"
#include "ui/plots/heat_scale.h"

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CursorSet;
class TimeView;

/// Deviations of all slaves as a heat map, one row a slave, over the time that the plots show (trace/slave_cells.h says
/// what a cell shows). What has no reading is hatched. Where rows are lower than a pixel, neighbours share a line and
/// the worst of them is seen. Events stand at the foot, as in the plots; those of a slave that is shown in its row,
/// too.
class HeatMapPlot final : public QWidget {
  Q_OBJECT

 public:
  struct Row {
    std::size_t slave = 0;
    QString name;
    bool is_reference = false;
    bool operator==(const Row&) const = default;
  };
  /// A slave at a time.
  struct Spot {
    std::size_t slave = 0;
    Nanoseconds time = 0;
    std::size_t column = 0;
  };

  HeatMapPlot(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  /// Null: nothing. It must outlive the plot or be replaced.
  void setRecord(const RunRecord* record);
  /// By time; they must outlive the plot or be replaced.
  void setMarks(const std::vector<EventMark>* marks) { marks_.setMarks(marks); }
  /// From top to bottom.
  void setRows(std::vector<Row> rows);
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  /// The slave whose row is marked; -1: none.
  void setSelected(int slave);
  [[nodiscard]] int selected() const { return selected_; }
  void markDirty() { dirty_ = true; }
  /// The worst moment of the marked slave is to be shown.
  void activateSelected();
  /// Makes the cells that are new and draws them, when something changed.
  void refresh();

  [[nodiscard]] const SlaveCells& cells() const { return cells_; }
  /// Where the colours end, ns: the limit, or without one a round number above all that is shown.
  [[nodiscard]] double full() const { return full_; }
  /// Where the cells are drawn.
  [[nodiscard]] QRectF area() const;
  /// Where the events are drawn: below the cells.
  [[nodiscard]] QRectF eventsArea() const;
  /// The worst slave of the line and its cell under a point; of reference clocks none.
  [[nodiscard]] std::optional<Spot> spotAt(const QPointF& pixel) const;
  /// The pixel in the middle of a cell.
  [[nodiscard]] QPointF placeOf(std::size_t slave, std::size_t column) const;
  /// An event as it is drawn: at the foot with all others, or in its slave's row with the slave's own.
  struct MarkSpot {
    EventMark mark;
    bool is_in_row = false;
  };
  [[nodiscard]] std::optional<MarkSpot> markAt(const QPointF& pixel) const;
  /// What one column of pixels shows of events is one mark.
  [[nodiscard]] Nanoseconds columnWidth() const { return cells_.grid().width; }
  /// The moment of the largest reading in the cell; the middle of the cell, where none lies in it.
  [[nodiscard]] Nanoseconds momentOf(std::size_t slave, std::size_t column) const;
  [[nodiscard]] const std::optional<Spot>& pointed() const { return pointed_; }
  [[nodiscard]] const std::optional<MarkSpot>& pointedMark() const { return pointed_mark_; }
  [[nodiscard]] QSize sizeHint() const override { return {420, 150}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 80}; }

 Q_SIGNALS:
  void pointedChanged();
  /// By a click or a key.
  void slaveSelected(int slave);
  void eventClicked(syncline::Nanoseconds time);
  /// A moment of a slave is to be shown.
  void momentActivated(int slave, syncline::Nanoseconds time);
  void menuRequested(const QPoint& global, syncline::Nanoseconds time);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void measureNames();
  [[nodiscard]] int namesWidth() const;
  [[nodiscard]] double rowHeight() const;
  [[nodiscard]] QRectF rowArea(std::size_t row) const;
  /// Whole pixels of the widget around those of the image.
  [[nodiscard]] QRectF pixelsOf(const QRect& part) const;
  /// Of the slave; -1: it has none.
  [[nodiscard]] std::ptrdiff_t rowOf(int slave) const;
  [[nodiscard]] Nanoseconds timeAt(double x) const;
  [[nodiscard]] ColumnGrid grid() const;
  void makeImage();
  void drawLine(std::size_t line, std::size_t begin, std::size_t end);
  void findMissing();
  void drawRows(QPainter& painter) const;
  void drawNames(QPainter& painter) const;
  void drawTimes(QPainter& painter) const;
  void drawSelection(QPainter& painter) const;
  void drawEvents(QPainter& painter, const QwtScaleMap& x);
  void updateTheme();
  void point(const std::optional<QPointF>& place);
  void step(int by);
  void activate(std::size_t slave, std::size_t column);

  TimeView* view_;
  CursorSet* cursors_;
  HeatScale scale_;
  EventMarksItem marks_;
  const RunRecord* record_ = nullptr;
  std::vector<Row> rows_;
  SlaveCells cells_;
  QImage image_;
  double drawn_full_ = 0;  // with which the image was made; 0: it has to be made anew
  QRect missing_;          // around the pixels of the image without a reading; reference clocks are not asked
  std::vector<float> worst_;
  double full_ = 1;
  int widest_name_ = 20;  // measured once: asked for by every row
  int selected_ = -1;
  bool dirty_ = true, dragged_ = false;
  std::optional<double> drag_x_;
  std::optional<QPointF> pointer_;
  std::optional<Spot> pointed_;
  std::optional<MarkSpot> pointed_mark_;
};

}  // namespace syncline::ui
