// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "protocol/coe.h"

namespace syncline {
struct Project;
struct SlaveSettings;
}  // namespace syncline

namespace syncline::ui {

/// Settings and objects of the slaves, found by words all of which occur in what stands for them: label and key of a
/// setting, index and name of an object, name and address of the slave. Nothing is made but what is found, so that a
/// thousand slaves are looked through between two keys.
class GoToSearch final {
 public:
  struct Found {
    int slave = 0;
    QString text;
    QString detail;                              // key, or index with sub-index
    QString key{};                               // of a setting
    std::optional<coe::ObjectAddress> object{};  // else
  };

  /// Not the settings of `node`, which are offered otherwise. The project must outlive it.
  GoToSearch(const Project& project, int node);
  ~GoToSearch();

  /// `words` in lower case. At most `most` of each of both kinds, by slaves.
  [[nodiscard]] std::vector<Found> settings(const QStringList& words, std::size_t most) const;
  [[nodiscard]] std::vector<Found> objects(const QStringList& words, std::size_t most) const;

 private:
  struct Row;
  struct Entry;
  using Entries = std::vector<Entry>;

  [[nodiscard]] std::shared_ptr<const Entries> entriesOf(const SlaveSettings& slave) const;
  void readDictionaries() const;
  [[nodiscard]] QString wordsOf(std::size_t slave) const;

  const Project& project_;
  std::size_t node_;
  std::vector<Row> rows_;
  mutable std::vector<std::shared_ptr<const Entries>> dictionaries_;  // of each slave, once one is looked for
};

}  // namespace syncline::ui
