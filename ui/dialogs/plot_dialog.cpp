// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/plot_dialog.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "record/run_record.h"
#include "ui/models/signal_tree.h"
#include "ui/models/word_filter.h"
#include "ui/plots/trace_plot.h"
#include "ui/plots/view_signals.h"
#include "ui/theme/theme.h"
#include "ui/widgets/limit_fields.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

enum PlotColumn : std::uint8_t { kSignal, kRate, kRight, kPlotColumns };

/// The same signal, however it is shown.
bool isSame(const ViewSignal& one, const ViewSignal& other) {
  return one.of == other.of && one.key == other.key && one.station_address == other.station_address &&
         one.output == other.output;
}

QTableWidgetItem* switchItem(bool on, bool possible) {
  auto* item = new QTableWidgetItem;
  item->setFlags(possible ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable : Qt::ItemIsSelectable);
  if (possible) item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
  return item;
}

}  // namespace

PlotDialog::PlotDialog(const RunRecord& record, ViewPlot plot, const AxisLimits& left, const AxisLimits& right,
                       QWidget* parent)
    : QDialog(parent), plot_(std::move(plot)) {
  setObjectName(QStringLiteral("plotDialog"));
  setWindowTitle(tr("Signals and Axes of the Plot"));
  for (const auto& signal : plot_.signals) names_.push_back(nameOf(record, signal));
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  auto* sides = new QHBoxLayout;
  sides->addWidget(buildOffer(record), 4);
  auto* right_side = new QVBoxLayout;
  right_side->addWidget(buildChosen(), 1);
  right_side->addWidget(buildSettings(left, right));
  sides->addLayout(right_side, 5);
  wrong_ = named(new QLabel, "plotWrong", tr("What is wrong"));
  wrong_->setWordWrap(true);
  auto* foot = new QHBoxLayout;
  foot->addWidget(wrong_, 1);
  foot->addWidget(buttons_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(sides, 1);
  layout->addLayout(foot);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  fillChosen();
  resize(860, 520);
  words_->setFocus();
}

PlotDialog::~PlotDialog() = default;

QWidget* PlotDialog::buildOffer(const RunRecord& record) {
  auto* side = new QWidget;
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  words_ = named(new QLineEdit, "plotSearch", tr("Search signals"));
  words_->setPlaceholderText(tr("Slave and signal, such as: #1 lost"));
  words_->setClearButtonEnabled(true);
  words_->installEventFilter(this);
  tree_ = new SignalTree(record, this);
  filter_ = new WordFilter(SignalTree::kWordsRole, this);
  filter_->setSourceModel(tree_);
  offer_ = named(new QTreeView, "plotOffer", tr("Signals of the run"));
  offer_->setModel(filter_);
  setUpTree(*offer_);
  offer_->setHeaderHidden(true);
  offer_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  offer_->setMinimumWidth(240);
  offer_->installEventFilter(this);
  add_ = named(new QPushButton(tr("Add")), "plotAdd", tr("Add what is marked"));
  add_->setToolTip(tr("Ctrl+A marks all that were found: several slaves at once"));
  add_->setAutoDefault(false);
  layout->addWidget(words_);
  about_ = named(new QLabel, "plotAbout", tr("About the marked signal"));
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::PlainText);
  about_->setMinimumHeight(3 * about_->fontMetrics().lineSpacing());
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeading);
  layout->addWidget(offer_, 1);
  layout->addWidget(about_);
  layout->addWidget(add_);
  connect(words_, &QLineEdit::textChanged, this, &PlotDialog::search);
  connect(add_, &QPushButton::clicked, this, &PlotDialog::add);
  connect(offer_, &QTreeView::doubleClicked, this, &PlotDialog::add);
  connect(offer_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PlotDialog::showState);
  connect(offer_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& index) { about_->setText(index.data(Qt::ToolTipRole).toString()); });
  offer_->expand(filter_->index(0, 0));
  return side;
}

