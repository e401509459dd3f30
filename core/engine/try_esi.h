// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "engine/try_device.h"
#include "support/result.h"

namespace syncline {

class TrialFiles;

struct TryRequest {
  std::string path;                                     // an ESI file, or a folder of them with those below it
  unsigned threads = 0;                                 // 0: as many as the machine has processors, 8 at most
  unsigned every = 1;                                   // tries each n-th device of a file only
  std::string keep{};                                   // folder for the ENI files, one a device; "" = none
  const std::atomic<bool>* stop = nullptr;              // ends early
  std::function<void(const TriedDevice&)> on_device{};  // as each is done, one at a time
};

struct TryReport {
  std::size_t files = 0;
  std::vector<TriedDevice> devices;  // file and device order, whatever the threads did
  std::vector<Error> unreadable;     // whole files that are no ESI files, folders that cannot be read
  bool cancelled = false;            // `stop` came before all were tried: the devices are not all
  [[nodiscard]] std::size_t count(TryOutcome outcome) const;
};

/// Tries every device of every file; `files` reads and writes them. kFileNotFound and kFileNotReadable of the folder.
[[nodiscard]] Result<TryReport> try_esi(const TryRequest& request, const TrialFiles& files);

}  // namespace syncline
