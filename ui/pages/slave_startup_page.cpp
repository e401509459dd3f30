// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_startup_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "config/network_config.h"
#include "config/startup_messages.h"
#include "config/sync_unit_cycle.h"
#include "protocol/coe_data_type.h"
#include "protocol/object_value.h"
#include "settings/predicates.h"
#include "settings/startup_text.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/item_list.h"
#include "ui/editors/object_picker.h"
#include "ui/editors/record_editor.h"
#include "ui/editors/record_form.h"
#include "ui/models/dictionary.h"
#include "ui/pages/message_parts.h"
#include "ui/pages/startup_parts.h"
#include "ui/session/workspace.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr const char *kCoeKey = "slave.N.startup.K", *kSoeKey = "slave.N.soe.K";
constexpr int kAsDictionary = -1;

/// What Add appends sends nothing before the user says what.
constexpr const char *kFreshCoe = "PS 0x2000:00=00 off", *kFreshSoe = "PS 0:S-0-0001=0000 off",
                     *kFreshMessage = "PS data=00 off";

struct MessageList {
  MailboxType type;
  const char *name, *key;
};
constexpr MessageList kMessageLists[] = {{MailboxType::kAoe, "aoeMessage", "slave.N.aoe.startup.K"},
                                         {MailboxType::kEoe, "eoeMessage", "slave.N.eoe.startup.K"},
                                         {MailboxType::kFoe, "foeMessage", "slave.N.foe.startup.K"},
                                         {MailboxType::kVoe, "voeMessage", "slave.N.voe.startup.K"}};

}  // namespace

SlaveStartupPage::SlaveStartupPage(Workspace& workspace) : Page(workspace, "slaveStartupPage", tr("Start-up")) {
  const auto nothing = tr("None: the slave starts with what it has.");
  const ShownDevice device = [this] { return slave() != nullptr ? &slave()->device : nullptr; };
  coe_ = new RecordEditor(*this, "startup", tr("Objects (CoE)"),
                          itemList(*this, kCoeKey, tr("start-up command"), nothing, kFreshCoe),
                          coeParts([this](const StartupCommand& command) { return typeOf(command); }, device), true);
  soe_ = new RecordEditor(*this, "soe", tr("Parameters (SoE)"),
                          itemList(*this, kSoeKey, tr("SoE start-up command"), nothing, kFreshSoe), soeParts(device),
                          true);
  addTypes();
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 10, 12, 10);
  layout->setSpacing(14);
  layout->addWidget(coe_, 1);
  sent_ = named(new QLabel, "startupSent", tr("What is sent otherwise than listed"));
  sent_->setWordWrap(true);
  sent_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(sent_);
  layout->addWidget(soe_, 1);
  for (const auto& [type, name, key] : kMessageLists) {
    const auto protocol = std::ranges::find(kMessageProtocols, type, &MessageProtocol::type);
    const auto title = QString::fromUtf8(protocol->name.data(), static_cast<int>(protocol->name.size()));
    auto* editor = new RecordEditor(*this, name, tr("Messages (%1)").arg(title),
                                    itemList(*this, key, tr("start-up message"), nothing, kFreshMessage),
                                    messageParts(type, device), true);
    editor->foldWhenEmpty();
    messages_.push_back({editor, &*protocol, key});
    layout->addWidget(editor, 1);
  }
  layout->addStretch();
  setWidget(content);
}

/// How the value is written is a matter of looking: it is no setting.
void SlaveStartupPage::addTypes() {
  type_ = named(new ChoiceEdit, "coeType", tr("Data type"));
  type_->setToolTip(tr("As what the value is written; the command holds its bytes"));
  coe_->card().form()->insertRow(3, tr("Data type"), type_);
  connect(type_, &QComboBox::activated, this, [this] {
    const auto command = selected();
    if (!command) return;
    const std::tuple key{node(), command->index, command->sub_index};
    const int code = type_->currentData().toInt();
    if (code == kAsDictionary) {
      wanted_types_.erase(key);
    } else {
      wanted_types_[key] = static_cast<std::uint16_t>(code);
    }
    refresh();
  });
  choose_ = named(new QPushButton(tr("Choose Object…")), "coeChoose", tr("Choose an object of the device"));
  connect(static_cast<QPushButton*>(choose_), &QPushButton::clicked, this, &SlaveStartupPage::chooseObject);
  coe_->card().addWide(choose_);
}

const SlaveSettings* SlaveStartupPage::slave() const {
  const auto& slaves = project().slaves;
  return node() >= 0 && std::cmp_less(node(), slaves.size()) ? &slaves[static_cast<std::size_t>(node())] : nullptr;
}

std::uint16_t SlaveStartupPage::typeOf(const StartupCommand& command) const {
  const auto wanted = wanted_types_.find({node(), command.index, command.sub_index});
  if (wanted != wanted_types_.end()) return wanted->second;
  return slave() != nullptr ? usualType(slave()->device, command) : kBytesType;
}