QWidget* PlotDialog::buildChosen() {
  auto* side = new QWidget;
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  chosen_ = named(new QTableWidget(0, kPlotColumns), "plotChosen", tr("Signals in the plot"));
  chosen_->setHorizontalHeaderLabels({tr("In the plot"), tr("A second"), tr("Axis right")});
  chosen_->horizontalHeaderItem(kRate)->setToolTip(tr("How many a second instead of how many: of counts"));
  chosen_->horizontalHeaderItem(kRight)->setToolTip(tr("On the value axis at the right"));
  setUpTable(*chosen_);
  chosen_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  stretchColumn(*chosen_, kSignal);
  chosen_->installEventFilter(this);
  out_ = named(new QPushButton(tr("Take Out")), "plotTakeOut", tr("Take out what is marked (Del)"));
  out_->setAutoDefault(false);
  layout->addWidget(chosen_, 1);
  layout->addWidget(out_, 0, Qt::AlignRight);
  connect(chosen_, &QTableWidget::cellChanged, this, &PlotDialog::readTable);
  connect(chosen_, &QTableWidget::itemSelectionChanged, this, &PlotDialog::showState);
  connect(out_, &QPushButton::clicked, this, &PlotDialog::takeOut);
  return side;
}

QWidget* PlotDialog::buildSettings(const AxisLimits& left, const AxisLimits& right) {
  auto* side = new QWidget;
  auto* form = new QFormLayout(side);
  form->setContentsMargins(0, 0, 0, 0);
  title_ = named(new QLineEdit(QString::fromStdString(plot_.title)), "plotTitle", tr("Title of the plot"));
  title_->setPlaceholderText(tr("By what it shows"));
  form->addRow(tr("Title"), title_);
  scale_ = new QButtonGroup(this);
  auto* scales = new QHBoxLayout;
  const struct {
    ValueScale scale;
    const char* name;
    QString text;
  } choices[] = {{ValueScale::kLinear, "plotLinear", tr("linear")},
                 {ValueScale::kSignedLog, "plotSignedLog", tr("signed log")},
                 {ValueScale::kLog, "plotLog", tr("log")}};
  for (const auto& [scale, name, text] : choices) {
    auto* button = named(new QRadioButton(text), name, tr("Value scale: %1").arg(text));
    button->setChecked(scale == plot_.scale);
    scale_->addButton(button, static_cast<int>(scale));
    scales->addWidget(button);
  }
  scales->addStretch(1);
  form->addRow(tr("Value scale"), scales);
  left_ = new LimitFields(QStringLiteral("plotLeft"), tr("Left axis"));
  left_->setLimits(plot_.left, left);
  form->addRow(tr("Left axis"), left_);
  right_ = new LimitFields(QStringLiteral("plotRight"), tr("Right axis"));
  right_->setLimits(plot_.right, right);
  form->addRow(tr("Right axis"), right_);
  own_time_ =
      named(new QCheckBox(tr("not linked to the others: own zoom and place")), "plotOwnTime", tr("Own time axis"));
  own_time_->setChecked(plot_.own_time);
  form->addRow(tr("Time axis"), own_time_);
  for (auto* fields : {left_, right_}) connect(fields, &LimitFields::changed, this, &PlotDialog::showState);
  connect(scale_, &QButtonGroup::idToggled, this, &PlotDialog::showState);
  return side;
}

/// What is found is seen, and the first of it is marked: Enter adds it.
void PlotDialog::search(const QString& words) {
  filter_->setWords(words);
  offer_->clearSelection();
  if (words.trimmed().isEmpty()) return offer_->collapseAll();
  offer_->expandAll();
  const auto group = filter_->index(0, 0);
  if (group.isValid()) offer_->setCurrentIndex(filter_->index(0, 0, group));
}

/// On the other side where the left one has another unit.
bool PlotDialog::isRight(const ViewSignal& signal) const {
  if (isState(signal)) return false;
  const auto first =
      std::ranges::find_if(plot_.signals, [](const ViewSignal& one) { return !isState(one) && !one.right; });
  return first != plot_.signals.end() && unitOf(*first) != unitOf(signal);
}

void PlotDialog::add() {
  auto marked = offer_->selectionModel()->selectedIndexes();
  std::ranges::sort(marked, [](const QModelIndex& a, const QModelIndex& b) {
    return std::pair(a.parent().row(), a.row()) < std::pair(b.parent().row(), b.row());
  });
  for (const auto& index : marked) {
    const auto source = filter_->mapToSource(index);
    auto signal = tree_->signalAt(source);
    if (!signal || std::ranges::any_of(plot_.signals, [&](const auto& one) { return isSame(one, *signal); })) continue;
    signal->right = isRight(*signal);
    const auto owner = source.parent().data().toString();
    names_.push_back(signal->of == ViewSignal::Of::kSlave ? owner + QStringLiteral(": ") + quantityOf(*signal)
                                                          : quantityOf(*signal));
    plot_.signals.push_back(std::move(*signal));
  }
  fillChosen();
}

