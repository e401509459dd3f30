// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "app/cli/cli.h"
#include "app/cli/json.h"

namespace CLI {
class App;
}  // namespace CLI

namespace syncline {
struct Error;
}  // namespace syncline

namespace CLI {
class App;  // whoever adds options to it includes app/cli/options.h
}

namespace syncline {
struct Finding;
}

namespace syncline::cli {

/// What a sub-command needs and leaves behind.
class Context {
 public:
  explicit Context(Console own_console) : console(own_console) {}
  Console console;
  int exit_code = kDone;
  bool json = false;  // one object is wanted, whatever happens

  /// Says the error and sets the exit code: 2 for a key or value that is not accepted, else 3. The first one also
  /// becomes "error" of the JSON object.
  void fail_with(const Error& error);
  void fail_with_words(const std::string& words, int code);
  void note_error(const std::string& words);
  void warn(const Error& error);
  void warn(const Finding& finding);
  /// The command's JSON object; printed when the command is over, with its error if there was one.
  void print(Json json_object) { result_ = std::move(json_object); }
  /// Prints what is left to print; exit code 3 when the output could not be written.
  void finish();

 private:
  /// In plain strings until it is printed: a Json that finds no memory while it is made ends the program.
  struct NotedError {
    std::string message, subject{}, file{};
    int line = 0;
    [[nodiscard]] Json json() const;
  };

  Json result_;
  std::optional<NotedError> error_;
};

void add_adapters_command(CLI::App& app, Context& context);
void add_scan_command(CLI::App& app, Context& context);
void add_sii_command(CLI::App& app, Context& context);
void add_sdo_command(CLI::App& app, Context& context);
void add_foe_command(CLI::App& app, Context& context);
void add_slave_commands(CLI::App& app, Context& context);
void add_sync_command(CLI::App& app, Context& context);
void add_dc_command(CLI::App& app, Context& context);
void add_project_commands(CLI::App& app, Context& context);
void add_esi_commands(CLI::App& app, Context& context);
void add_export_command(CLI::App& app, Context& context);
void add_check_command(CLI::App& app, Context& context);
void add_compare_command(CLI::App& app, Context& context);
void add_run_command(CLI::App& app, Context& context);
void add_record_command(CLI::App& app, Context& context);
void add_simulate_command(CLI::App& app, Context& context);

[[nodiscard]] std::string hex(std::uint64_t value, int digits);
[[nodiscard]] std::string mac_text(const std::array<std::uint8_t, 6>& mac);

}  // namespace syncline::cli
