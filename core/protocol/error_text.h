// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

/// The words of errors. They stand here and not beside Error because numbers are shown by their
/// ETG names (AL states, AL status codes, SDO abort codes).
namespace syncline {

/// English sentence template of a code. Placeholders:
///   {subject} {detail} {file} {line} {expected} {received} {extra}  the fields as they are
///   {where}     "file:line", "file" when there is no line
///   {because}   ": detail", nothing when there is no detail
///   {state}     AL state name of `expected`      {actual}  AL state name of `received`, "+ERR" behind it
///   {alcode}    `extra` as AL status code: number, meaning, what to check
///   {abort}     `received` as SDO abort code: number and meaning
///   {foe}       `received` as FoE error code: number and meaning
[[nodiscard]] std::string_view error_template(ErrorCode code);

/// Fills a (possibly translated) template with the facts of the error. Unknown placeholders stay.
[[nodiscard]] std::string fill_error_template(std::string_view text, const Error& error);

/// English sentence: where, what happened, and what to do.
[[nodiscard]] std::string describe(const Error& error);

}  // namespace syncline
