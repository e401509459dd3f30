// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/compare_dialog.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "support/csv_field.h"
#include "support/whole_file.h"
#include "ui/dialogs/comparison_model.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/files/held_file.h"
#include "ui/files/save_name.h"
#include "ui/models/word_filter.h"
#include "ui/session/project_document.h"
#include "ui/session/run_difference.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"
#include "ui/text/finding_text.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

/// Entries of the boxes that ask for more.
constexpr int kAskForFile = -1, kAskForBus = -2;
constexpr int kEditDelay = 200;  // ms without another edit

bool someMachineRuns(Workspace& workspace) {
  const auto phase = workspace.live().phase();
  return phase == LiveSession::Phase::kOnline || phase == LiveSession::Phase::kStarting;
}

}  // namespace

/// Differences, with the places that they belong to.
class ComparisonFilter final : public WordFilter {
 public:
  explicit ComparisonFilter(QObject* parent) : WordFilter(ComparisonModel::kWordsRole, parent) {}
  void setOnlyMatters(bool only) {
    only_matters_ = only;
    invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    if (!parent.isValid()) return false;  // comes along
    if (only_matters_ && !sourceModel()->index(row, 0, parent).data(ComparisonModel::kMattersRole).toBool())
      return false;
    return WordFilter::filterAcceptsRow(row, parent);
  }

 private:
  bool only_matters_ = false;
};

CompareDialog::CompareDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent), workspace_(workspace), comparison_(workspace.environment().compare_bus) {
  setObjectName(QStringLiteral("compareDialog"));
  setWindowTitle(tr("Compare"));
  resize(940, 520);
  model_ = new ComparisonModel(this);
  filter_ = new ComparisonFilter(this);
  filter_->setSourceModel(model_);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(8);
  layout->addWidget(buildSides());
  layout->addWidget(buildFilter());
  buildTree();
  layout->addWidget(tree_, 1);
  status_ = named(new QLabel, "compareStatus", tr("How many differences there are"));
  status_->setWordWrap(true);
  layout->addWidget(status_);
  layout->addWidget(buildButtons());
  connect(&comparison_, &Comparison::finished, this, &CompareDialog::showResult);
  edited_.setSingleShot(true);
  edited_.setInterval(kEditDelay);
  connect(&edited_, &QTimer::timeout, this, &CompareDialog::restart);
  connect(&workspace.document(), &ProjectDocument::projectChanged, this,
          [this] { onChange(ComparedSide::Kind::kProject); });
  connect(&workspace.live(), &LiveSession::applied, this, [this] { onChange(ComparedSide::Kind::kRunning); });
}

/// What is shown is of the machines as they are. A bus is not scanned again unasked.
void CompareDialog::onChange(ComparedSide::Kind kind) {
  if (std::ranges::find(chosen_, kind, &ComparedSide::kind) == std::end(chosen_)) return;
  if (!withBus()) return edited_.start();
  status_->setText(tr("Changed since it was compared; choose the bus once more to look again."));
}

bool CompareDialog::withBus() const { return chosen_[1].kind == ComparedSide::Kind::kBus; }

QWidget* CompareDialog::buildSides() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  left_ = sideBox("compareLeft", tr("Left side of the comparison"));
  right_ = sideBox("compareRight", tr("Right side of the comparison"));
  swap_ = named(new QToolButton, "compareSwap", tr("Exchange the two sides"));
  swap_->setText(QStringLiteral("\u21C4"));
  layout->addWidget(left_, 1);
  layout->addWidget(swap_);
  layout->addWidget(right_, 1);
  connect(swap_, &QToolButton::clicked, this, [this] { compare(chosen_[1], chosen_[0]); });
  return area;
}

QComboBox* CompareDialog::sideBox(const char* name, const QString& what) {
  auto* box = named(new QComboBox, name, what);
  box->setMinimumContentsLength(20);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(box, &QComboBox::activated, this, [this, box] { choose(*box); });
  return box;
}

QWidget* CompareDialog::buildFilter() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  words_ = named(new QLineEdit, "compareWords", tr("Search the differences"));
  words_->setPlaceholderText(tr("Search"));
  words_->setClearButtonEnabled(true);
  only_matters_ = named(new QCheckBox(tr("&Only what matters")), "compareOnlyMatters", tr("Only what matters"));
  only_matters_->setToolTip(tr("Leaves out names, and where data stand in the process image"));
  layout->addWidget(words_, 1);
  layout->addWidget(only_matters_);
  const auto filter = [this] {
    filter_->setWords(words_->text());
    filter_->setOnlyMatters(only_matters_->isChecked());
    tree_->expandAll();
  };
  connect(words_, &QLineEdit::textChanged, this, filter);
  connect(only_matters_, &QCheckBox::toggled, this, filter);
  return area;
}

