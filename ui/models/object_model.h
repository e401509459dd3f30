// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "protocol/coe.h"
#include "support/types.h"
#include "ui/models/dictionary.h"
#include "ui/models/grouped_model.h"

namespace syncline::ui {

/// Objects of a slave, below each its entries, with what was read of them. The first column is ticked where an entry is
/// watched.
class ObjectModel final : public GroupedModel {
  Q_OBJECT

 public:
  enum Column : int { kObject, kName, kType, kAccess, kUnit, kValue, kRaw, kColumnCount };
  enum Role {
    kWordsRole = Qt::UserRole + 1,  // what one may search for
    kWatchedRole,
    kExportRole,   // as it is shown, but a value only where one was read
    kDefaultRole,  // of the row's entry, as a value
  };

  explicit ObjectModel(QObject* parent = nullptr);

  /// Other objects; what was read stays where the entry does.
  void setDictionary(Dictionary dictionary);
  /// Takes all values away: they are another slave's.
  void clearValues();
  /// One object is known better now, or comes to the others.
  void setObject(DictionaryObject object);
  [[nodiscard]] const Dictionary& dictionary() const { return dictionary_; }

  void setValue(coe::ObjectAddress object, std::vector<std::uint8_t> bytes, Nanoseconds time);
  /// It could not be read; what was read before stays.
  void setFailure(coe::ObjectAddress object, const QString& why);
  void setWatched(const std::vector<coe::ObjectAddress>& objects);
  [[nodiscard]] std::vector<coe::ObjectAddress> watched() const;

  /// The entry of a row; null for an object that has several.
  [[nodiscard]] const DictionaryEntry* entry(const QModelIndex& index) const;
  [[nodiscard]] coe::ObjectAddress address(const QModelIndex& index) const;
  [[nodiscard]] QModelIndex find(coe::ObjectAddress object, int column = kObject) const;
  /// What was read; empty: nothing yet.
  [[nodiscard]] std::vector<std::uint8_t> value(coe::ObjectAddress object) const;

  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// By the user's tick.
  void watchedChanged();

 protected:
  [[nodiscard]] int groups() const override { return static_cast<int>(dictionary_.size()); }
  [[nodiscard]] int members(std::size_t group) const override;

 private:
  struct Reading {
    std::vector<std::uint8_t> bytes{};
    Nanoseconds time = 0;
    QString failure{};
    bool watched = false;
  };
  static std::uint32_t key(coe::ObjectAddress object) {
    return static_cast<std::uint32_t>(object.index) << 8 | object.sub_index;
  }
  [[nodiscard]] const Reading* reading(coe::ObjectAddress object) const;
  [[nodiscard]] QVariant text(const QModelIndex& index) const;
  [[nodiscard]] QVariant exportText(const QModelIndex& index) const;
  [[nodiscard]] QVariant toolTip(const QModelIndex& index) const;
  void tell(coe::ObjectAddress object);

  Dictionary dictionary_;
  std::map<std::uint32_t, Reading> readings_;
};

}  // namespace syncline::ui