void PlotDialog::takeOut() {
  std::set<int, std::greater<>> rows;
  for (const auto& index : chosen_->selectionModel()->selectedIndexes()) rows.insert(index.row());
  for (const int row : rows) {
    plot_.signals.erase(plot_.signals.begin() + row);
    names_.erase(names_.begin() + row);
  }
  fillChosen();
  if (chosen_->rowCount() > 0 && !rows.empty())
    chosen_->setCurrentCell(std::min(*rows.rbegin(), chosen_->rowCount() - 1), kSignal);
}

void PlotDialog::fillChosen() {
  filling_ = true;
  const int before = chosen_->currentRow();
  chosen_->setRowCount(static_cast<int>(plot_.signals.size()));
  for (std::size_t i = 0; i < plot_.signals.size(); ++i) {
    const auto& signal = plot_.signals[i];
    const int row = static_cast<int>(i);
    auto* name = new QTableWidgetItem(names_[i]);
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    name->setToolTip(names_[i]);
    chosen_->setItem(row, kSignal, name);
    chosen_->setItem(row, kRate, switchItem(signal.rate, isCount(signal)));
    chosen_->setItem(row, kRight, switchItem(signal.right, !isState(signal)));
  }
  if (before >= 0 && before < chosen_->rowCount()) chosen_->setCurrentCell(before, kSignal);
  filling_ = false;
  showState();
}

void PlotDialog::readTable(int row, int column) {
  if (filling_ || row < 0 || static_cast<std::size_t>(row) >= plot_.signals.size()) return;
  auto& signal = plot_.signals[static_cast<std::size_t>(row)];
  const bool on = chosen_->item(row, column)->checkState() == Qt::Checked;
  if (column == kRate) signal.rate = on;
  if (column == kRight) signal.right = on;
  showState();
}

void PlotDialog::showState() {
  for (const bool right : {false, true}) {
    std::vector<const ViewSignal*> on;
    for (const auto& signal : plot_.signals) {
      if (!isState(signal) && signal.right == right) on.push_back(&signal);
    }
    const auto options = axisFor(on);
    (right ? right_ : left_)->setTimes(options.kind == ValueAxis::Quantity::kTime, options.unit);
  }
  add_->setEnabled(std::ranges::any_of(offer_->selectionModel()->selectedIndexes(), [this](const QModelIndex& index) {
    return tree_->signalAt(filter_->mapToSource(index)).has_value();
  }));
  out_->setEnabled(chosen_->selectionModel()->hasSelection());
  QString wrong;
  const bool log = scale_->checkedId() == static_cast<int>(ValueScale::kLog);
  for (const auto* fields : {left_, right_}) {
    if (!fields->isValid()) wrong = tr("Limits are two numbers, the smaller one first.");
    if (const auto limits = fields->limits(); wrong.isEmpty() && log && limits && limits->low <= 0)
      wrong = tr("A logarithmic scale begins above zero.");
  }
  auto colors = palette();
  colors.setColor(QPalette::WindowText, theme::toneColor(colors, theme::Tone::kBad));
  wrong_->setPalette(colors);
  wrong_->setText(wrong);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty());
}

ViewPlot PlotDialog::plot() const {
  auto plot = plot_;
  plot.title = title_->text().trimmed().toStdString();
  plot.scale = static_cast<ValueScale>(scale_->checkedId());
  plot.left = left_->limits();
  plot.right = right_->limits();
  plot.own_time = own_time_->isChecked();
  return plot;
}

/// Enter adds what is marked, Del takes out; from the search field the arrows go into the tree, and Ctrl+A marks what
/// was found.
bool PlotDialog::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(object, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if ((object == words_ || object == offer_) && enter && key->modifiers() == Qt::NoModifier) {
    if (add_->isEnabled()) add();
    return true;
  }
  if (object == words_ && key->key() == Qt::Key_Down) {
    offer_->setFocus(Qt::TabFocusReason);
    return true;
  }
  if (object == chosen_ && key->key() == Qt::Key_Delete) {
    takeOut();
    return true;
  }
  return QDialog::eventFilter(object, event);
}

}  // namespace syncline::ui
