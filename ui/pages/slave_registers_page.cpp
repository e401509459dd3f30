// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_registers_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "protocol/registers.h"
#include "support/byte_order.h"
#include "support/le_number.h"
#include "ui/dialogs/questions.h"
#include "ui/models/register_model.h"
#include "ui/models/word_filter.h"
#include "ui/session/workspace.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/poll_choice.h"
#include "ui/widgets/tables.h"
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
class RegisterFilter final : public WordFilter {
 public:
  explicit RegisterFilter(QObject* parent) : WordFilter(RegisterModel::kWordsRole, parent) {}
  void setGroup(int group) {
    group_ = group;
    invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const auto index = sourceModel()->index(row, 0, parent);
    if (group_ != kAllGroups && index.data(RegisterModel::kGroupRole).toInt() != group_) return false;
    return WordFilter::filterAcceptsRow(row, parent);
  }

 private:
  int group_ = kAllGroups;
};

SlaveRegistersPage::SlaveRegistersPage(Workspace& workspace)
    : OnlinePage(workspace, "slaveRegistersPage", tr("Registers")) {
  model_ = new RegisterModel(this);
  filter_ = new RegisterFilter(this);
  filter_->setSourceModel(model_);
  auto* layout = build();
  layout->addWidget(buildChoice());
  tree_ = named(new QTreeView, "registerTree", tr("Registers of the slave"));
  tree_->setModel(filter_);
  setUpTree(*tree_);
  const std::pair<RegisterModel::Column, int> widths[] = {{RegisterModel::kAddress, 108},
                                                          {RegisterModel::kName, 250},
                                                          {RegisterModel::kValue, 170},
                                                          {RegisterModel::kDigits, 150}};
  for (const auto& [column, width] : widths) tree_->setColumnWidth(column, width);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &SlaveRegistersPage::showSelected);
  connect(filter_, &QAbstractItemModel::modelReset, this, &SlaveRegistersPage::showSelected);
  connect(tree_, &QTreeView::activated, this, &SlaveRegistersPage::readSelected);
  layout->addWidget(tree_, 1);
  layout->addWidget(buildWriting());
  layout->addWidget(buildStatus("registerStatus"));
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
  poll_ = named(new PollChoice(tr("On demand"), tr("Every %1 s"), {500, 1000, 5000}), "registerPoll",
                tr("How often the shown registers are read"));
  layout->addWidget(group_);
  layout->addWidget(words_, 1);
  layout->addWidget(read_);
  layout->addWidget(read_selected_);
  layout->addWidget(poll_);
  connect(group_, &QComboBox::activated, this, [this] { filter_->setGroup(group_->currentData().toInt()); });
  connect(words_, &QLineEdit::textChanged, filter_, &RegisterFilter::setWords);
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
  connect(value_, &QLineEdit::textChanged, this, &SlaveRegistersPage::enableWrite);
  connect(value_, &QLineEdit::returnPressed, write_, &QPushButton::click);
  connect(write_, &QPushButton::clicked, this, &SlaveRegistersPage::write);
  return writing_;
}

void SlaveRegistersPage::slaveChanged() {
  poll_->reset();
  complained_ = false;
  model_->setUnits(8, 8);
  projectChanged();
}

void SlaveRegistersPage::projectChanged() { writing_->setVisible(expert()); }

QModelIndex SlaveRegistersPage::current() const { return filter_->mapToSource(tree_->currentIndex()); }

/// What is typed stays as long as its register is selected.
void SlaveRegistersPage::showSelected() {
  const auto* layout = model_->layout(current());
  const int address = layout == nullptr ? kNone : layout->address;
  if (address != std::exchange(selected_address_, address)) value_->clear();
  value_->setEnabled(layout != nullptr);
  selected_->setText(layout == nullptr ? tr("Choose a register to write it.")
                                       : QStringLiteral("%1 %2").arg(hexText(layout->address, 4),
                                                                     QString::fromStdString(layout->name)));
  enableWrite();
}

void SlaveRegistersPage::enableWrite() {
  const auto* one = model_->layout(current());
  write_->setEnabled(possible() && one != nullptr && registerValue(value_->text(), one->length).has_value());
}

void SlaveRegistersPage::tick(std::optional<Nanoseconds> now) {
  for (auto* button : {read_, read_selected_}) button->setEnabled(possible());
  poll_->setEnabled(possible());
  enableWrite();
  if (!now) return model_->setNow(std::nullopt);
  if (possible() && round_.open == 0 && poll_->due(*now)) readShown();
  if (*now - aged_ < kAgeing && *now >= aged_) return;
  aged_ = *now;
  model_->setNow(*now);
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
  for (const auto& range : reg::ranges_of(wanted)) read(range);
}

