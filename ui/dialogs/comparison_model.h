// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ui/models/grouped_model.h"

namespace syncline {
struct ConfigDifference;
struct SettingDifference;
}  // namespace syncline

namespace syncline::ui {

struct Compared;

/// What two machines have otherwise: the network and its slaves, and below each what differs.
class ComparisonModel final : public GroupedModel {
  Q_OBJECT

 public:
  enum Column { kWhat, kLeft, kRight, kKind, kColumns };
  enum Role {
    kKeyRole = Qt::UserRole + 1,  // of a setting of the project; empty: none
    kNodeRole,                    // slave of the project, -1 its network, -2 none
    kMattersRole,                 // more than names and places in the process image
    kWordsRole,                   // all that can be searched for
  };
  static constexpr int kNoNode = -2;

  explicit ComparisonModel(QObject* parent = nullptr);

  /// `titles`: of the two sides. `project_is_left`: which side is the project of the window; none: neither.
  void setCompared(const Compared& compared, const QString& left, const QString& right,
                   std::optional<bool> project_is_left);
  [[nodiscard]] int differences() const;
  /// Of them those of the project, without what follows in the network, and without what makes no difference.
  [[nodiscard]] int changes() const { return changes_; }

  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  [[nodiscard]] int groups() const override { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] int members(std::size_t group) const override { return static_cast<int>(nodes_[group].lines.size()); }

 private:
  struct Line {
    QString text[kColumns];
    QString meaning, key;
    bool matters = true;
  };
  struct Node {
    std::optional<std::size_t> left, right;  // none on both sides: the network
    QString name;
    std::vector<Line> lines;
  };
  Node& nodeOf(std::optional<std::size_t> left, std::optional<std::size_t> right, const std::string& name);
  void add(const ConfigDifference& difference);
  void add(const SettingDifference& difference, const std::string& name);
  [[nodiscard]] const Line* line(const QModelIndex& index) const;
  [[nodiscard]] QVariant nodeData(const Node& node, int column, int role) const;
  [[nodiscard]] int projectNode(const Node& node) const;

  std::vector<Node> nodes_;
  int changes_ = 0;
  QString titles_[2];
  std::optional<bool> project_is_left_;
};

}  // namespace syncline::ui
