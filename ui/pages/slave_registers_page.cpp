// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_registers_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "protocol/registers.h"
#include "support/byte_order.h"
#include "ui/dialogs/questions.h"
#include "ui/models/register_model.h"
#include "ui/session/workspace.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr int kAllGroups = -1;
constexpr Nanoseconds kAgeing = 200 * kMillisecond;

/// "0x0300" or "768"; nothing when it does not fit.
std::optional<std::uint64_t> registerValue(const QString& text, unsigned bytes) {
  const auto trimmed = text.trimmed();
  bool good = false;
  const bool hex = trimmed.startsWith(QStringLiteral("0x"), Qt::CaseInsensitive);
  const auto value = hex ? trimmed.sliced(2).toULongLong(&good, 16) : trimmed.toULongLong(&good, 10);
  if (!good || (bytes < 8 && value >> (8 * bytes) != 0)) return std::nullopt;
  return value;
}

}  // namespace

/// Registers of a group in which all words occur.
class RegisterFilter final : public QSortFilterProxyModel {
 public:
  explicit RegisterFilter(QObject* parent) : QSortFilterProxyModel(parent) { setRecursiveFilteringEnabled(true); }
  void set(int group, const QString& words) {
    group_ = group;
    words_ = words.split(u' ', Qt::SkipEmptyParts);
    invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const auto index = sourceModel()->index(row, 0, parent);
    if (group_ != kAllGroups && index.data(RegisterModel::kGroupRole).toInt() != group_) return false;
    // Fields come along with their register.
    auto line = index.data(RegisterModel::kWordsRole).toString();
    if (parent.isValid()) line += u' ' + parent.data(RegisterModel::kWordsRole).toString();
    return std::ranges::all_of(words_, [&](const QString& word) { return line.contains(word, Qt::CaseInsensitive); });
  }

 private:
  int group_ = kAllGroups;
  QStringList words_;
};

SlaveRegistersPage::SlaveRegistersPage(Workspace& workspace)
    : OnlinePage(workspace, "slaveRegistersPage", tr("Registers")) {
  model_ = new RegisterModel(this);
  filter_ = new RegisterFilter(this);
  filter_->setSourceModel(model_);
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(6);
  layout->addWidget(hint());
  layout->addWidget(buildChoice());
  tree_ = named(new QTreeView, "registerTree", tr("Registers of the slave"));
  tree_->setModel(filter_);
  tree_->setUniformRowHeights(true);
  tree_->setAlternatingRowColors(true);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  tree_->setMinimumHeight(120);
  const std::pair<RegisterModel::Column, int> widths[] = {{RegisterModel::kAddress, 108},
                                                          {RegisterModel::kName, 250},
                                                          {RegisterModel::kValue, 170},
                                                          {RegisterModel::kDigits, 150}};
  for (const auto& [column, width] : widths) tree_->setColumnWidth(column, width);
  tree_->header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &SlaveRegistersPage::showSelected);
  connect(tree_, &QTreeView::activated, this, &SlaveRegistersPage::readSelected);
  layout->addWidget(tree_, 1);
  layout->addWidget(buildWriting());
  status_ = new ValueLabel;
  status_->setObjectName(QStringLiteral("registerStatus"));
  status_->setAccessibleName(tr("What became of the last request"));
  layout->addWidget(status_);
  setWidget(content);
}