void CompareDialog::buildTree() {
  tree_ = named(new QTreeView, "compareTree", tr("Differences"));
  tree_->setModel(filter_);
  tree_->setUniformRowHeights(true);
  tree_->setAlternatingRowColors(true);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  tree_->setColumnWidth(ComparisonModel::kWhat, 330);
  tree_->setColumnWidth(ComparisonModel::kLeft, 210);
  tree_->setColumnWidth(ComparisonModel::kRight, 210);
  tree_->header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  connect(tree_, &QTreeView::clicked, this, &CompareDialog::goTo);
  connect(tree_, &QTreeView::activated, this, &CompareDialog::goTo);
}

QWidget* CompareDialog::buildButtons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  copy_ = named(new QPushButton(tr("&Copy")), "compareCopy", tr("Copy the differences as text"));
  export_ = named(new QPushButton(tr("&Export CSV…")), "compareExport", tr("Write the differences to a file"));
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(export_, QDialogButtonBox::ActionRole);
  connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text(u'\t', false)); });
  connect(export_, &QPushButton::clicked, this, &CompareDialog::exportCsv);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return buttons;
}

ComparedSide CompareDialog::usualSide(Workspace& workspace) {
  if (someMachineRuns(workspace)) return {ComparedSide::Kind::kRunning};
  const auto& path = workspace.document().path();
  return path.isEmpty() ? ComparedSide{} : ComparedSide{ComparedSide::Kind::kFile, path};
}

void CompareDialog::fill(QComboBox& box) {
  box.clear();
  const auto add = [&](const ComparedSide& side) {
    box.addItem(sideName(side), static_cast<int>(side.kind));
    box.setItemData(box.count() - 1, side.path, Qt::UserRole + 1);
    if (!side.path.isEmpty()) box.setItemData(box.count() - 1, side.path, Qt::ToolTipRole);
  };
  add({ComparedSide::Kind::kProject});
  if (someMachineRuns(workspace_)) add({ComparedSide::Kind::kRunning});
  for (const auto& side : chosen_) {
    if (side.path.isEmpty() || (&box == left_ && side.kind == ComparedSide::Kind::kBus)) continue;
    if (box.findData(side.path, Qt::UserRole + 1) < 0) add(side);
  }
  box.addItem(tr("File…"), kAskForFile);
  const bool bus = workspace_.environment().compare_bus != nullptr && !someMachineRuns(workspace_);
  if (&box == right_ && bus) box.addItem(tr("Bus…"), kAskForBus);
}

ComparedSide CompareDialog::side(const QComboBox& box) const {
  return {static_cast<ComparedSide::Kind>(box.currentData().toInt()), box.currentData(Qt::UserRole + 1).toString()};
}

void CompareDialog::select(QComboBox& box, const ComparedSide& side) {
  for (int i = 0; i < box.count(); ++i) {
    if (box.itemData(i).toInt() == static_cast<int>(side.kind) &&
        box.itemData(i, Qt::UserRole + 1).toString() == side.path)
      box.setCurrentIndex(i);
  }
}

QString CompareDialog::sideName(const ComparedSide& side) const {
  switch (side.kind) {
    case ComparedSide::Kind::kProject:
      return tr("Project (%1)").arg(workspace_.document().displayName());
    case ComparedSide::Kind::kRunning:
      return tr("Running machine");
    case ComparedSide::Kind::kBus:
      return tr("Bus on %1").arg(side.path);
    case ComparedSide::Kind::kFile:
      break;
  }
  return QFileInfo(side.path).fileName();
}

/// An entry of a box: a side, or the question for one.
void CompareDialog::choose(QComboBox& box) {
  auto& mine = chosen_[&box == left_ ? 0 : 1];
  auto wanted = side(box);
  if (box.currentData().toInt() == kAskForFile) {
    const auto path = QFileDialog::getOpenFileName(
        this, tr("Compare With"), {}, tr("Projects and ENI files (*.syncline *.xml *.eni);;All files (*)"));
    wanted = path.isEmpty() ? mine : ComparedSide{ComparedSide::Kind::kFile, path};
  } else if (box.currentData().toInt() == kAskForBus) {
    LinkChooser chooser(workspace_.environment(), workspace_.usualLink(), tr("Compare"), this);
    wanted = chooser.exec() == QDialog::Accepted ? ComparedSide{ComparedSide::Kind::kBus, chooser.link()} : mine;
  }
  mine = wanted;
  restart();
}

