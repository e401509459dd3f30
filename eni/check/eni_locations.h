// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>
#include <cstddef>

#include <string>
#include <vector>

namespace syncline {
struct ConfigPlace;
}  // namespace syncline

namespace syncline::eni {

class XmlPieces;

struct EniLocation {
  int line = 0;
  std::string path;
};

/// Where the things of a NetworkConfig stand in the file that it was read from: the side table of the reader.
class EniLocations {
 public:
  explicit EniLocations(XmlPieces& pieces);
  /// The element, or the nearest one around it that is there.
  [[nodiscard]] EniLocation locate(const ConfigPlace& place) const;

 private:
  struct Lines {
    int element = 0;
    std::vector<int> parts;
  };
  struct Slave {
    int line = 0, mailbox = 0, hot_connect = 0, dc = 0;
    std::vector<int> cmds, coe_cmds, managers, manager_numbers, pdos;
    std::size_t tx_pdos = 0;
    std::size_t index = 0;  // among the Slave elements, from 1
  };
  struct Task {
    int line = 0;
    std::vector<Lines> frames;
  };

  static Slave read_slave(const tinyxml2::XMLElement& element);
  [[nodiscard]] EniLocation locate_in_slave(const ConfigPlace& place) const;
  [[nodiscard]] EniLocation locate_in_task(const ConfigPlace& place) const;
  [[nodiscard]] EniLocation part(const std::string& path, const Lines& lines, std::size_t index) const;

  std::string root_;
  int config_ = 0, image_ = 0;
  Lines master_, inputs_, outputs_;
  std::vector<Slave> slaves_;
  std::vector<Task> tasks_;
};

}  // namespace syncline::eni
