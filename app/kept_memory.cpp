#include "app/kept_memory.h"

#ifdef __GLIBC__
#include <array>
#include <cstdint>
#include <cstdlib>
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace kriva {

#ifdef __GLIBC__
namespace {

constexpr std::size_t kMiB = 1 << 20;

/// Has the system give the first part of the heap in pages of 2 MiB, where it has such: a page costs when it is touched
/// first, and a long curve with its figure is ten thousand of the usual ones. Nothing is touched here.
void askForLargePages() {
    constexpr std::size_t kBlock = 16 * kMiB;
    constexpr std::uintptr_t kPage = 4096;
    std::array<void*, 12> blocks{}; // one after the other, since the heap is new
    for (void*& block : blocks)
        block = std::malloc(kBlock);
    for (void* block : blocks) {
        const std::uintptr_t start = (reinterpret_cast<std::uintptr_t>(block) + kPage - 1) / kPage * kPage;
        madvise(reinterpret_cast<void*>(start), kBlock - kPage, MADV_HUGEPAGE); // refused: all is as it was
    }
    for (void* block : blocks)
        std::free(block);
}

} // namespace
#endif

void keepFreedMemory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 * kMiB);  // the most that it takes: all that is smaller lies in the heap
    mallopt(M_TRIM_THRESHOLD, 256 * kMiB); // a few figures of long curves
    mallopt(M_TOP_PAD, 64 * kMiB);
    askForLargePages();
#endif
}

} // namespace kriva