void CompareDialog::compare(const ComparedSide& left, const ComparedSide& right) {
  chosen_[0] = left;
  chosen_[1] = right;
  restart();
}

void CompareDialog::restart() {
  for (auto* box : {left_, right_}) {
    fill(*box);
    select(*box, chosen_[box == left_ ? 0 : 1]);
  }
  edited_.stop();
  swap_->setEnabled(!withBus());
  swap_->setToolTip(withBus() ? tr("A bus can only stand on the right") : tr("Exchange the two sides"));
  for (auto* button : {copy_, export_}) button->setEnabled(false);
  if (chosen_[0] == chosen_[1]) {
    model_->setCompared({}, sideName(chosen_[0]), sideName(chosen_[1]), std::nullopt);
    return status_->setText(tr("Choose what the project is to be compared with."));
  }
  status_->setText(tr("Comparing…"));
  comparison_.start(chosen_[0], chosen_[1], workspace_.document().project(), workspace_.runDifference().running());
}

void CompareDialog::showResult() {
  const auto& result = comparison_.result();
  const int place = tree_->verticalScrollBar()->value();
  const auto is = [this](int side) { return chosen_[side].kind == ComparedSide::Kind::kProject; };
  const auto project_is_left = is(0) ? std::optional(true) : is(1) ? std::optional(false) : std::nullopt;
  model_->setCompared(result.value_or(Compared{}), sideName(chosen_[0]), sideName(chosen_[1]), project_is_left);
  tree_->expandAll();
  tree_->verticalScrollBar()->setValue(place);
  copy_->setEnabled(model_->differences() > 0);
  export_->setEnabled(model_->differences() > 0);
  if (comparison_.failure()) return status_->setText(errorText(*comparison_.failure()));
  auto told = model_->differences() == 0 ? tr("There is no difference.")
                                         : tr("%n difference(s)", nullptr, model_->differences());
  if (const int changes = model_->changes(); changes > 0 && changes < model_->differences())
    told += u' ' + tr("(%n of them are changes of the project; the others follow from these, or change nothing)",
                      nullptr, changes);
  if (!result->unread.empty()) told += u' ' + findingWhole(result->unread.front());
  status_->setText(told);
}

void CompareDialog::goTo(const QModelIndex& index) {
  if (!index.isValid()) return;
  const auto first = index.siblingAtColumn(0);
  const auto key = first.data(ComparisonModel::kKeyRole).toString();
  const int node = first.data(ComparisonModel::kNodeRole).toInt();
  if (node != ComparisonModel::kNoNode) Q_EMIT placeWanted(node, key);
}

QString CompareDialog::text(QChar separator, bool quoted) const {
  QStringList lines;
  const auto put = [&](QStringList fields) {
    if (quoted) {
      for (auto& field : fields) field = QString::fromStdString(csv_field(field.toStdString()));
    }
    lines.append(fields.join(separator));
  };
  QStringList titles{tr("Where")};
  for (int column = 0; column < ComparisonModel::kColumns; ++column)
    titles.append(filter_->headerData(column, Qt::Horizontal).toString());
  put(titles);
  for (int node = 0; node < filter_->rowCount(); ++node) {
    const auto parent = filter_->index(node, 0);
    for (int row = 0; row < filter_->rowCount(parent); ++row) {
      QStringList fields{parent.data().toString()};
      for (int column = 0; column < ComparisonModel::kColumns; ++column)
        fields.append(filter_->index(row, column, parent).data().toString());
      put(fields);
    }
  }
  return lines.join(u'\n') + u'\n';
}

void CompareDialog::exportCsv() {
  const auto title = tr("Export Differences");
  const auto path = QFileDialog::getSaveFileName(this, title, QStringLiteral("differences.csv"),
                                                 tr("Comma-separated values (*.csv)"));
  if (const auto complete = withSuffix(this, title, path, QStringLiteral(".csv")); !complete.isEmpty())
    exportTo(complete);
}

bool CompareDialog::exportTo(const QString& path) {
  auto status = mayWrite(path);
  if (status) status = write_whole_file(path.toStdString(), text(u',', true).toStdString());
  if (!status) showError(this, tr("The differences could not be written."), status.error());
  return status.has_value();
}

}  // namespace syncline::ui
