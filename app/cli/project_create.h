// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/esi_folders.h"

namespace syncline::cli {

class Context;

/// `project create FILE`: from a bus (scan), from ESI files (devices) or from an ENI; the rest are settings.
struct CreateOptions {
  std::string file;
  std::string scan;                  // LINK, "" = offline
  std::string eni;                   // ENI file
  std::vector<std::string> devices;  // VENDOR:PRODUCT[:REVISION] in bus order
  EsiFolders esi;
  std::string cycle_us, shift, sync_window, reference_clock;
  std::vector<std::string> op_modes;  // POSITION=NAME
  std::string network;                // name; joins or replaces a network of an existing file. "" = a new file
  bool read_dictionaries = true;      // of devices without an ESI that are on the bus
  bool json = false;
};

void create_project(Context& context, const CreateOptions& options);

}  // namespace syncline::cli
