// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/topology_view.h"

#include <QApplication>
#include <QHelpEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "config/device_description.h"
#include "config/project.h"
#include "config/slave_edits.h"
#include "ui/models/cable_counters.h"
#include "ui/models/network_model.h"
#include "ui/panels/cable_tip.h"
#include "ui/panels/topology_paint.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr double kBoxWidth = 168, kBoxHeight = 44, kColumn = 212, kRow = 66, kEdge = 14;
constexpr double kReach = 14;  // around a port
constexpr double kNearCable = 5, kBadgeBeside = 10;
constexpr double kSmallest = 0.3, kLargest = 2;

/// Only the network in work is drawn.
int slaveOf(const QModelIndex& index) {
  const bool drawn = index.isValid() && !index.data(NetworkModel::kOtherRole).toBool();
  return drawn ? index.data(NetworkModel::kSlaveRole).toInt() : -1;
}

double distanceOf(const QPointF& point, const QLineF& line) {
  const auto along = line.p2() - line.p1();
  const double length = QPointF::dotProduct(along, along);
  const double part = length > 0 ? std::clamp(QPointF::dotProduct(point - line.p1(), along) / length, 0.0, 1.0) : 0.0;
  return QLineF(line.p1() + part * along, point).length();
}

}  // namespace

TopologyView::TopologyView(NetworkModel& model, const CableCounters& cables, QWidget* parent)
    : QAbstractItemView(parent), network_(model), cables_(cables) {
  setModel(&model);
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(SingleSelection);
  setEditTriggers(NoEditTriggers);
  setDragDropMode(DropOnly);
  viewport()->setMouseTracking(true);
  viewport()->setAcceptDrops(true);
  connect(&cables, &CableCounters::changed, this, [this] { viewport()->update(); });
}

void TopologyView::setProject(const Project& project) {
  project_ = &project;
  layout_ = layoutOf(WiringTree::of(project.slaves));
  endDrag();
  updateGeometries();
  viewport()->update();
}

/// A cable in the hand is let go of.
void TopologyView::setEditable(bool editable) {
  editable_ = editable;
  if (!editable) endDrag();
}

void TopologyView::setZoom(double zoom) {
  zoom_ = std::clamp(zoom, kSmallest, kLargest);
  updateGeometries();
  scrollTo(currentIndex());
  viewport()->update();
  Q_EMIT zoomChanged(zoom_);
}

QRectF TopologyView::boxOf(int slave) const {
  if (slave < 0 || slave >= static_cast<int>(layout_.slaves.size())) return {kEdge, kEdge, kBoxWidth, kBoxHeight};
  const auto& place = layout_.slaves[static_cast<std::size_t>(slave)];
  return {kEdge + place.column * kColumn, kEdge + place.row * kRow, kBoxWidth, kBoxHeight};
}

/// The line comes in above and goes on below; branches begin at the right and come in from the left.
QPointF TopologyView::anchorOf(int slave, int port) const {
  const auto box = boxOf(slave);
  if (slave < 0) return {box.center().x(), box.bottom()};
  const auto& place = layout_.slaves[static_cast<std::size_t>(slave)];
  const auto kind = place.ports[static_cast<std::size_t>(port)];
  if (kind == TopologyPlace::Port::kEntry)
    return place.previous && !place.goes_on ? QPointF(box.left(), box.center().y())
                                            : QPointF(box.center().x(), box.top());
  if (kind == TopologyPlace::Port::kWayOn) return {box.center().x(), box.bottom()};
  // Free ports beside the way on stand below, where the line would go on, as long as nobody does.
  int at = 0, count = 0;
  bool below = place.next < 0;
  for (int other = 1; other <= 4; ++other) {
    const int one = other % 4;
    const auto state = place.ports[static_cast<std::size_t>(one)];
    if (state != TopologyPlace::Port::kFree && state != TopologyPlace::Port::kBranch) continue;
    if (below && state == TopologyPlace::Port::kFree) {
      below = false;
      if (one == port) return {box.center().x(), box.bottom()};
      continue;
    }
    if (one == port) at = count;
    ++count;
  }
  return {box.right(), box.top() + kBoxHeight * (at + 1) / (count + 1)};
}

