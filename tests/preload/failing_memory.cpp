// SPDX-License-Identifier: Apache-2.0
// Preloaded into a program: from its FAILING_MEMORY_FROM'th allocation of FAILING_MEMORY_LEAST bytes or more on
// FAILING_MEMORY_COUNT of them fail, whoever asks, in any of its threads, unless a large block is given back before:
// then there is memory again. With FAILING_MEMORY_SHARE so many of a hundred of them fail, here and there, whatever is
// given back: others take it. At its end it writes into the file FAILING_MEMORY_TOLD how many it asked for.
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT(bugprone-reserved-identifier): glibc's own,
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT(bugprone-reserved-identifier) with which
void* __libc_realloc(void* block, std::size_t size);             // NOLINT(bugprone-reserved-identifier) it is
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT(bugprone-reserved-identifier) replaced
void __libc_free(void* block);                                   // NOLINT(bugprone-reserved-identifier) here
}

namespace {

constexpr std::size_t kLarge = 512 * 1024;
std::atomic<long> asked{0};
std::atomic<bool> over{false};
constexpr long kAll = 100;
long from = std::numeric_limits<long>::max(), count = 0, least = 0, share = kAll;

long number(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  if (text != nullptr) std::from_chars(text, text + std::strlen(text), otherwise);
  return otherwise;
}

struct Setting {
  Setting() {
    from = number("FAILING_MEMORY_FROM", from);
    count = number("FAILING_MEMORY_COUNT", count);
    least = number("FAILING_MEMORY_LEAST", least);
    share = number("FAILING_MEMORY_SHARE", share);
  }
  ~Setting() {
    const char* path = std::getenv("FAILING_MEMORY_TOLD");
    const int told = path == nullptr ? -1 : ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (told < 0) return;
    char text[24];
    const auto end = std::to_chars(text, text + sizeof(text), asked.load());
    (void)!::write(told, text, static_cast<std::size_t>(end.ptr - text));
    ::close(told);
  }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;
} const setting;

/// The same ones each time, in no order.
bool is_of_the_share(long which) {
  auto mixed = static_cast<std::uint64_t>(which) * 0x9E3779B97F4A7C15U;
  mixed ^= mixed >> 29U;
  mixed *= 0xBF58476D1CE4E5B9U;
  return static_cast<long>((mixed >> 32U) % kAll) < share;
}

bool fails(std::size_t size) {
  if (size < static_cast<std::size_t>(least)) return false;
  const long which = asked.fetch_add(1, std::memory_order_relaxed);
  if (which < from || which - from >= count) return false;
  if (share < kAll ? !is_of_the_share(which) : over.load()) return false;
  errno = ENOMEM;
  return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return fails(size) ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t number_of, std::size_t size) {
  return fails(number_of * size) ? nullptr : __libc_calloc(number_of, size);
}
void* realloc(void* block, std::size_t size) { return size > 0 && fails(size) ? nullptr : __libc_realloc(block, size); }
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return fails(size) ? nullptr : __libc_memalign(alignment, size);
}
void free(void* block) {
  if (block != nullptr && asked.load(std::memory_order_relaxed) > from && ::malloc_usable_size(block) >= kLarge)
    over = true;
  __libc_free(block);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  if (fails(size)) return ENOMEM;
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
}
