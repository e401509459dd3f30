// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <memory>

class QLockFile;

namespace syncline::ui {

/// That one window at a time writes a project file: a hidden file beside it, which goes with the window, also a killed
/// one on this machine. Where no file can be made beside it the project cannot be saved either, and nothing is locked.
class ProjectLock final {
 public:
  ProjectLock();
  ~ProjectLock();
  ProjectLock(const ProjectLock&) = delete;
  ProjectLock& operator=(const ProjectLock&) = delete;

  /// Gives up what is held and holds `path`; "" is nothing. False: another window has it.
  bool take(const QString& path);
  [[nodiscard]] bool held() const { return held_; }
  /// The other window that has `path`: "process 123 on HOST"; empty: nobody else.
  [[nodiscard]] QString holder(const QString& path) const;
  /// The hidden file of a project.
  [[nodiscard]] static QString fileOf(const QString& path);

 private:
  QString path_;
  std::unique_ptr<QLockFile> lock_;
  bool held_ = true;
};

}  // namespace syncline::ui