/// A slave that hangs at nobody though others stand before it: nobody knows its cable.
QPolygonF TopologyView::cableOf(int slave) const {
  const auto& place = layout_.slaves[static_cast<std::size_t>(slave)];
  if (!place.previous && slave > 0) return {};
  const auto own = std::ranges::find(place.ports, TopologyPlace::Port::kEntry) - place.ports.begin();
  const auto end = anchorOf(slave, static_cast<int>(own));
  const auto begin = place.previous ? anchorOf(place.previous->position, place.previous->port) : anchorOf(-1, 0);
  const double middle = place.goes_on || !place.previous ? begin.x() : (begin.x() + end.x()) / 2;
  return QPolygonF({begin, {middle, begin.y()}, {middle, end.y()}, end});
}

/// Above the slave: beside the cable that comes from there, else where one that comes from the left begins.
QRectF TopologyView::badgeOnPaper(int slave) const {
  if (slave < 0 || slave >= static_cast<int>(layout_.slaves.size())) return {};
  const auto badge = cables_.badge(slave);
  if (badge.damage == CableDamage::kNone) return {};
  const auto box = boxOf(slave);
  const auto& place = layout_.slaves[static_cast<std::size_t>(slave)];
  const bool from_above = place.goes_on || !place.previous;
  const auto size = topology::badgeSize(badge);
  const double middle = box.top() - (kRow - kBoxHeight) / 2;
  return {{from_above ? box.center().x() + kBadgeBeside : box.left(), middle - size.height() / 2}, size};
}

QRect TopologyView::badgeRect(int slave) const {
  const auto area = badgeOnPaper(slave);
  return QRectF(area.topLeft() * zoom_ - QPointF(horizontalOffset(), verticalOffset()), area.size() * zoom_).toRect();
}

int TopologyView::badgeAt(const QPoint& point) const {
  const auto there = onPaper(point);
  for (int slave = 0; slave < static_cast<int>(layout_.slaves.size()); ++slave) {
    if (badgeOnPaper(slave).contains(there)) return slave;
  }
  return -1;
}

/// The slave by whose cable the point is.
int TopologyView::cableAt(const QPoint& point) const {
  const auto there = onPaper(point);
  for (int slave = 0; slave < static_cast<int>(layout_.slaves.size()); ++slave) {
    const auto cable = cableOf(slave);
    for (int i = 1; i < cable.size(); ++i) {
      if (distanceOf(there, {cable[i - 1], cable[i]}) <= kNearCable) return slave;
    }
  }
  return -1;
}

QPointF TopologyView::onPaper(const QPointF& point) const {
  return (point + QPointF(horizontalOffset(), verticalOffset())) / zoom_;
}

QPoint TopologyView::portPosition(int slave, int port) const {
  return (anchorOf(slave, port) * zoom_ - QPointF(horizontalOffset(), verticalOffset())).toPoint();
}

QRect TopologyView::visualRect(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const auto box = boxOf(slaveOf(index));
  return QRectF(box.topLeft() * zoom_ - QPointF(horizontalOffset(), verticalOffset()), box.size() * zoom_).toRect();
}

QModelIndex TopologyView::indexAt(const QPoint& point) const {
  const auto there = onPaper(point);
  for (int slave = -1; slave < static_cast<int>(layout_.slaves.size()); ++slave) {
    if (boxOf(slave).contains(there)) return network_.indexOf(slave);
  }
  return {};
}

/// Not while the mouse has a slave: it stays below it, and the port that it is dragged to where it was seen.
void TopologyView::scrollTo(const QModelIndex& index, ScrollHint) {
  if (!index.isValid() || grabbed_ >= 0) return;
  const auto box = visualRect(index).adjusted(-12, -12, 12, 12);
  const auto bring = [](QScrollBar* bar, int first, int last, int size) {
    if (first < 0) bar->setValue(bar->value() + first);
    if (first >= 0 && last > size) bar->setValue(bar->value() + std::min(last - size, first));
  };
  bring(horizontalScrollBar(), box.left(), box.right(), viewport()->width());
  bring(verticalScrollBar(), box.top(), box.bottom(), viewport()->height());
}

