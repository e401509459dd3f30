// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// What a file is, by its content.
enum class FileKind : unsigned char {
  kProject,
  kEni,
  kEsi,
  kCapture,    // pcap, pcapng
  kRecording,  // of a run, or a database of another program: it is said which
  kScenario,   // of the simulated bus
  kRunTable,   // log of the master synchronisation, or the table of a run: shown like a recording
  kOther,      // XML of another kind, or anything
  kUnreadable,
};

/// Reads the beginning.
[[nodiscard]] FileKind fileKind(const QString& path);

}  // namespace syncline::ui
