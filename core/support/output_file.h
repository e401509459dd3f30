// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline {

/// The one way in which files are written. What is written gathers in a temporary file beside `path` whose name nobody
/// can guess; finish() brings it to the disk and gives it the name: a reader sees the old content or the whole new one.
/// Only an ordinary file is replaced; it keeps its permissions, a symbolic link to it stays. A terminal, a pipe or
/// /dev/full is written to as it is, a folder, a disk or a socket is refused. What is not finished is removed, what a
/// killed program left goes when the same file is written the next time. All errors are kFileNotWritable with the file
/// and the system's reason; kCancelled when a signal ends the waiting for a pipe's reader. For one thread.
class OutputFile {
 public:
  [[nodiscard]] static Result<OutputFile> create(const std::string& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// Takes bytes, gathered up to 64 KB. The first error stays: everything after it is dropped.
  Status write(std::string_view bytes);
  /// Gives the system what was gathered, so that a full disk shows.
  Status flush();
  /// The file has its name and its content on the disk. Once.
  Status finish();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  OutputFile() = default;
  Status open_temporary();
  Status open_in_place();
  Status failed(int number);
  void discard();

  std::string path_;       // as the user gave it
  std::string target_;     // through symbolic links
  std::string temporary_;  // "": written in place
  std::string buffer_;
  Status status_;
  int descriptor_ = -1;
};

}  // namespace syncline
