// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "reasons/reason.h"
#include "support/result.h"

namespace syncline::ui {

/// A file that the window shows or writes at the moment, known to whoever is about to write one. The window's thread.
class HeldFile {
 public:
  /// `what` the user calls it, as a row of core/reasons: "the project that is open".
  explicit HeldFile(Reason what);
  ~HeldFile();
  HeldFile(const HeldFile&) = delete;
  HeldFile& operator=(const HeldFile&) = delete;

  /// From now on, in place of the one before; "": none.
  void hold(const QString& path) { path_ = path; }
  [[nodiscard]] const QString& path() const { return path_; }
  [[nodiscard]] const Reason& what() const { return what_; }

 private:
  Reason what_;
  QString path_;
};

/// The one question before the window writes a file, under whatever name and through whatever links: kFileNotWritable
/// where it is one of those that are held, with what that is and what to do. `own`: whoever holds it writes it himself.
[[nodiscard]] Status mayWrite(const QString& path, const HeldFile* own = nullptr);

}  // namespace syncline::ui
