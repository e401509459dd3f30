// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

namespace syncline {

/// `syncline RUN.slrec --picture OUT`, as it was typed; empty: not typed.
struct PictureOptions {
  QString file, out, view, own_view, from, to, figure, slave, size;
  QString overlay, align, offset;  // of another recording over it
  QStringList signal_keys;
};

/// Reads the recording and writes the picture, without a window. What goes wrong is written to the error stream; exit
/// code as synclinectl's: 0 done, 2 what was typed makes no picture, 3 a file.
int writePictureOf(const PictureOptions& options);

}  // namespace syncline
