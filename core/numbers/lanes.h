#pragma once

#include <cstddef>
#include <cstring>

/// Work on four doubles at once. Where the processor has registers so wide it is done in one step, elsewhere in two: to
/// the last bit as with one double after the other, since no operation is contracted.
namespace kriva {

// Aligned in all functions as in those for the widest registers: GCC aligns less where these are not in use.
using Lanes [[gnu::vector_size(32), gnu::aligned(32)]] = double;
inline constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(double);
static_assert(alignof(Lanes) == kLanes * sizeof(double));

// Lanes are handed over by reference: by value their way depends on the processor for which a function is compiled.

/// The same number in each lane.
[[gnu::always_inline]] inline void spread(double value, Lanes& lanes) {
    lanes = Lanes{value, value, value, value};
}
[[gnu::always_inline]] inline void load(const double* from, Lanes& lanes) {
    std::memcpy(&lanes, from, sizeof lanes);
}
[[gnu::always_inline]] inline void store(const Lanes& lanes, double* to) {
    std::memcpy(to, &lanes, sizeof lanes);
}

#ifdef __x86_64__
template <class Work>
[[gnu::target("avx2")]] void workByAvx2(const Work& work) {
    work();
}
#endif

/// Does the work by the widest registers that the processor has. All that it calls must be inlined, itself included
/// ([&]() __attribute__((always_inline)) {}), since functions are compiled for the registers that all processors have.
template <class Work>
void workByLanes(const Work& work) {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2"))
        return workByAvx2(work);
#endif
    work();
}

} // namespace kriva
