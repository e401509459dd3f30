// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/master_settings.h"

namespace syncline {
struct Project;
struct SlaveSettings;
}  // namespace syncline

namespace syncline::ui {

/// A project as it was, for other threads and for later. Copies of the same project share the slaves that are equal:
/// one more copy of a machine of a thousand slaves costs a comparison of them.
class ProjectCopy {
 public:
  /// `like`: a copy of what it was shortly before; null: none.
  static std::shared_ptr<const ProjectCopy> of(const Project& project, const ProjectCopy* like);

  [[nodiscard]] Project project() const;
  [[nodiscard]] bool operator==(const ProjectCopy& other) const;

 private:
  MasterSettings master_;
  std::string name_;
  std::vector<std::shared_ptr<const SlaveSettings>> slaves_;
};

}  // namespace syncline::ui
