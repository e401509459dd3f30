// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "protocol/register_layout.h"
#include "support/types.h"
#include "ui/models/grouped_model.h"

namespace syncline::ui {

/// Registers of an ESC, below each its bit fields, with what was read of them and how long ago.
class RegisterModel final : public GroupedModel {
  Q_OBJECT

 public:
  enum Column : int { kAddress, kName, kValue, kDigits, kAge, kColumnCount };
  enum Role { kWordsRole = Qt::UserRole + 1, kGroupRole, kAddressRole };

  explicit RegisterModel(QObject* parent = nullptr);

  /// As many as the ESC says it has (0x0004, 0x0005); the values go.
  void setUnits(unsigned fmmus, unsigned sync_managers);
  void setValues(std::uint16_t address, const std::vector<std::uint8_t>& bytes, Nanoseconds time);
  /// Nothing could be read there, for that reason; what was read before goes.
  void setFailure(std::uint16_t address, std::uint16_t length, const QString& why);
  /// For the ages; nothing: the run in which the values were read is over.
  void setNow(std::optional<Nanoseconds> now);
  /// The register of a row or of its field.
  [[nodiscard]] const reg::RegisterLayout* layout(const QModelIndex& index) const;
  [[nodiscard]] const std::vector<reg::RegisterLayout>& layouts() const { return layouts_; }
  /// Empty: not read.
  [[nodiscard]] std::vector<std::uint8_t> value(std::uint16_t address) const;

  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  [[nodiscard]] int groups() const override { return static_cast<int>(layouts_.size()); }
  [[nodiscard]] int members(std::size_t group) const override {
    return static_cast<int>(layouts_[group].fields.size());
  }

 private:
  struct Reading {
    std::vector<std::uint8_t> bytes{};
    Nanoseconds time = 0;
    QString failure{};
  };
  template <class Change>
  void change(std::uint16_t address, std::size_t length, Change apply);
  [[nodiscard]] QString text(const QModelIndex& index) const;
  [[nodiscard]] QString fieldText(const reg::RegisterLayout& layout, int field, int column) const;

  std::vector<reg::RegisterLayout> layouts_;
  std::vector<Reading> readings_;  // of each
  std::optional<Nanoseconds> now_ = 0;
};

}  // namespace syncline::ui
