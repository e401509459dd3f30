// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "support/result.h"

namespace syncline {

class StopSignals;

/// A file that is read from its begin, or what delivers by and by: a pipe, a terminal, a device. Waiting for the latter
/// ends with one of stop_signals(), on whatever thread, and also where no StopSignals lives. One thread.
class InputFile {
 public:
  /// Waits for nothing. kFileNotFound, kFileNotReadable (a folder, a socket, no permission).
  [[nodiscard]] static Result<InputFile> open(const std::string& path);
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&&) = delete;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  /// On a disk: it has a size and nothing of it is waited for.
  [[nodiscard]] bool ordinary() const { return ordinary_; }
  /// Bytes; 0 of what is not ordinary.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The next bytes, up to as many as there is room for; 0 at the end. kFileNotReadable, kCancelled.
  [[nodiscard]] Result<std::size_t> read(std::span<char> room);
  /// Until there is something to read, or the end. kFileNotReadable, kCancelled.
  [[nodiscard]] Status wait();
  /// The descriptor, which waits again when it is read, for the caller to close.
  [[nodiscard]] int release();

 private:
  InputFile(std::string path, int descriptor);

  std::string path_;
  std::unique_ptr<StopSignals> own_;  // where no other listens
  int descriptor_;
  bool ordinary_ = false;
  std::size_t size_ = 0;
};

/// Whether a path leads to what delivers by and by: in a folder that is looked through that is nobody's file.
[[nodiscard]] bool is_stream(const std::string& path);

}  // namespace syncline
