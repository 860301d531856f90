#pragma once

#include <string>

/// System calls of saving a file that fail on demand. A program that is linked with this answers such calls of Qt and
/// of its own by itself; nothing fails before arm() and after disarm().
namespace kriva::test {

enum class FaultKind {
    None,
    Error,         ///< The call does nothing and reports an errno.
    ShortWrite,    ///< A write takes half of its bytes; other calls work.
    ShortThenFull, ///< A write takes half of its bytes and every one after it reports ENOSPC; other calls work.
    KillBefore,    ///< The program ends by SIGKILL instead of the call,
    KillHalfway,   ///< after half of the bytes of a write,
    KillAfter      ///< or after the call.
};

struct Fault {
    FaultKind kind = FaultKind::None;
    int call = 0;           ///< Which call is hit, counted from 0 after arm().
    int error = 0;          ///< The errno of FaultKind::Error.
    bool isLasting = false; ///< Every later call is hit too.
};

void arm(const Fault& fault);

/// From now on there are no files without a name, as on some network file systems.
void refuseUnnamedFiles();

/// The names of the calls since arm(), in order, a blank after each.
[[nodiscard]] std::string disarm();

} // namespace kriva::test
