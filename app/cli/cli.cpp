// SPDX-License-Identifier: Apache-2.0
#include "app/cli/cli.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <system_error>

#include "app/cli/context.h"
#include "app/cli/options.h"
#include "engine/eeprom_journal.h"
#include "findings/error_text.h"
#include "findings/finding.h"

namespace syncline::cli {
namespace {

void add_commands(CLI::App& app, Context& context) {
  add_adapters_command(app, context);
  add_scan_command(app, context);
  add_sii_command(app, context);
  add_sdo_command(app, context);
  add_foe_command(app, context);
  add_slave_commands(app, context);
  add_sync_command(app, context);
  add_dc_command(app, context);
  add_project_commands(app, context);
  add_esi_commands(app, context);
  add_export_command(app, context);
  add_check_command(app, context);
  add_compare_command(app, context);
  add_run_command(app, context);
  add_record_command(app, context);
  add_simulate_command(app, context);
}

/// A slave whose EEPROM is half written may not come up at its next power-on: said until it is mended.
void offer_to_finish(Context& context, const std::vector<std::string>& arguments) {
  if (arguments.size() > 1 && arguments[0] == "sii" && arguments[1] == "finish") return;
  for (const auto& journal : pending_journals()) {
    context.console.err << fmt::format(
        "warning: writing the EEPROM of slave {0} on {1} was cut short ({2} UTC); end it with \"synclinectl sii finish "
        "{1} {0}\", "
        "or take it back with --undo\n",
        journal.position, journal.link, journal.begun);
  }
}

/// CLI11's words for "--strict=no" say what it does with it.
void refuse(CLI::App& app, Context& context, const CLI::Error& error) {
  const std::string words = error.what();
  if (const auto end = words.find(" was given a disallowed flag override"); end != std::string::npos)
    return context.fail_with_words(fmt::format("--{} takes no value", words.substr(0, end)), kUsage);
  (void)app.exit(error, context.console.out, context.console.err);
  context.note_error(words);
  context.exit_code = kUsage;
}

/// Runs the command and whatever it throws to its end.
void execute(CLI::App& app, Context& context, std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them last first
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::Success& asked) {  // --help, --version
    (void)app.exit(asked, context.console.out, context.console.err);
    context.json = false;
  } catch (const CLI::Error& error) {
    refuse(app, context, error);
  } catch (const std::bad_alloc&) {
    context.fail_with_words("there is not enough memory for this", kFailed);
  } catch (const std::system_error& error) {
    const bool no_thread = error.code() == std::errc::resource_unavailable_try_again;
    context.fail_with_words(no_thread ? "the system gives no more memory or threads for this"
                                      : fmt::format("this should not have happened: {}", error.what()),
                            kFailed);
  } catch (const std::exception& error) {
    context.fail_with_words(fmt::format("this should not have happened: {}", error.what()), kFailed);
  }
}

}  // namespace

Json Context::NotedError::json() const {
  Json json;
  json["message"] = message;
  if (!subject.empty()) json["subject"] = subject;
  if (!file.empty()) json["file"] = file;
  if (line > 0) json["line"] = line;
  return json;
}

void Context::fail_with(const Error& error) {
  console.err << "synclinectl: " << describe(error) << '\n' << std::flush;
  const bool usage = error.code == ErrorCode::kBadValue || error.code == ErrorCode::kUnknownKey;
  exit_code = usage ? kUsage : kFailed;
  if (!error_) error_ = NotedError{describe(error), error.subject, error.file, error.line};
}

void Context::fail_with_words(const std::string& words, int code) {
  console.err << "synclinectl: " << words << '\n';
  note_error(words);
  exit_code = code;
}

void Context::note_error(const std::string& words) {
  if (!error_) error_ = NotedError{words};
}

void Context::warn(const Error& error) { console.err << "warning: " << describe(error) << '\n'; }

void Context::warn(const Finding& finding) { console.err << "warning: " << describe(finding) << '\n'; }

void Context::finish() {
  if (json) {
    if (result_.is_null()) result_ = Json::object();
    if (error_) result_["error"] = error_->json();
    console.out << result_.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  }
  if (console.out.flush()) return;
  console.err << "synclinectl: the output could not be written as a whole; is the disk full?\n";
  exit_code = kFailed;
}

std::string hex(std::uint64_t value, int digits) { return fmt::format("0x{:0{}x}", value, digits); }

std::string mac_text(const std::array<std::uint8_t, 6>& mac) {
  return fmt::format("{:02x}:{:02x}:{:02x}:{:02x}:{:02x}:{:02x}", mac[0], mac[1], mac[2], mac[3], mac[4], mac[5]);
}

int run(const std::vector<std::string>& arguments, Console console) {
  Context context{console};
  const bool json_with_value =
      std::ranges::any_of(arguments, [](const std::string& argument) { return argument.starts_with("--json="); });
  context.json = json_with_value || std::ranges::find(arguments, "--json") != arguments.end();
  CLI::App app{
      "synclinectl: EtherCAT configurator and synchronisation monitor without a window.\n"
      "LINK is sim:FILE[?virtual][&seed=N], nic:NAME or replay:FILE (a capture).\n"
      "Exit codes: 0 done, 1 the answer is no, 2 usage, 3 bus or file error.",
      "synclinectl"};
  app.require_subcommand(1);
  app.option_defaults()->disable_flag_override();  // "--strict=no" is no way to leave it out
  app.set_version_flag("--version", std::string("synclinectl ") + SYNCLINE_VERSION);
  add_commands(app, context);
  offer_to_finish(context, arguments);
  if (json_with_value) {
    context.fail_with_words("--json takes no value, it prints to the standard output: use --json > FILE", kUsage);
  } else {
    execute(app, context, arguments);
  }
  context.finish();
  return context.exit_code;
}

}  // namespace syncline::cli