QModelIndex TopologyView::moveCursor(CursorAction action, Qt::KeyboardModifiers) {
  const int slave = slaveOf(currentIndex());
  const int count = static_cast<int>(layout_.slaves.size());
  if (action == MoveHome) return network_.indexOf(-1);
  if (action == MoveEnd) return network_.indexOf(count - 1);
  if (slave < 0 || slave >= count) return network_.indexOf(action == MoveDown || action == MoveNext ? 0 : -1);
  const auto& place = layout_.slaves[static_cast<std::size_t>(slave)];
  const int page = std::max(1, static_cast<int>(viewport()->height() / (kRow * zoom_)));
  switch (action) {
    case MoveUp:
      return network_.indexOf(place.before);
    case MoveDown:
      return network_.indexOf(place.next >= 0 ? place.next : slave);
    case MoveLeft:
      return network_.indexOf(place.from >= 0 ? place.from : slave);
    case MoveRight:
      return network_.indexOf(place.first_branch >= 0 ? place.first_branch : slave);
    case MoveNext:
      return network_.indexOf(std::min(slave + 1, count - 1));
    case MovePrevious:
      return network_.indexOf(slave - 1);
    case MovePageUp:
      return network_.indexOf(std::max(0, slave - page));
    case MovePageDown:
      return network_.indexOf(std::min(count - 1, slave + page));
    default:
      return currentIndex();
  }
}

int TopologyView::horizontalOffset() const { return horizontalScrollBar()->value(); }
int TopologyView::verticalOffset() const { return verticalScrollBar()->value(); }

void TopologyView::setSelection(const QRect& rect, QItemSelectionModel::SelectionFlags command) {
  const auto index = indexAt(rect.center());
  if (index.isValid()) selectionModel()->select(index, command);
}

QRegion TopologyView::visualRegionForSelection(const QItemSelection& selection) const {
  QRegion region;
  for (const auto& index : selection.indexes()) region += visualRect(index);
  return region;
}

void TopologyView::updateGeometries() {
  const QSizeF paper(2 * kEdge + std::max(1, layout_.columns) * kColumn, 2 * kEdge + std::max(1, layout_.rows) * kRow);
  const auto set = [](QScrollBar* bar, double all, int seen) {
    bar->setRange(0, std::max(0, static_cast<int>(std::ceil(all)) - seen));
    bar->setPageStep(seen);
    bar->setSingleStep(static_cast<int>(kRow / 2));
  };
  set(horizontalScrollBar(), paper.width() * zoom_, viewport()->width());
  set(verticalScrollBar(), paper.height() * zoom_, viewport()->height());
  QAbstractItemView::updateGeometries();
}

void TopologyView::dataChanged(const QModelIndex& from, const QModelIndex& to, const QList<int>& roles) {
  QAbstractItemView::dataChanged(from, to, roles);
  viewport()->update();
}

/// Of a cable, as long as no slave is there.
bool TopologyView::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QAbstractItemView::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (indexAt(help->pos()).isValid()) return QAbstractItemView::viewportEvent(event);
  const int badge = badgeAt(help->pos());
  const int slave = badge >= 0 ? badge : cableAt(help->pos());
  QToolTip::showText(help->globalPos(), cableTip(network_, cables_, slave), viewport());
  return true;
}