std::optional<StartupCommand> SlaveStartupPage::selected() const {
  const auto* of = slave();
  const int row = coe_->row();
  if (of == nullptr || row < 0 || std::cmp_greater_equal(row, of->startup.size())) return {};
  return of->startup[static_cast<std::size_t>(row)];
}

void SlaveStartupPage::showTypes() {
  const auto command = selected();
  type_->clear();
  type_->setEnabled(command.has_value());
  if (!command) return;
  const auto usual = usualType(slave()->device, *command);
  type_->addItem(tr("As described (%1)").arg(QString::fromStdString(data_type_name(usual))), kAsDictionary);
  type_->addItem(QStringLiteral("BYTES"), kBytesType);
  for (const auto& type : coe::data_types()) {
    if (type.code != 0)
      type_->addItem(QString::fromUtf8(type.name.data(), static_cast<int>(type.name.size())), type.code);
  }
  const auto wanted = wanted_types_.find({node(), command->index, command->sub_index});
  type_->setCurrentIndex(wanted == wanted_types_.end() ? 0 : type_->findData(wanted->second));
}

/// Object, comment and default value of the dictionary, in one step.
void SlaveStartupPage::chooseObject() {
  const auto command = selected();
  if (!command) return;
  auto* picker = new ObjectPicker(pickableObjects(slave()->device, ObjectUse::kWrite), this);
  picker->setAttribute(Qt::WA_DeleteOnClose);
  connect(picker, &ObjectPicker::picked, this, [this](const PickableObject& object) {
    auto changed = selected();
    if (!changed) return;
    changed->index = object.index;
    changed->sub_index = object.sub_index;
    changed->complete_access = false;
    changed->comment = object.name.simplified().toStdString();
    changed->data = object.default_data;
    changed->data.resize(std::max<std::size_t>((object.bits + 7U) / 8U, 1));
    coe_->form().replace(settings::format_startup(*changed));
  });
  picker->open();
}

bool SlaveStartupPage::appliesTo(int position) const {
  const auto& slaves = project().slaves;
  if (position < 0 || std::cmp_greater_equal(position, slaves.size())) return false;
  const auto& of = slaves[static_cast<std::size_t>(position)];
  return settings::has_coe(of) || settings::has_soe(of) || !of.startup.empty() || !of.soe_startup.empty() ||
         std::ranges::any_of(kMessageProtocols, [&](const MessageProtocol& protocol) {
           return speaks(of.device, protocol) || !(of.*protocol.startup).empty();
         });
}

void SlaveStartupPage::showPlace(const settings::Setting& setting, const settings::Place& place) {
  const auto item = static_cast<int>(place.item);
  if (setting.key == kCoeKey) coe_->select(item);
  if (setting.key == kSoeKey) soe_->select(item);
  for (const auto& list : messages_)
    if (setting.key == list.key) list.editor->select(item);
}

/// Values of the ESI that depend on the bus cycle are written for the one that is set.
void SlaveStartupPage::showSent() {
  QStringList sent;
  const auto* config = workspace().configuration().config();
  const auto at = static_cast<std::size_t>(node());
  if (config != nullptr && at < config->slaves.size() && config->slaves[at].mailbox) {
    const auto& listed = slave()->startup;
    for (const auto& cmd : config->slaves[at].mailbox->coe_commands) {
      const auto& command = cmd.command;
      const bool of_listed = std::ranges::find(listed, command.index, &StartupCommand::index) != listed.end();
      const bool as_listed = std::ranges::any_of(listed, [&command](const StartupCommand& one) {
        return one.index == command.index && one.sub_index == command.sub_index && one.data == command.data;
      });
      if (!of_listed || as_listed || command.data.size() > sizeof(std::uint64_t)) continue;
      std::uint64_t value = 0;
      for (std::size_t i = command.data.size(); i-- > 0;) value = value << 8 | command.data[i];
      sent << QStringLiteral("%1 = %2").arg(objectText({command.index, command.sub_index}),
                                            hexText(value, static_cast<int>(command.data.size()) * 2));
    }
  }
  sent_->setText(sent.isEmpty()
                     ? QString()
                     : tr("Sent for a bus cycle of %1, otherwise than listed: %2.")
                           .arg(cycleText(compiler::sync_unit_cycle(project().master, *slave())), joinedParts(sent)));
  sent_->setVisible(!sent.isEmpty());
}

void SlaveStartupPage::refresh() {
  const auto* of = slave();
  if (of == nullptr) return;
  coe_->setVisible(settings::has_coe(*of) || !of->startup.empty());
  soe_->setVisible(settings::has_soe(*of) || !of->soe_startup.empty());
  choose_->setVisible(!of->device.dictionary.empty());
  coe_->showRecords();
  soe_->showRecords();
  for (const auto& [editor, protocol, key] : messages_) {
    editor->setVisible(speaks(of->device, *protocol) || !(of->*protocol->startup).empty());
    editor->showRecords();
  }
  showTypes();
  fields().refresh();
  showSent();
  coe_->refreshButtons();
  soe_->refreshButtons();
  for (const auto& list : messages_) list.editor->refreshButtons();
  choose_->setEnabled(selected().has_value());
}

}  // namespace syncline::ui
