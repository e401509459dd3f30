// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/gui/recording_picture.h"

namespace syncline {

/// What the window is started with.
struct Options {
  QString file, link, theme, screenshots, faults, language, overlay;
  bool demo = false, reset_settings = false;
  int exit_after_ms = 0;
  PictureOptions picture;  // without a name to write to: none is wanted
};

/// Reads the command line. Prints and ends the program for --help and --version, and with kUsage where an option or its
/// value is none: it names the values that are.
[[nodiscard]] Options parse_options(const QCoreApplication& app);

}  // namespace syncline
