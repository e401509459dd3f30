// SPDX-License-Identifier: Apache-2.0
#include "ui/session/project_copy.h"

#include <algorithm>

#include "config/project.h"

namespace syncline::ui {

std::shared_ptr<const ProjectCopy> ProjectCopy::of(const Project& project, const ProjectCopy* like) {
  auto copy = std::make_shared<ProjectCopy>();
  copy->master_ = project.master;
  copy->name_ = project.name;
  copy->slaves_.reserve(project.slaves.size());
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    const bool known = like != nullptr && i < like->slaves_.size() && *like->slaves_[i] == project.slaves[i];
    copy->slaves_.push_back(known ? like->slaves_[i] : std::make_shared<const SlaveSettings>(project.slaves[i]));
  }
  return copy;
}

Project ProjectCopy::project() const {
  Project project{master_, {}, name_, {}};  // no ENI depends on its views
  project.slaves.reserve(slaves_.size());
  for (const auto& slave : slaves_) project.slaves.push_back(*slave);
  return project;
}

bool ProjectCopy::operator==(const ProjectCopy& other) const {
  return master_ == other.master_ && name_ == other.name_ &&
         std::ranges::equal(slaves_, other.slaves_, [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

}  // namespace syncline::ui
