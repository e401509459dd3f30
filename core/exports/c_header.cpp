// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "config/network_config.h"
#include "exports/exports.h"

namespace syncline::exports {
namespace {

bool is_plain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80;
}

/// Letters and digits with single underscores between: what C and C++ both leave to the user.
std::string identifier(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (is_plain(c)) {
      out += c;
    } else if (!out.empty() && out.back() != '_') {
      out += '_';
    }
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  if (out.empty()) return "x";
  return std::isdigit(static_cast<unsigned char>(out[0])) != 0 ? "n" + out : out;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// No comment ends early and no line runs on.
std::string comment_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool ends =
        (c == '/' && !out.empty() && out.back() == '*') || (c == '*' && !out.empty() && out.back() == '/');
    if (ends) out += ' ';
    out += static_cast<unsigned char>(c) < 0x20 || c == '\\' ? ' ' : c;
  }
  return out;
}

struct ValueType {
  const char* c_name = "";
  bool is_float = false;
  bool is_signed = false;
};

ValueType value_type(const Variable& variable) {
  const std::uint32_t bits = variable.bit_size;
  if (variable.data_type == "REAL" && bits == 32) return {"float", true, false};
  if (variable.data_type == "LREAL" && bits == 64) return {"double", true, false};
  constexpr std::array<std::string_view, 4> kSigned{"SINT", "INT", "DINT", "LINT"};
  const bool is_signed = std::ranges::find(kSigned, variable.data_type) != kSigned.end();
  if (bits <= 8) return {is_signed ? "int8_t" : "uint8_t", false, is_signed};
  if (bits <= 16) return {is_signed ? "int16_t" : "uint16_t", false, is_signed};
  if (bits <= 32) return {is_signed ? "int32_t" : "uint32_t", false, is_signed};
  return {is_signed ? "int64_t" : "uint64_t", false, is_signed};
}

class Header {
 public:
  explicit Header(const std::string& name) : prefix_(lower(identifier(name))), macro_(upper(prefix_)) {}

  std::string write(const NetworkConfig& config) {
    out_ = fmt::format("/* Process image of \"{}\", {} slaves. Made by Syncline; do not edit. */\n",
                       comment_text(config.master.name), config.slaves.size());
    out_ += fmt::format("#ifndef {0}_PROCESS_IMAGE_H\n#define {0}_PROCESS_IMAGE_H\n\n", macro_);
    out_ +=
        "#include <stddef.h>\n#include <stdint.h>\n#include <string.h>\n\n#ifdef __cplusplus\nextern \"C\" "
        "{\n#endif\n\n";
    out_ += fmt::format("#define {}_SLAVES {}u\n", macro_, config.slaves.size());
    out_ += fmt::format("#define {}_CYCLE_NS {}u\n", macro_, config.cycle_time());
    out_ += fmt::format("#define {}_INPUT_BYTES {}u\n", macro_, config.image.input_bytes);
    out_ += fmt::format("#define {}_OUTPUT_BYTES {}u\n", macro_, config.image.output_bytes);
    write_slaves(config);
    write_helpers();
    out_ += "/* Inputs: from the slaves to the master. */\n";
    for (const auto& variable : config.image.inputs) write_variable(variable, false, config.image.input_bytes);
    out_ += "\n/* Outputs: from the master to the slaves. */\n";
    for (const auto& variable : config.image.outputs) write_variable(variable, true, config.image.output_bytes);
    out_ += fmt::format("\n#ifdef __cplusplus\n}}\n#endif\n\n#endif /* {}_PROCESS_IMAGE_H */\n", macro_);
    return std::move(out_);
  }

 private:
  void write_slaves(const NetworkConfig& config) {
    out_ += "\n/* Station addresses. */\n";
    for (const auto& slave : config.slaves) {
      out_ += fmt::format("#define {}_ADDRESS_{} {}u\n", macro_, upper(unique(slave.name)), slave.station_address);
    }
  }

