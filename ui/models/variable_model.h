// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "channels/image_contents.h"
#include "ui/models/dictionary.h"

namespace syncline {
struct NetworkConfig;
}  // namespace syncline

namespace syncline::ui {

/// The variables of a process image, inputs first, with what stands in the image of the running bus.
class VariableModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column : int { kName, kDirection, kType, kPlace, kValue, kRaw, kForced, kMonitor, kColumns };
  enum Role { kWordsRole = Qt::UserRole + 1, kOutputRole, kForcedRole };

  struct Row {
    std::uint32_t bit_offset = 0;
    bool output = false;
    std::optional<std::size_t> slave{};  // position in the configuration
    QString comment{};
    DictionaryEntry entry{};  // name, type and size
    bool operator==(const Row&) const = default;
    /// A value of so many bits fits into a command.
    [[nodiscard]] bool forcible() const { return output && isNumber(); }
    /// As the monitor can watch it.
    [[nodiscard]] bool isNumber() const { return entry.bits >= 1 && entry.bits <= 64; }
  };

  explicit VariableModel(QObject* parent = nullptr);

  /// Those of one slave of the configuration, or all of them; what is selected stays where nothing changed.
  void setVariables(const NetworkConfig& config, std::optional<std::size_t> slave);
  void clear();
  /// Null: nothing is known. `silent`: of which slaves nothing is known now, by position.
  void setImage(const ImageContents* image, const std::vector<bool>& silent);

  /// Which of them the monitor watches, of inputs and of outputs by their names.
  void setWatched(std::set<QString> inputs, std::set<QString> outputs);

  [[nodiscard]] const Row* row(int row) const;
  [[nodiscard]] bool watched(int row) const;
  /// As it stands in the image; empty: not known.
  [[nodiscard]] std::vector<std::uint8_t> value(int row) const;
  [[nodiscard]] bool forced(int row) const;
  /// How many inputs have no present value.
  [[nodiscard]] int unknownInputs() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 Q_SIGNALS:
  /// Others are forced than before.
  void forcesChanged();

 private:
  [[nodiscard]] QString text(int row, int column) const;
  [[nodiscard]] QString toolTip(int row) const;
  [[nodiscard]] bool known(const Row& row) const;

  std::vector<Row> rows_;
  std::optional<ImageContents> image_;
  std::vector<bool> silent_;
  std::set<QString> watched_inputs_, watched_outputs_;
};

/// Bits of an image as bytes, the lowest bit first; empty when they reach beyond it.
[[nodiscard]] std::vector<std::uint8_t> bitsOf(std::span<const std::uint8_t> image, std::uint32_t offset,
                                               std::uint32_t count);

}  // namespace syncline::ui
