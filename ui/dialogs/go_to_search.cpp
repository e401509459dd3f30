// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/go_to_search.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "config/module_slots.h"
#include "config/project.h"
#include "settings/settings_table.h"
#include "ui/models/dictionary.h"
#include "ui/text/setting_text.h"

namespace syncline::ui {

struct GoToSearch::Row {
  const settings::Setting* setting = nullptr;
  QString label, found_by;  // with the key's end, in lower case
  QString begin, end;       // of its key, around the slave's number
};

struct GoToSearch::Entry {
  coe::ObjectAddress object;
  QString name, found_by;
};

namespace {

/// Those that do not occur in `text`.
QStringList missing(const QStringList& words, const QString& text) {
  QStringList rest;
  for (const auto& word : words) {
    if (!text.contains(word)) rest.append(word);
  }
  return rest;
}

bool hasModules(const SlaveSettings& slave) { return !slot_places(slave.device).empty(); }

}  // namespace

GoToSearch::GoToSearch(const Project& project, int node)
    : project_(project), node_(node < 0 ? project.slaves.size() : static_cast<std::size_t>(node)) {
  constexpr auto kSlaveMark = "slave.N.";
  for (const auto& setting : settings::table()) {
    if (!setting.of_slave()) continue;
    const auto key = QString::fromStdString(setting.key);
    const auto label = settingLabel(setting);
    const auto end = key.mid(static_cast<qsizetype>(std::char_traits<char>::length(kSlaveMark)) - 1);
    rows_.push_back({&setting, label, (label + u' ' + end).toLower(), QStringLiteral("slave."), end});
  }
}

GoToSearch::~GoToSearch() = default;

/// What of a slave stands for what is its own.
QString GoToSearch::wordsOf(std::size_t slave) const {
  const auto& settings = project_.slaves[slave];
  return (QString::fromStdString(settings.name) +
          QStringLiteral(" slave.%1. %2").arg(slave).arg(settings.station_address))
      .toLower();
}

std::vector<GoToSearch::Found> GoToSearch::settings(const QStringList& words, std::size_t most) const {
  std::vector<Found> found;
  std::vector<std::pair<const Row*, QStringList>> rows;
  for (const auto& row : rows_) rows.emplace_back(&row, missing(words, row.found_by));
  for (std::size_t i = 0; i < project_.slaves.size() && found.size() < most; ++i) {
    if (i == node_) continue;
    const auto& slave = project_.slaves[i];
    const auto of_slave = wordsOf(i);
    for (const auto& [row, rest] : rows) {
      if (found.size() == most) break;
      const auto own = missing(rest, of_slave);
      if (!own.isEmpty() && !missing(own, row->begin + QString::number(i) + row->end).isEmpty()) continue;
      const auto& setting = *row->setting;
      if (setting.applies && !setting.applies(slave)) continue;
      settings::Place place{.slave = i};
      if (setting.items) {  // the first one leads to all of them
        const auto items = setting.items(project_, i);
        if (items.empty()) continue;
        place = items.front();
      }
      const auto key = QString::fromStdString(settings::key_of(setting, place));
      found.push_back({static_cast<int>(i),
                       QStringLiteral("%1, %2").arg(row->label, QString::fromStdString(slave.name)), key, key});
    }
  }
  return found;
}

std::shared_ptr<const GoToSearch::Entries> GoToSearch::entriesOf(const SlaveSettings& slave) const {
  auto entries = std::make_shared<Entries>();
  const auto add = [&entries](coe::ObjectAddress object, const QString& name) {
    const auto text = objectText(object);
    entries->push_back({object, name, (text + u' ' + name).toLower()});
  };
  for (const auto& object : dictionaryOf(slave)) {
    if (object.single || object.entries.empty()) {
      add({object.index, 0}, object.name);
      continue;
    }
    for (const auto& entry : object.entries) {
      const bool whole = entry.name == object.name || entry.name.isEmpty();
      add({object.index, entry.sub_index}, whole ? object.name : object.name + QStringLiteral(", ") + entry.name);
    }
  }
  return entries;
}

/// Slaves of one kind share what their description says.
void GoToSearch::readDictionaries() const {
  if (!dictionaries_.empty()) return;
  using Kind = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string, std::size_t>;
  std::map<Kind, std::shared_ptr<const Entries>> known;
  for (const auto& slave : project_.slaves) {
    const auto& device = slave.device;
    if (hasModules(slave)) {
      dictionaries_.push_back(entriesOf(slave));
      continue;
    }
    auto& entries = known[{device.identity.vendor_id, device.identity.product_code, device.identity.revision_no,
                           device.source, device.dictionary.size()}];
    if (!entries) entries = entriesOf(slave);
    dictionaries_.push_back(entries);
  }
}

std::vector<GoToSearch::Found> GoToSearch::objects(const QStringList& words, std::size_t most) const {
  readDictionaries();
  std::vector<Found> found;
  // The selected slave's own first.
  std::vector<std::size_t> order;
  if (node_ < project_.slaves.size()) order.push_back(node_);
  for (std::size_t i = 0; i < project_.slaves.size(); ++i) {
    if (i != node_) order.push_back(i);
  }
  std::map<const Entries*, std::vector<std::pair<const Entry*, QStringList>>> candidates;
  for (const auto i : order) {
    if (found.size() == most) break;
    const auto* entries = dictionaries_[i].get();
    auto [at, fresh] = candidates.try_emplace(entries);
    if (fresh) {
      for (const auto& entry : *entries) {
        auto rest = missing(words, entry.found_by);
        if (rest.size() < words.size()) at->second.emplace_back(&entry, std::move(rest));
      }
    }
    if (at->second.empty()) continue;
    const auto of_slave = wordsOf(i);
    const auto name = QString::fromStdString(project_.slaves[i].name);
    for (const auto& [entry, rest] : at->second) {
      if (found.size() == most) break;
      if (!missing(rest, of_slave).isEmpty()) continue;
      found.push_back({static_cast<int>(i),
                       QStringLiteral("%1, %2").arg(entry->name, name),
                       objectText(entry->object),
                       {},
                       entry->object});
    }
  }
  return found;
}

}  // namespace syncline::ui
