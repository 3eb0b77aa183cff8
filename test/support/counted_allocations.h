// Counts what the program takes from the heap, libraries included: malloc and its kin are replaced, and with them
// operator new. Include it in one source file of a test program.
//
// Under AddressSanitizer, whose own malloc must stay, its hooks count.
#pragma once

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

namespace cdpr_kinetostatics {

struct HeapCount {
  long allocations = 0;  // so far
  long bytes = 0;        // in use
};

namespace heap {

inline std::atomic<long> allocations{0};
inline std::atomic<long> bytes{0};

inline void taken(const void* block, std::size_t size) {
  if (block == nullptr) return;
  allocations.fetch_add(1, std::memory_order_relaxed);
  bytes.fetch_add(static_cast<long>(size), std::memory_order_relaxed);
}
inline void returned(std::size_t size) { bytes.fetch_sub(static_cast<long>(size), std::memory_order_relaxed); }

}  // namespace heap

inline HeapCount heapCount() { return {heap::allocations.load(), heap::bytes.load()}; }

}  // namespace cdpr_kinetostatics

#ifdef __SANITIZE_ADDRESS__

extern "C" {  // of the sanitizers' run time; GCC comes without their header
int __sanitizer_install_malloc_and_free_hooks(void (*taken)(const volatile void*, std::size_t),
                                              void (*returned)(const volatile void*));
std::size_t __sanitizer_get_allocated_size(const volatile void* block);
}

namespace cdpr_kinetostatics::heap {
inline const int kHooks = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void* block, std::size_t size) { taken(const_cast<const void*>(block), size); },
    [](const volatile void* block) {
      if (block != nullptr) returned(__sanitizer_get_allocated_size(block));
    });
}  // namespace cdpr_kinetostatics::heap

#else

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) noexcept {
  void* const block = __libc_malloc(size);
  cdpr_kinetostatics::heap::taken(block, malloc_usable_size(block));
  return block;
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  void* const block = __libc_calloc(count, size);
  cdpr_kinetostatics::heap::taken(block, malloc_usable_size(block));
  return block;
}
void* realloc(void* old, std::size_t size) noexcept {
  const std::size_t before = malloc_usable_size(old);
  void* const block = __libc_realloc(old, size);
  if (block == nullptr && size > 0) return nullptr;
  cdpr_kinetostatics::heap::returned(before);
  cdpr_kinetostatics::heap::taken(block, malloc_usable_size(block));
  return block;
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  void* const block = __libc_memalign(alignment, size);
  cdpr_kinetostatics::heap::taken(block, malloc_usable_size(block));
  return block;
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return memalign(alignment, size); }
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  *block = memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) noexcept {
  cdpr_kinetostatics::heap::returned(malloc_usable_size(block));
  __libc_free(block);
}
}

#endif