void SlaveRegistersPage::readSelected() {
  const auto* layout = model_->layout(current());
  if (layout == nullptr) return say(tr("Choose a register first."));
  read({layout->address, layout->length});
}

void SlaveRegistersPage::read(reg::RegisterRange range) {
  const auto slave = running();
  if (!slave || !possible()) return;
  ++round_.open;
  post(
      requests::RegisterRead{slave->position, range.address, range.length},
      [this, range](const RequestOutcome& outcome) { take(range, outcome); }, RequestUrgency::kBackground);
}

void SlaveRegistersPage::take(reg::RegisterRange range, const RequestOutcome& outcome) {
  if (outcome.ok()) {
    model_->setValues(range.address, outcome.answer.data, outcome.answer.time);
    if (range.address == reg::kType && adaptUnits()) return;  // a new round has begun
  } else if (outcome.answer.error && outcome.answer.error->code == ErrorCode::kWorkingCounter) {
    round_.missing.push_back(range);
    round_.why = outcome.why;
  } else {
    complain(outcome.why);
  }
  if (outcome.ok() && round_.missing.empty() && std::exchange(complained_, false)) say({});
  settle();
}

void SlaveRegistersPage::settle() {
  if (--round_.open == 0 && !round_.missing.empty()) proveMissing();
}

/// A slave behind a pulled cable processes nothing either: every ESC has an AL status.
void SlaveRegistersPage::proveMissing() {
  const auto slave = running();
  const auto round = std::exchange(round_, {});
  if (!slave) return;
  round_.open = 1;
  const auto prove = [this, round](const RequestOutcome& outcome) {
    if (!outcome.ok()) complain(round.why);
    for (const auto& range : outcome.ok() ? round.missing : std::vector<reg::RegisterRange>{})
      model_->setFailure(range.address, range.length, tr("not in this ESC"));
    settle();
  };
  post(requests::RegisterRead{slave->position, reg::kAlStatus, 2}, prove, RequestUrgency::kBackground);
}

void SlaveRegistersPage::complain(const QString& why) {
  complained_ = true;
  say(why, true);
}

/// The ESC says how many FMMUs and SyncManagers it has; those that it has not go. True: reading has begun anew.
bool SlaveRegistersPage::adaptUnits() {
  const auto fmmus = model_->value(reg::kFmmuCount), managers = model_->value(reg::kSyncManagerCount);
  if (fmmus.empty() || managers.empty()) return false;
  const auto count = [this](reg::RegisterGroup group) {
    return static_cast<std::size_t>(std::ranges::count(model_->layouts(), group, &reg::RegisterLayout::group));
  };
  const auto as_many = reg::register_layouts(fmmus.front(), managers.front());
  const auto same = [&](reg::RegisterGroup group) {
    return count(group) == static_cast<std::size_t>(std::ranges::count(as_many, group, &reg::RegisterLayout::group));
  };
  if (same(reg::RegisterGroup::kFmmus) && same(reg::RegisterGroup::kSyncManagers)) return false;
  stopAsking();
  const auto* selected = model_->layout(current());
  const int address = selected == nullptr ? kNone : selected->address;
  const auto typed = value_->text();
  model_->setUnits(fmmus.front(), managers.front());
  const auto& layouts = model_->layouts();
  const auto at = std::ranges::find(layouts, address, &reg::RegisterLayout::address);
  if (at != layouts.end()) {
    tree_->setCurrentIndex(filter_->mapFromSource(model_->index(static_cast<int>(at - layouts.begin()), 0)));
    value_->setText(typed);
  }
  readShown();
  return true;
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
  complained_ = false;
  post(requests::RegisterWrite{slave->position, address, bytes},
       [this, address, bytes, what](const RequestOutcome& outcome) {
         if (!outcome.ok()) return say(outcome.why, true);
         readBack(address, bytes, what);
       });
}

/// An ESC may take a value and show another one: bits that it has not, or that it clears itself.
void SlaveRegistersPage::readBack(std::uint16_t address, const std::vector<std::uint8_t>& written,
                                  const QString& what) {
  const auto slave = running();
  if (!slave) return;
  const auto length = static_cast<std::uint16_t>(written.size());
  post(requests::RegisterRead{slave->position, address, length},
       [this, address, written, what](const RequestOutcome& outcome) {
         if (!outcome.ok()) return say(tr("Written, but not to be read back: %1").arg(outcome.why), true);
         const auto& shown = outcome.answer.data;
         model_->setValues(address, shown, outcome.answer.time);
         const auto text = hexText(le_number(shown), static_cast<int>(2 * shown.size()));
         if (shown == written) return say(tr("%1 is %2 now.").arg(what, text));
         say(tr("Written, but the register shows %1.").arg(text), true);
       });
}

}  // namespace syncline::ui
