#include "core/numbers/vector_registers.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace kriva {

#ifdef __x86_64__

namespace {

[[gnu::target("avx")]] void clear() {
    _mm256_zeroupper();
}

} // namespace

void clearVectorRegisters() {
    if (__builtin_cpu_supports("avx"))
        clear();
}

#else

void clearVectorRegisters() {}

#endif

} // namespace kriva