QWidget* SlaveRegistersPage::buildChoice() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  group_ = named(new QComboBox, "registerGroup", tr("Which registers are shown and read"));
  group_->addItem(tr("All registers"), kAllGroups);
  for (std::size_t i = 0; i < reg::kRegisterGroups; ++i)
    group_->addItem(fromView(reg::register_group_name(static_cast<reg::RegisterGroup>(i))), static_cast<int>(i));
  words_ = named(new QLineEdit, "registerSearch", tr("Search registers"));
  words_->setPlaceholderText(tr("Address or name"));
  words_->setClearButtonEnabled(true);
  read_ = named(new QPushButton(tr("&Read Shown")), "registerRead", tr("Read the registers that are shown"));
  read_selected_ = named(new QPushButton(tr("Read &One")), "registerReadOne", tr("Read the selected register"));
  poll_ = named(new QComboBox, "registerPoll", tr("How often the shown registers are read"));
  poll_->addItem(tr("On demand"), 0);
  for (const int ms : {500, 1000, 5000}) poll_->addItem(tr("Every %1 s").arg(QLocale().toString(ms / 1000.0)), ms);
  layout->addWidget(group_);
  layout->addWidget(words_, 1);
  layout->addWidget(read_);
  layout->addWidget(read_selected_);
  layout->addWidget(poll_);
  const auto choose = [this] { filter_->set(group_->currentData().toInt(), words_->text()); };
  connect(group_, &QComboBox::activated, this, choose);
  connect(words_, &QLineEdit::textChanged, this, choose);
  connect(read_, &QPushButton::clicked, this, [this] { readShown(); });
  connect(read_selected_, &QPushButton::clicked, this, &SlaveRegistersPage::readSelected);
  return area;
}

QWidget* SlaveRegistersPage::buildWriting() {
  writing_ = new QWidget;
  auto* layout = new QHBoxLayout(writing_);
  layout->setContentsMargins(0, 0, 0, 0);
  selected_ = new ValueLabel;
  selected_->setObjectName(QStringLiteral("registerSelected"));
  selected_->setMinimumWidth(100);
  value_ = named(new QLineEdit, "registerValue", tr("New value, decimal or with 0x"));
  value_->setMaximumWidth(200);
  write_ = named(new QPushButton(tr("&Write…")), "registerWrite", tr("Write the register"));
  layout->addWidget(selected_, 1);
  layout->addWidget(value_);
  layout->addWidget(write_);
  connect(value_, &QLineEdit::textChanged, this, [this] {
    const auto* one = model_->layout(current());
    write_->setEnabled(possible_ && one != nullptr && registerValue(value_->text(), one->length).has_value());
  });
  connect(value_, &QLineEdit::returnPressed, write_, &QPushButton::click);
  connect(write_, &QPushButton::clicked, this, &SlaveRegistersPage::write);
  return writing_;
}

void SlaveRegistersPage::slaveChanged() {
  waiting_ = 0;
  poll_->setCurrentIndex(0);
  model_->setUnits(8, 8);
  say({});
  projectChanged();
}

void SlaveRegistersPage::projectChanged() {
  writing_->setVisible(expert());
  showSelected();
}

QModelIndex SlaveRegistersPage::current() const { return filter_->mapToSource(tree_->currentIndex()); }

void SlaveRegistersPage::showSelected() {
  const auto* layout = model_->layout(current());
  value_->setEnabled(layout != nullptr);
  selected_->setText(layout == nullptr ? tr("Choose a register to write it.")
                                       : QStringLiteral("%1 %2").arg(hexText(layout->address, 4),
                                                                     QString::fromStdString(layout->name)));
  value_->clear();
  write_->setEnabled(false);
}

void SlaveRegistersPage::tick(const Snapshot& snapshot, const QString& obstacle) {
  possible_ = obstacle.isEmpty();
  for (auto* button : {read_, read_selected_}) button->setEnabled(possible_);
  poll_->setEnabled(possible_);
  if (!possible_) write_->setEnabled(false);
  const int period = poll_->currentData().toInt();
  if (possible_ && period > 0 && waiting_ == 0 && snapshot.time - polled_ >= period * kMillisecond) {
    polled_ = snapshot.time;
    readShown();
  }
  if (snapshot.time - aged_ < kAgeing && snapshot.time >= aged_) return;
  aged_ = snapshot.time;
  model_->setNow(snapshot.time);
}

// ---- requests -----------------------------------------------------------------------------------

