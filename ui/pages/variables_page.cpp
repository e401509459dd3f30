// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/variables_page.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <set>
#include <utility>

#include "support/le_number.h"
#include "ui/dialogs/questions.h"
#include "ui/models/variable_model.h"
#include "ui/models/word_filter.h"
#include "ui/session/workspace.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

/// Faster than this nobody reads numbers.
constexpr Nanoseconds kReadable = 100 * kMillisecond;

enum VariableKind : int { kAllVariables, kInputVariables, kOutputVariables, kForcedVariables };

}  // namespace

/// Variables of a kind in which all words occur.
class VariableFilter final : public WordFilter {
 public:
  explicit VariableFilter(QObject* parent) : WordFilter(VariableModel::kWordsRole, parent) {
    setDynamicSortFilter(false);  // values change all the time, and decide nothing
  }
  void setKind(int kind) {
    kind_ = kind;
    invalidateFilter();
  }
  void forcesChanged() {
    if (kind_ == kForcedVariables) invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const auto index = sourceModel()->index(row, 0, parent);
    const bool output = index.data(VariableModel::kOutputRole).toBool();
    if ((kind_ == kInputVariables && output) || (kind_ == kOutputVariables && !output)) return false;
    if (kind_ == kForcedVariables && !index.data(VariableModel::kForcedRole).toBool()) return false;
    return WordFilter::filterAcceptsRow(row, parent);
  }

 private:
  int kind_ = kAllVariables;
};

VariablesPage::VariablesPage(Workspace& workspace) : Page(workspace, "variablesPage", tr("Variables")) {
  model_ = new VariableModel(this);
  filter_ = new VariableFilter(this);
  filter_->setSourceModel(model_);
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(6);
  layout->addWidget(buildChoice());
  table_ = named(new QTableView, "variableTable", tr("Variables of the process image"));
  table_->setModel(filter_);
  setUpTable(*table_);
  const std::pair<VariableModel::Column, int> widths[] = {{VariableModel::kDirection, 72}, {VariableModel::kType, 70},
                                                          {VariableModel::kPlace, 60},     {VariableModel::kValue, 104},
                                                          {VariableModel::kRaw, 92},       {VariableModel::kForced, 68},
                                                          {VariableModel::kMonitor, 72}};
  for (const auto& [column, width] : widths) table_->setColumnWidth(column, width);
  stretchColumn(*table_, VariableModel::kName);
  table_->setTextElideMode(Qt::ElideMiddle);  // slave in front, entry behind
  layout->addWidget(table_, 1);
  hint_ = named(new ValueLabel, "variablesHint", tr("What the values are"));
  hint_->setMinimumWidth(60);
  layout->addWidget(hint_);
  layout->addWidget(buildForcing());
  watch_action_ = new QAction(tr("Watch in the Monitor"), table_);
  watch_action_->setObjectName(QStringLiteral("actionWatchVariable"));
  watch_action_->setCheckable(true);
  table_->addAction(watch_action_);
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  setWidget(content);
  connect(watch_action_, &QAction::triggered, this, &VariablesPage::watch);
  connect(&workspace.variables(), &VariableWatch::changed, this, &VariablesPage::showWatched);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, &VariablesPage::showSelected);
  connect(filter_, &QAbstractItemModel::modelReset, this, &VariablesPage::showSelected);
  connect(model_, &VariableModel::forcesChanged, filter_, &VariableFilter::forcesChanged);
  connect(&workspace.live(), &LiveSession::recordChanged, this, [this] { allowed_ = false; });
  connect(&workspace.live(), &LiveSession::phaseChanged, this, [this] {
    if (isVisible()) refresh();
  });
  showWatched();
  showSelected();
}

QWidget* VariablesPage::buildChoice() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  kind_ = named(new Segments({{"variablesAll", tr("All"), tr("All variables"), {}},
                              {"variablesInputs", tr("Inputs"), tr("What the slaves send"), {}},
                              {"variablesOutputs", tr("Outputs"), tr("What the slaves are sent"), {}},
                              {"variablesForced", tr("Forced"), tr("Outputs that are forced"), {}}}),
                "variableKind", tr("Which variables are shown"));
  kind_->setCurrent(kAllVariables);
  words_ = named(new QLineEdit, "variableSearch", tr("Search variables"));
  words_->setPlaceholderText(tr("Name, type, or place"));
  words_->setClearButtonEnabled(true);
  layout->addWidget(kind_);
  layout->addWidget(words_, 1);
  connect(kind_, &Segments::chosen, this, [this](int kind) { filter_->setKind(kind); });
  connect(words_, &QLineEdit::textChanged, filter_, &VariableFilter::setWords);
  return area;
}