  /// Bits of the image as a number, byte by byte, so that neither byte order nor alignment matter.
  void write_helpers() {
    out_ += fmt::format(
        "\nstatic inline uint64_t {0}_load(const uint8_t* image, size_t bit, unsigned bits) {{\n"
        "  uint64_t value = 0;\n"
        "  unsigned i;\n"
        "  if ((bit & 7u) == 0 && (bits & 7u) == 0) {{\n"
        "    for (i = 0; i < bits / 8u; ++i) value |= (uint64_t)image[bit / 8u + i] << (8u * i);\n"
        "    return value;\n"
        "  }}\n"
        "  for (i = 0; i < bits; ++i) value |= (uint64_t)((image[(bit + i) / 8u] >> ((bit + i) & 7u)) & 1u) << i;\n"
        "  return value;\n"
        "}}\n\n"
        "static inline void {0}_store(uint8_t* image, size_t bit, unsigned bits, uint64_t value) {{\n"
        "  unsigned i;\n"
        "  if ((bit & 7u) == 0 && (bits & 7u) == 0) {{\n"
        "    for (i = 0; i < bits / 8u; ++i) image[bit / 8u + i] = (uint8_t)(value >> (8u * i));\n"
        "    return;\n"
        "  }}\n"
        "  for (i = 0; i < bits; ++i) {{\n"
        "    uint8_t mask = (uint8_t)(1u << ((bit + i) & 7u));\n"
        "    uint8_t* byte = &image[(bit + i) / 8u];\n"
        "    *byte = (uint8_t)((value >> i) & 1u ? *byte | mask : *byte & (uint8_t)~mask);\n"
        "  }}\n"
        "}}\n\n",
        prefix_);
  }

  void write_variable(const Variable& variable, bool output, std::uint32_t image_bytes) {
    const std::string name = unique((output ? "out_" : "in_") + variable.name);
    out_ += fmt::format("\n/* {}{}{} */\n", comment_text(variable.name), variable.data_type.empty() ? "" : ", ",
                        comment_text(variable.data_type));
    const std::uint64_t end = std::uint64_t{variable.bit_offset} + variable.bit_size;
    if (end > 8ULL * image_bytes || variable.bit_size == 0) {
      out_ += "/* Outside the image: the tool that wrote it fills it itself. */\n";
      return;
    }
    const std::string macro = fmt::format("{}_{}", macro_, upper(name));
    out_ +=
        fmt::format("#define {}_BIT {}u\n#define {}_BITS {}u\n", macro, variable.bit_offset, macro, variable.bit_size);
    if (variable.bit_size > 64) return;  // a buffer: copy it
    output ? write_setter(variable, lower(name)) : write_getter(variable, lower(name));
  }

  void write_getter(const Variable& variable, const std::string& name) {
    const auto type = value_type(variable);
    const auto load = fmt::format("{}_load(image, {}u, {}u)", prefix_, variable.bit_offset, variable.bit_size);
    out_ += fmt::format("static inline {} {}_{}(const uint8_t* image) {{\n", type.c_name, prefix_, name);
    if (type.is_float) {
      out_ += fmt::format(
          "  uint{0}_t bits = (uint{0}_t){1};\n  {2} value;\n  memcpy(&value, &bits, sizeof value);\n"
          "  return value;\n}}\n",
          variable.bit_size, load, type.c_name);
    } else if (type.is_signed && variable.bit_size % 8 != 0) {
      out_ += fmt::format(
          "  uint64_t value = {0};\n  uint64_t sign = (uint64_t)1 << {1};\n"
          "  return ({2})((value ^ sign) - sign);\n}}\n",
          load, variable.bit_size - 1, type.c_name);
    } else {
      out_ += fmt::format("  return ({}){};\n}}\n", type.c_name, load);
    }
  }

  void write_setter(const Variable& variable, const std::string& name) {
    const auto type = value_type(variable);
    out_ += fmt::format("static inline void {}_{}(uint8_t* image, {} value) {{\n", prefix_, name, type.c_name);
    std::string value = "(uint64_t)value";
    if (type.is_float) {
      out_ += fmt::format("  uint{}_t bits;\n  memcpy(&bits, &value, sizeof bits);\n", variable.bit_size);
      value = "(uint64_t)bits";
    }
    out_ +=
        fmt::format("  {}_store(image, {}u, {}u, {});\n}}\n", prefix_, variable.bit_offset, variable.bit_size, value);
  }

  /// Names that differ in case or in signs only get numbers.
  std::string unique(std::string_view text) {
    std::string base = identifier(text);
    int& number = used_[upper(base)];
    if (++number == 1) return base;
    std::string name = fmt::format("{}_{}", base, number);
    // Somebody may be called so already.
    while (used_.contains(upper(name))) name = fmt::format("{}_{}", base, ++number);
    used_[upper(name)] = 1;
    return name;
  }

  std::string prefix_, macro_, out_;
  std::map<std::string, int> used_;  // names in capitals, and the last number given
};

}  // namespace

std::string c_header(const NetworkConfig& config, const std::string& name) { return Header(name).write(config); }

}  // namespace syncline::exports