/// Where reading takes something away it is done only for the register that is asked for.
void SlaveRegistersPage::readShown() {
  std::vector<const reg::RegisterLayout*> wanted;
  for (int row = 0; row < filter_->rowCount(); ++row) {
    const auto* layout = model_->layout(filter_->mapToSource(filter_->index(row, 0)));
    if (layout != nullptr && !layout->reading_matters) wanted.push_back(layout);
  }
  if (wanted.empty()) return say(tr("No register is shown that could be read along: choose one and read it alone."));
  for (const auto& range : reg::ranges_of(wanted)) read(range.address, range.length);
}

void SlaveRegistersPage::readSelected() {
  const auto* layout = model_->layout(current());
  if (layout == nullptr) return say(tr("Choose a register first."));
  read(layout->address, layout->length);
}

void SlaveRegistersPage::read(std::uint16_t address, std::uint16_t length) {
  const auto slave = running();
  if (!slave || !possible_) return;
  ++waiting_;
  post(
      requests::RegisterRead{slave->position, address, length},
      [this, address, length](const RequestOutcome& outcome) { take(address, length, outcome); },
      RequestUrgency::kBackground);
}

void SlaveRegistersPage::take(std::uint16_t address, std::uint16_t length, const RequestOutcome& outcome) {
  if (waiting_ > 0) --waiting_;
  if (outcome.ok()) {
    model_->setValues(address, outcome.answer.data, outcome.answer.time);
    if (address == reg::kType) adaptUnits();
  } else if (outcome.answer.error && outcome.answer.error->code == ErrorCode::kWorkingCounter) {
    model_->setFailure(address, length, tr("not in this ESC"));
  } else {
    say(outcome.why, true);
  }
  if (waiting_ == 0 && outcome.ok()) say({});
}

/// The ESC says how many FMMUs and SyncManagers it has; those that it has not go.
void SlaveRegistersPage::adaptUnits() {
  const auto fmmus = model_->value(reg::kFmmuCount), managers = model_->value(reg::kSyncManagerCount);
  if (fmmus.empty() || managers.empty()) return;
  const auto count = [this](reg::RegisterGroup group) {
    return static_cast<std::size_t>(std::ranges::count(model_->layouts(), group, &reg::RegisterLayout::group));
  };
  const auto as_many = reg::register_layouts(fmmus.front(), managers.front());
  const auto same = [&](reg::RegisterGroup group) {
    return count(group) == static_cast<std::size_t>(std::ranges::count(as_many, group, &reg::RegisterLayout::group));
  };
  if (same(reg::RegisterGroup::kFmmus) && same(reg::RegisterGroup::kSyncManagers)) return;
  workspace().requests().drop(*this);
  waiting_ = 0;
  model_->setUnits(fmmus.front(), managers.front());
  readShown();
}

void SlaveRegistersPage::write() {
  const auto* layout = model_->layout(current());
  if (layout == nullptr || !expert()) return;
  const auto number = registerValue(value_->text(), layout->length);
  if (!number) return;
  const auto what = QStringLiteral("%1 %2").arg(hexText(layout->address, 4), QString::fromStdString(layout->name));
  const auto address = layout->address;
  const std::uint8_t length = layout->length;
  const auto question = tr("Write %1 to register %2?").arg(hexText(*number, 2 * length), what);
  if (!ask(*window(), "registerQuestion", question,
           tr("The master has set this slave up and counts on its registers. A wrong value can stop the slave or the "
              "bus "
              "behind it, and nothing but going online anew puts it back."),
           tr("Write"))) {
    return;
  }
  const auto slave = running();
  if (!slave) return;
  const auto all = le_bytes(*number);
  std::vector<std::uint8_t> bytes(all.begin(), all.begin() + length);
  say(tr("%1 is written.").arg(what));
  post(requests::RegisterWrite{slave->position, address, std::move(bytes)},
       [this, address, length, what](const RequestOutcome& outcome) {
         if (!outcome.ok()) return say(outcome.why, true);
         read(address, length);
       });
}

void SlaveRegistersPage::say(const QString& text, bool bad) {
  status_->setText(text);
  auto colors = palette();
  if (bad) colors.setColor(QPalette::WindowText, theme::toneColor(colors, theme::Tone::kBad));
  status_->setPalette(colors);
}

}  // namespace syncline::ui
