#include "app/kept_memory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace kriva {

void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int kMiB = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 * kMiB);  // the most that it takes: all that is smaller lies in the heap
    mallopt(M_TRIM_THRESHOLD, 256 * kMiB); // a few figures of long curves
    mallopt(M_TOP_PAD, 64 * kMiB);
#endif
}

} // namespace kriva
