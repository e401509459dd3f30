// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "reasons/reason.h"
#include "support/expected.h"

namespace syncline {

/// What went wrong. The words stand in findings/error_text.h, one English template each, so that the
/// command line prints them as they are and the window translates them.
enum class ErrorCode : std::uint16_t {
  // files
  kFileNotFound,       // file
  kFileNotReadable,    // file, detail
  kFileNotWritable,    // file, detail
  kXmlMalformed,       // file, line, detail
  kXmlMissingElement,  // file, line, subject = element
  kXmlBadValue,        // file, line, subject = element, detail = text
  kNotThatKindOfFile,  // file, detail = what was expected
  kTomlMalformed,      // file, line, detail
  kScenarioKey,        // file, line, subject = key, detail
  // configuration
  kUnknownDevice,  // subject = identity
  kMissingEsi,     // subject = identity, detail = folder
  kUnknownKey,     // subject = key
  kBadValue,       // subject = key or field, detail
  kConfiguration,  // subject = object, detail
  // link
  kLinkNotFound,    // subject = adapter or link text
  kLinkDown,        // subject
  kLinkPermission,  // subject = adapter, detail = command that grants it
  kLinkIo,          // subject, detail
  kNotSupported,    // subject, detail
  // bus
  kNoResponse,         // subject
  kWorkingCounter,     // subject, expected, received
  kSlaveCount,         // expected, received
  kIdentityMismatch,   // subject = slave, detail
  kAlState,            // subject = slave, expected = requested state, received = AL status,
                       // extra = AL status code
  kAlTimeout,          // subject = slave, expected = requested state, received = AL status
  kMailboxTimeout,     // subject = slave
  kMailboxProtocol,    // subject = slave, detail
  kSdoAbort,           // subject = slave and object, received = abort code
  kSii,                // subject = slave, detail
  kInitCmdValidation,  // subject = slave and comment, detail = expected and read bytes
  kMalformedData,      // subject, detail
  kDcSetup,            // subject = slave, detail
  kDcmOutOfLimit,      // subject, expected = limit ns, received = error ns
  kTimeout,            // subject
  kCancelled,
  // scan
  kScanScope,      // subject = slave, detail = what the scan left out
  kSlaveMissing,   // subject = slave, detail = where it should be
  kSlaveExtra,     // subject = identity, detail = where it is
  kSlavesSwapped,  // subject = slave, detail = the slave that stands in its place
  kFileTransfer,   // subject = slave and file, received = FoE error code, detail = the slave's words
  // files again
  kFileLimit,  // file, line, detail = the limit that the file exceeds
  kCatalogue,  // file = database, received = SQLite result code, detail = its words
};

/// An error is an enum and the facts that prove it; see ErrorCode for which fields a code fills.
struct Error {
  ErrorCode code = ErrorCode::kMalformedData;
  std::string subject{};
  Reason detail{};
  std::string file{};
  int line = 0;
  std::int64_t expected = 0;
  std::int64_t received = 0;
  std::int64_t extra = 0;

  bool operator==(const Error&) const = default;
};

template <class T>
using Result = Expected<T, Error>;
using Status = Result<void>;

inline tl::unexpected<Error> fail(Error error) { return tl::unexpected<Error>(std::move(error)); }
inline tl::unexpected<Error> fail(ErrorCode code, std::string subject = {}, Reason detail = {}) {
  return tl::unexpected<Error>(Error{code, std::move(subject), std::move(detail)});
}

}  // namespace syncline