void TopologyView::paintEvent(QPaintEvent* event) {
  QPainter painter(viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF seen(onPaper(event->rect().topLeft()), onPaper(event->rect().bottomRight()));
  painter.translate(-horizontalOffset(), -verticalOffset());
  painter.scale(zoom_, zoom_);
  const int count = std::min(network_.slaveCount(), static_cast<int>(layout_.slaves.size()));
  for (int slave = 0; slave < count; ++slave) {
    const auto& previous = layout_.slaves[static_cast<std::size_t>(slave)].previous;
    const auto reach = boxOf(slave).united(boxOf(previous ? previous->position : -1)).adjusted(-8, -8, 8, 8);
    if (reach.intersects(seen)) drawCable(painter, slave);
  }
  for (int slave = -1; slave < count; ++slave) {
    if (!boxOf(slave).adjusted(-8, -8, 8, 8).intersects(seen)) continue;
    drawNode(painter, slave);
    if (slave >= 0) drawPorts(painter, slave);
  }
  for (int slave = 0; slave < count; ++slave) drawBadge(painter, slave);
  if (dragging_) {
    painter.setPen(QPen(theme::toneColor(palette(), theme::Tone::kAccent), 2, Qt::DashLine));
    const auto entry = layout_.slaves[static_cast<std::size_t>(grabbed_)].ports;
    const auto own = std::ranges::find(entry, TopologyPlace::Port::kEntry) - entry.begin();
    painter.drawLine(anchorOf(grabbed_, static_cast<int>(own)),
                     aim_.slave >= 0 ? anchorOf(aim_.slave, aim_.port) : onPaper(mouse_));
  }
}

void TopologyView::drawCable(QPainter& painter, int slave) const {
  const auto link = static_cast<NetworkModel::LinkState>(network_.indexOf(slave).data(NetworkModel::kLinkRole).toInt());
  painter.setPen(topology::cablePen(palette(), link, dragging_ && slave == grabbed_));
  painter.drawPolyline(cableOf(slave));
}

void TopologyView::drawBadge(QPainter& painter, int slave) const {
  const auto badge = cables_.badge(slave);
  if (badge.damage != CableDamage::kNone) topology::drawBadge(painter, badgeOnPaper(slave), palette(), badge);
}

void TopologyView::drawNode(QPainter& painter, int slave) const {
  const auto index = network_.indexOf(slave);
  const bool selected = selectionModel()->isSelected(index);
  topology::drawBox(painter, boxOf(slave), palette(), index,
                    {selected, selected && hasFocus(),
                     slave >= 0 && !layout_.slaves[static_cast<std::size_t>(slave)].previous && slave > 0});
}

void TopologyView::drawPorts(QPainter& painter, int slave) const {
  const auto& place = layout_.slaves[static_cast<std::size_t>(slave)];
  for (int port = 0; port < 4; ++port) {
    const auto state = place.ports[static_cast<std::size_t>(port)];
    if (state == TopologyPlace::Port::kNone) continue;
    const bool free = state == TopologyPlace::Port::kFree;
    const bool offered = free && dragging_ && mayPlug(grabbed_, {slave, port});
    topology::drawPort(painter, anchorOf(slave, port), QChar(u'A' + port), palette(),
                       {free, offered, aim_ == PortPlace{slave, port}});
  }
}

TopologyView::PortPlace TopologyView::freePortAt(const QPoint& point) const {
  const auto there = onPaper(point);
  PortPlace nearest;
  double least = kReach;
  for (int slave = 0; slave < static_cast<int>(layout_.slaves.size()); ++slave) {
    if (!boxOf(slave).adjusted(-kReach, -kReach, kReach, kReach).contains(there)) continue;
    for (int port = 0; port < 4; ++port) {
      if (layout_.slaves[static_cast<std::size_t>(slave)].ports[static_cast<std::size_t>(port)] !=
          TopologyPlace::Port::kFree)
        continue;
      const auto away = anchorOf(slave, port) - there;
      const double distance = std::hypot(away.x(), away.y());
      if (distance >= least) continue;
      least = distance;
      nearest = {slave, port};
    }
  }
  return nearest;
}

bool TopologyView::mayPlug(int slave, const PortPlace& at) const {
  if (!tree_ || at.slave < 0) return false;
  const PreviousPort place{static_cast<std::uint16_t>(at.slave), static_cast<std::uint8_t>(at.port)};
  return !rewire_obstacle(*tree_, static_cast<std::size_t>(slave), place);
}

bool TopologyView::mayPlug(const DraggedDevice& device, const PortPlace& at) const {
  if (!tree_ || at.slave < 0) return false;
  DeviceDescription plugged;
  plugged.physics = device.physics;
  const PreviousPort place{static_cast<std::uint16_t>(at.slave), static_cast<std::uint8_t>(at.port)};
  return !plug_obstacle(*tree_, plugged, place);
}

void TopologyView::mousePressEvent(QMouseEvent* event) {
  clicked_badge_ = event->button() == Qt::LeftButton ? badgeAt(event->position().toPoint()) : -1;
  if (clicked_badge_ >= 0) return;
  QAbstractItemView::mousePressEvent(event);
  pressed_ = event->position().toPoint();
  const int slave = slaveOf(indexAt(pressed_));
  const bool has_cable = slave >= 0 && layout_.slaves[static_cast<std::size_t>(slave)].previous;
  grabbed_ = event->button() == Qt::LeftButton && editable_ && has_cable ? slave : -1;
}

void TopologyView::mouseMoveEvent(QMouseEvent* event) {
  mouse_ = event->position().toPoint();
  if (event->buttons() == Qt::NoButton)
    viewport()->setCursor(badgeAt(mouse_) >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (grabbed_ < 0 || !(event->buttons() & Qt::LeftButton)) return;
  dragging_ = dragging_ || (mouse_ - pressed_).manhattanLength() >= QApplication::startDragDistance();
  if (!dragging_ || project_ == nullptr) return;
  if (!tree_) tree_ = WiringTree::of(project_->slaves);
  const auto port = freePortAt(mouse_);
  aim_ = mayPlug(grabbed_, port) ? port : PortPlace{};
  viewport()->setCursor(port.slave >= 0 && aim_.slave < 0 ? Qt::ForbiddenCursor : Qt::ClosedHandCursor);
  viewport()->update();
}

void TopologyView::mouseReleaseEvent(QMouseEvent* event) {
  if (const int badge = std::exchange(clicked_badge_, -1); badge >= 0) {
    const auto counted = cables_.badge(badge);
    if (badgeAt(event->position().toPoint()) == badge) Q_EMIT countersWanted(counted.slave);
    return;
  }
  if (!dragging_) {
    endDrag();
    return QAbstractItemView::mouseReleaseEvent(event);
  }
  // No click: where it ends nothing is selected, nor does what is selected go.
  const int slave = grabbed_;
  const auto at = aim_;
  endDrag();
  setState(NoState);
  if (at.slave >= 0) Q_EMIT rewireWanted(slave, at.slave, at.port);
}

void TopologyView::endDrag() {
  grabbed_ = -1;
  dragging_ = false;
  tree_.reset();
  aim_ = {};
  viewport()->unsetCursor();
  viewport()->update();
}

void TopologyView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && dragging_) return endDrag();
  if (event->matches(QKeySequence::ZoomIn)) return setZoom(zoom_ * 1.2);
  if (event->matches(QKeySequence::ZoomOut)) return setZoom(zoom_ / 1.2);
  if (event->key() == Qt::Key_0 && event->modifiers() == Qt::ControlModifier) return setZoom(1);
  QAbstractItemView::keyPressEvent(event);
}