QWidget* VariablesPage::buildForcing() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  selected_ = named(new ValueLabel, "variableSelected", tr("Selected variable"));
  selected_->setMinimumWidth(100);
  value_ = named(new QLineEdit, "variableValue", tr("Value to force, decimal or with 0x"));
  value_->setPlaceholderText(tr("Value"));
  value_->setMaximumWidth(180);
  force_ = named(new QPushButton(tr("&Force")), "variableForce",
                 tr("Hold the output at this value, whatever the application calculates"));
  release_ = named(new QPushButton(tr("Re&lease")), "variableRelease", tr("Let the application set this output again"));
  release_all_ = named(new QPushButton(tr("Release All")), "variableReleaseAll", tr("Force no output any more"));
  for (auto* button : {force_, release_, release_all_}) button->setToolTip(button->accessibleName());
  watch_ = named(new QPushButton(tr("&Watch in the Monitor")), "variableWatch",
                 tr("Record the variable in every cycle and draw it below the plots"));
  watch_->setCheckable(true);
  connect(watch_, &QPushButton::clicked, this, &VariablesPage::watch);
  layout->addWidget(selected_, 1);
  layout->addWidget(watch_);
  for (QWidget* part : {static_cast<QWidget*>(value_), static_cast<QWidget*>(force_), static_cast<QWidget*>(release_),
                        static_cast<QWidget*>(release_all_)})
    layout->addWidget(part);
  connect(value_, &QLineEdit::textChanged, this, &VariablesPage::enableForcing);
  connect(value_, &QLineEdit::returnPressed, force_, &QPushButton::click);
  connect(force_, &QPushButton::clicked, this, &VariablesPage::force);
  connect(release_, &QPushButton::clicked, this, &VariablesPage::release);
  connect(release_all_, &QPushButton::clicked, this, &VariablesPage::releaseAll);
  return area;
}

bool VariablesPage::appliesTo(int slave) const {
  if (slave < 0) return true;
  const auto& slaves = project().slaves;
  if (static_cast<std::size_t>(slave) >= slaves.size()) return false;
  const auto& one = slaves[static_cast<std::size_t>(slave)];
  return !one.assigned_rx_pdos.empty() || !one.assigned_tx_pdos.empty();
}

const NetworkConfig* VariablesPage::config() const {
  const auto& live = workspace().live();
  if (live.phase() != LiveSession::Phase::kOffline && live.record() != nullptr) return &live.record()->config();
  return workspace().configuration().config();
}

void VariablesPage::refresh() {
  showVariables();
  showLive(workspace().live().snapshot());
}

void VariablesPage::showVariables() {
  const auto* shown = config();
  int slave = node();
  const bool runs = workspace().live().phase() != LiveSession::Phase::kOffline;
  if (runs && slave >= 0) slave = workspace().runningSlaves().positionOf(slave);
  if (shown == nullptr || (node() >= 0 && slave < 0)) return model_->clear();
  model_->setVariables(*shown, node() < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(slave)));
}

void VariablesPage::showLive(const Snapshot& snapshot) {
  const auto* image = snapshot.online ? workspace().live().image() : nullptr;
  const bool due = image == nullptr || image->time - shown_ >= kReadable || image->time < shown_;
  if (due) {
    shown_ = image == nullptr ? 0 : image->time;
    std::vector<bool> silent;
    for (const auto& slave : snapshot.slaves) {
      const auto state = al_state_of(slave.al_status);
      silent.push_back(!slave.present || (state != AlState::kSafeop && state != AlState::kOp));
    }
    model_->setImage(image, silent);
    showHint(snapshot, image);
  }
  enableForcing();
}

