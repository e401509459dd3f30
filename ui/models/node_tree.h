// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace syncline {
struct NetworkConfig;
struct Project;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// One network as the project explorer has it: the master, the slaves, whom each stands below, and what they are at
/// present. Slaves are meant by their position, -1 is the master. Changes of the live states say whose it was.
class NodeTree {
 public:
  /// Slaves stand below the slave from which their line branches off (classic), or in bus order below the master
  /// (flat).
  enum class Shape { kClassic, kFlat };
  enum class Link { kOffline, kGood, kBroken, kSilent };  // cable to the slave; kSilent: it does not answer

  struct Node {
    QString name, device, group;
    bool dc = false, configured_reference = false, live_reference = false, optional = false;
    int al_status = -1;  // -1 offline
    Link link = Link::kOffline;
    std::uint16_t station_address = 0;
    bool operator==(const Node&) const = default;
  };
  using Slaves = std::vector<int>;

  NodeTree() = default;
  NodeTree(const Project& project, Shape shape);

  [[nodiscard]] int size() const { return static_cast<int>(slaves_.size()); }
  [[nodiscard]] const Node& node(int slave) const {
    return slave < 0 ? master_ : slaves_[static_cast<std::size_t>(slave)];
  }
  [[nodiscard]] int parent(int slave) const { return parents_[static_cast<std::size_t>(slave)]; }
  [[nodiscard]] int row(int slave) const { return slave < 0 ? 0 : rows_[static_cast<std::size_t>(slave)]; }
  [[nodiscard]] const Slaves& below(int slave) const { return below_[placeOf(slave)]; }
  /// The slave with a station address, -1 = none.
  [[nodiscard]] int slave_at(int address) const;

  void arrange(Shape shape);
  /// As many slaves in the same places, but for the address of one, which is an edit of it.
  [[nodiscard]] bool stands_like(const NodeTree& other) const;
  /// What is known of the slaves besides the project, of one that stands like this one.
  void take_states(const NodeTree& before);
  /// Whose node is another one there, which stands like this one.
  [[nodiscard]] Slaves different_from(const NodeTree& other) const;
  /// Who uses distributed clocks and who leads, as compiled; null: nothing could be compiled.
  Slaves set_configuration(const NetworkConfig* config);
  /// `positions`: of each slave in the snapshot; -1: it is not in it.
  Slaves set_snapshot(const Snapshot& snapshot, const std::vector<int>& positions);

 private:
  /// In `below_`; -1: the master.
  static std::size_t placeOf(int slave) {
    const int place = slave + 1;
    return static_cast<std::size_t>(place);
  }

  Node master_;
  std::vector<Node> slaves_;
  std::vector<int> classic_;                            // whom each slave stands below in the classic tree
  std::vector<int> parents_, rows_;                     // as arranged
  std::vector<Slaves> below_ = std::vector<Slaves>(1);  // of the master, of slave 0, 1, ...
};

}  // namespace syncline::ui