void TopologyView::wheelEvent(QWheelEvent* event) {
  if (!(event->modifiers() & Qt::ControlModifier)) return QAbstractItemView::wheelEvent(event);
  setZoom(zoom_ * std::pow(1.2, event->angleDelta().y() / 120.0));
  event->accept();
}

void TopologyView::dragEnterEvent(QDragEnterEvent* event) {
  if (!editable_ || project_ == nullptr || !deviceOf(*event->mimeData())) return event->ignore();
  tree_ = WiringTree::of(project_->slaves);
  event->acceptProposedAction();
}

/// On a port that does not take it nothing is dropped; on a slave it goes behind it, where it fits.
void TopologyView::dragMoveEvent(QDragMoveEvent* event) {
  const auto device = deviceOf(*event->mimeData());
  if (!editable_ || !device) return event->ignore();
  if (!tree_ && project_ != nullptr) tree_ = WiringTree::of(project_->slaves);
  const auto port = freePortAt(event->position().toPoint());
  aim_ = mayPlug(*device, port) ? port : PortPlace{};
  viewport()->update();
  if (port.slave >= 0 && aim_.slave < 0) return event->ignore();
  event->acceptProposedAction();
}

void TopologyView::dragLeaveEvent(QDragLeaveEvent*) { endDrag(); }

void TopologyView::dropEvent(QDropEvent* event) {
  const auto point = event->position().toPoint();
  const auto device = deviceOf(*event->mimeData());
  const auto port = freePortAt(point);
  const auto index = indexAt(point);
  endDrag();
  if (!editable_ || !device) return event->ignore();
  event->acceptProposedAction();
  if (port.slave >= 0) return Q_EMIT deviceDroppedAt(device->id, port.slave, port.port);
  Q_EMIT deviceDropped(device->id, {index.isValid() ? slaveOf(index) : network_.slaveCount() - 1});
}

}  // namespace syncline::ui