void VariablesPage::showHint(const Snapshot& snapshot, const ImageContents* image) {
  const auto* shown = config();
  if (shown == nullptr) return hint_->setText(tr("The project cannot be compiled: the messages say why."));
  if (node() >= 0 && model_->rowCount() == 0 && snapshot.online)
    return hint_->setText(tr("No slave that runs has this station address and identity."));
  if (image == nullptr) {
    return hint_->setText(
        tr("The process image has %1 for inputs and %2 for outputs, with gaps and addresses that both use. "
           "Values are shown while the machine runs.")
            .arg(bitsText(8 * shown->image.input_bytes), bitsText(8 * shown->image.output_bytes)));
  }
  const auto cycle = tr("Cycle %1").arg(countText(image->cycle));
  const int unknown = model_->unknownInputs();
  if (unknown == 0) return hint_->setText(cycle);
  const auto missing =
      tr("%n input(s) not known: they do not come back, or their slaves exchange none", nullptr, unknown);
  hint_->setText(QStringLiteral("%1 \u00B7 %2").arg(cycle, missing));
}

int VariablesPage::current() const {
  const auto index = filter_->mapToSource(table_->currentIndex());
  return index.isValid() ? index.row() : -1;
}

/// What is typed stays as long as its variable is selected.
void VariablesPage::showSelected() {
  const auto* row = model_->row(current());
  const auto name = row == nullptr ? QString() : row->entry.name;
  if (name != std::exchange(selected_name_, name)) value_->clear();
  if (row == nullptr) {
    selected_->setText(tr("Choose an output to force it."));
  } else if (!row->output) {
    selected_->setText(tr("%1 is an input.").arg(name));
  } else {
    const auto range = rangeText(row->entry);
    selected_->setText(range.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, range));
  }
  enableForcing();
}

std::optional<std::uint64_t> VariablesPage::typed() const {
  const auto* row = model_->row(current());
  if (row == nullptr || !row->forcible() || value_->text().trimmed().isEmpty()) return std::nullopt;
  const auto bytes = typedValue(row->entry, value_->text());
  if (!bytes || bytes->size() > sizeof(std::uint64_t)) return std::nullopt;
  return le_number(*bytes);
}

void VariablesPage::enableForcing() {
  const int row = current();
  const auto* one = model_->row(row);
  const bool runs = workspace().live().phase() == LiveSession::Phase::kOnline;
  value_->setEnabled(one != nullptr && one->forcible());
  force_->setEnabled(runs && typed().has_value());
  release_->setEnabled(runs && one != nullptr && model_->forced(row));
  release_all_->setEnabled(runs && workspace().live().snapshot().forced_bits > 0);
  const bool watched = one != nullptr && model_->watched(row);
  const bool full = !watched && !workspace().variables().hasRoom();
  const bool can = one != nullptr && one->isNumber() && !full;
  watch_->setEnabled(can);
  watch_action_->setEnabled(can);
  watch_->setChecked(watched);
  watch_action_->setChecked(watched);
  watch_->setToolTip(full ? tr("%1 variables are watched already: take one away first").arg(kMostWatched)
                          : watch_->accessibleName());
}

void VariablesPage::showWatched() {
  std::set<QString> inputs, outputs;
  for (const auto& [name, output] : workspace().variables().names())
    (output ? outputs : inputs).insert(QString::fromStdString(name));
  model_->setWatched(std::move(inputs), std::move(outputs));
  enableForcing();
}

void VariablesPage::watch(bool on) {
  const auto* row = model_->row(current());
  if (row == nullptr) return;
  const VariableName name{row->entry.name.toStdString(), row->output};
  on ? workspace().variables().add(name) : workspace().variables().remove(name);
  enableForcing();
}

void VariablesPage::force() {
  const auto* row = model_->row(current());
  const auto value = typed();
  if (row == nullptr || !value) return;
  const auto place = row->bit_offset;
  const std::uint32_t bits = row->entry.bits;
  if (!allowed_ &&
      !ask(*window(), "forceQuestion", tr("Force outputs of the running machine?"),
           tr("What they drive moves or switches at once, whatever the application and its interlocks say. They stay "
              "forced until they are released or the machine goes offline. This is asked once a run."),
           tr("Force"))) {
    return;
  }
  allowed_ = true;
  workspace().live().forceOutput(place, bits, *value);
}

void VariablesPage::release() {
  const auto* row = model_->row(current());
  if (row != nullptr) workspace().live().releaseOutput(row->bit_offset, row->entry.bits);
}

void VariablesPage::releaseAll() { workspace().live().releaseAllOutputs(); }

}  // namespace syncline::ui
