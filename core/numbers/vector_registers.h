#pragma once

namespace kriva {

/// Clears the upper halves of the processor's vector registers. Wherever these were left in use, each call of std::fma,
/// which uses the newer encoding of vector instructions among the older one of the code around it, costs as much as
/// forty: called before a work of very many double-double operations. A few nanoseconds; nothing where there is nothing
/// to clear. Source: Intel 64 and IA-32 Architectures Optimization Reference Manual, section 15.3.
void clearVectorRegisters();

} // namespace kriva
