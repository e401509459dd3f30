// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/variables_row.h"

#include <QHBoxLayout>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "record/run_record.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/plot_colors.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

/// As many as a list that is recorded can have.
constexpr std::size_t kMostItems = WatchLists::kMostVariables;

bool isSwitch(const WatchedVariable& variable) { return variable.bit_size == 1; }

/// "Position actual value" of "Servo.Inputs.Position actual value".
QString entryName(const WatchedVariable& variable) {
  const auto name = QString::fromStdString(variable.name);
  return name.sliced(name.lastIndexOf(u'.') + 1);
}

/// "#3 Position actual value"; of no slave, the name alone.
QString shortName(const WatchedVariable& variable) {
  const auto entry = entryName(variable);
  return variable.slave < 0 ? entry : QStringLiteral("#%1 %2").arg(variable.slave).arg(entry);
}

/// A heading that is wide would take its neighbours' room.
QString asHeading(const QString& text) {
  constexpr qsizetype kLongest = 32;
  return text.size() <= kLongest ? text : text.left(kLongest - 1) + QChar(0x2026);
}

}  // namespace

VariablePanel::VariablePanel(int number, TimeView* view, CursorSet* cursors, QWidget* parent)
    : TracePanel(tr("Variables"), {tr("Value"), TracePlot::Quantity::kCount, 1, false}, view, cursors, parent) {
  setObjectName(QStringLiteral("variablesPanel%1").arg(number));
  plot()->setObjectName(QStringLiteral("variablesPlot%1").arg(number));
  plot()->setToolTip(
      tr("Variables of the process image in each cycle, as they are watched on the page Variables. Where "
         "a value did not come back there is a gap."));
  for (std::size_t i = 0; i < kMostItems; ++i) items_.push_back(plot()->addItem({}, SeriesItem::Shape::kLine));
  attach();
}

void VariablePanel::setVariables(const QString& title, std::vector<std::size_t> variables) {
  variables_ = std::move(variables);
  setTitle(title);
  attach();
  if (!hasSource()) return;
  colorItems();
  plot()->fitValues();
  refreshText(true);
}

void VariablePanel::attach() {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    auto& item = *items_[i];
    const bool drawn = hasSource() && i < variables_.size() && variables_[i] < source().watched().variables().size();
    item.setVisible(drawn);
    if (!drawn) {
      item.setSeries(nullptr);
      continue;
    }
    const auto& variable = source().watched().variables()[variables_[i]];
    item.setShape(isSwitch(variable) ? SeriesItem::Shape::kStep : SeriesItem::Shape::kLine);
    draw(item, Signal::kVariable, variables_[i]);
    item.setTitle(QString::fromStdString(variable.name));
  }
  plot()->markDirty();
}

void VariablePanel::colorItems() {
  for (std::size_t i = 0; i < items_.size(); ++i)
    items_[i]->setColor(plot_colors::trace(palette(), static_cast<int>(i)));
}

std::vector<LegendBar::Entry> VariablePanel::entries(Nanoseconds time) const {
  std::vector<LegendBar::Entry> result;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (!items_[i]->isVisible()) continue;
    const auto& variable = source().watched().variables()[variables_[i]];
    auto one = entry(*items_[i], time);
    // The heading says what all of them are; else each says it.
    if (variable.slave >= 0 && title() == asHeading(entryName(variable))) {
      one.short_name = u'#' + QString::number(variable.slave);
      one.name = one.short_name + u' ' + slaveName(variable.slave);
    } else {
      one.name = shortName(variable);
      one.short_name = entryName(variable);
    }
    result.push_back(std::move(one));
  }
  return result;
}

QString VariablePanel::summary(Nanoseconds) const {
  const auto* item = primary();
  if (item == nullptr || variables_.size() != 1) return {};
  const auto extent = item->series()->extent(view().begin(), view().end() + 1);
  if (!extent) return tr("not known in the range shown");
  return tr("min %1   max %2")
      .arg(valueText(static_cast<double>(extent->min)), valueText(static_cast<double>(extent->max)));
}

const SeriesItem* VariablePanel::primary() const { return items_.front()->isVisible() ? items_.front() : nullptr; }

QString VariablePanel::valueText(double value) const { return numberText(value); }
QString VariablePanel::spreadText(double half) const { return QLocale().toString(half, 'g', 2); }

// ---- the row ----------------------------------------------------------------------------------

VariablesRow::VariablesRow(TimeView* view, CursorSet* cursors, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("variablesRow"));
  setAccessibleName(tr("Watched variables"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(14);
  for (std::size_t i = 0; i < kMostPlots; ++i) {
    panels_[i] = new VariablePanel(static_cast<int>(i), view, cursors);
    panels_[i]->hide();
    row->addWidget(panels_[i], 1);
  }
  hide();
}

void VariablesRow::setRecord(const RunRecord* record, bool recorded) {
  record_ = record;
  recorded_ = recorded;
  lists_ = 0;
  for (auto* panel : panels_) {
    panel->setSource(record);
    panel->setVariables(panel->title(), {});
    panel->hide();
  }
  shown_ = false;
  hide();
  Q_EMIT changed();
  follow();
}

void VariablesRow::setFolded(bool folded) {
  folded_ = folded;
  setVisible(shown_ && !folded_);
}

std::vector<VariablesRow::Group> VariablesRow::groups() const {
  const auto& watched = record_->watched();
  std::vector<std::size_t> shown;
  if (recorded_) {
    for (std::size_t number = 0; number < watched.variables().size(); ++number) shown.push_back(number);
  } else if (!watched.lists().empty()) {
    shown = watched.lists().back().places;
  }
  std::vector<Group> groups;
  for (const auto number : shown) {
    const auto& variable = watched.variables()[number];
    const auto alike = std::ranges::find_if(groups, [&](const Group& group) {
      const auto& first = watched.variables()[group.variables.front()];
      if (isSwitch(variable) || isSwitch(first)) return isSwitch(variable) && isSwitch(first);
      return entryName(variable) == entryName(first) && variable.data_type == first.data_type;
    });
    if (alike == groups.end() && groups.size() < kMostPlots) {
      groups.push_back({asHeading(shortName(variable)), {number}, false});
      continue;
    }
    auto& group = alike == groups.end() ? groups.back() : *alike;
    group.mixed = group.mixed || alike == groups.end();
    group.variables.push_back(number);
    group.title = group.mixed ? tr("Variables") : isSwitch(variable) ? tr("Switches") : asHeading(entryName(variable));
  }
  return groups;
}

void VariablesRow::follow() {
  if (record_ == nullptr || record_->watched().lists().size() == lists_) return;
  lists_ = record_->watched().lists().size();
  const auto shown = groups();
  for (std::size_t i = 0; i < kMostPlots; ++i) {
    const bool used = i < shown.size();
    panels_[i]->setVariables(used ? shown[i].title : panels_[i]->title(),
                             used ? shown[i].variables : std::vector<std::size_t>{});
    panels_[i]->setVisible(used);
  }
  shown_ = !shown.empty();
  setVisible(shown_ && !folded_);
  Q_EMIT changed();
}

}  // namespace syncline::ui
