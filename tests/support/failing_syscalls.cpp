#include "tests/support/failing_syscalls.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace kriva::test {
namespace {

bool isArmed = false;
Fault fault;
int callCount = 0;
bool areUnnamedRefused = false;
std::string callNames;

[[noreturn]] void die() {
    ::kill(::getpid(), SIGKILL);
    for (;;)
        ::pause();
}

[[nodiscard]] bool isHit() {
    return callCount == fault.call || (fault.isLasting && callCount > fault.call);
}

/// Does the call unless a fault is due. `doIt(half)` makes the system call, of a write half of it.
template <typename Call>
long guarded(const char* name, Call doIt) {
    if (!isArmed)
        return doIt(false);
    const bool isWrite = std::string_view(name) == "write";
    const FaultKind kind = isHit() ? fault.kind : FaultKind::None;
    ++callCount;
    callNames.append(name).append(" ");
    switch (kind) {
    case FaultKind::Error:
        errno = fault.error;
        return -1;
    case FaultKind::ShortWrite:
        return doIt(isWrite);
    case FaultKind::ShortThenFull:
        if (!isWrite)
            return doIt(false);
        fault = {FaultKind::Error, callCount, ENOSPC, true};
        return doIt(true);
    case FaultKind::KillBefore:
        die();
    case FaultKind::KillHalfway:
        if (isWrite)
            (void)doIt(true);
        die();
    case FaultKind::KillAfter:
        (void)doIt(false);
        die();
    case FaultKind::None:
        break;
    }
    return doIt(false);
}

} // namespace

void arm(const Fault& newFault) {
    fault = newFault;
    callCount = 0;
    callNames.clear();
    callNames.reserve(4096);
    isArmed = true;
}

void refuseUnnamedFiles() {
    areUnnamedRefused = true;
}

std::string disarm() {
    isArmed = false;
    return callNames;
}

} // namespace kriva::test

namespace {

using kriva::test::guarded;

int openFile(int folder, const char* path, int flags, int mode) {
    if (kriva::test::areUnnamedRefused && (flags & O_TMPFILE) == O_TMPFILE) {
        errno = EOPNOTSUPP;
        return -1;
    }
    return static_cast<int>(guarded("open", [=](bool) { return ::syscall(SYS_openat, folder, path, flags, mode); }));
}

int modeOf(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, int) : 0;
}

} // namespace

// The C library's functions of the same names, seen before it by the dynamic linker.
extern "C" {

#define KRIVA_OPEN(name)                                                                                               \
    int name(const char* path, int flags, ...) {                                                                       \
        va_list arguments;                                                                                             \
        va_start(arguments, flags);                                                                                    \
        const int mode = modeOf(flags, arguments);                                                                     \
        va_end(arguments);                                                                                             \
        return openFile(AT_FDCWD, path, flags, mode);                                                                  \
    }
KRIVA_OPEN(open)
KRIVA_OPEN(open64)
#undef KRIVA_OPEN

int openat(int folder, const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = modeOf(flags, arguments);
    va_end(arguments);
    return openFile(folder, path, flags, mode);
}

int fstat(int file, struct stat* status) noexcept {
    return static_cast<int>(guarded("fstat", [=](bool) { return ::syscall(SYS_fstat, file, status); }));
}

int fstatat(int folder, const char* path, struct stat* status, int flags) noexcept {
    return static_cast<int>(
        guarded("fstatat", [=](bool) { return ::syscall(SYS_newfstatat, folder, path, status, flags); }));
}

int fchown(int file, uid_t owner, gid_t group) noexcept {
    return static_cast<int>(guarded("fchown", [=](bool) { return ::syscall(SYS_fchown, file, owner, group); }));
}

ssize_t write(int file, const void* bytes, size_t count) {
    return guarded("write", [=](bool half) {
        return ::syscall(SYS_write, file, bytes, half ? std::max<size_t>(count / 2, 1) : count);
    });
}

int fsync(int file) {
    return static_cast<int>(guarded("fsync", [=](bool) { return ::syscall(SYS_fsync, file); }));
}

int fdatasync(int file) {
    return static_cast<int>(guarded("fdatasync", [=](bool) { return ::syscall(SYS_fdatasync, file); }));
}

int fchmod(int file, mode_t mode) noexcept {
    return static_cast<int>(guarded("fchmod", [=](bool) { return ::syscall(SYS_fchmod, file, mode); }));
}

off64_t lseek64(int file, off64_t offset, int whence) noexcept {
    return guarded("lseek", [=](bool) { return ::syscall(SYS_lseek, file, offset, whence); });
}

int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) noexcept {
    return static_cast<int>(
        guarded("linkat", [=](bool) { return ::syscall(SYS_linkat, fromFolder, from, toFolder, to, flags); }));
}

int renameat(int fromFolder, const char* from, int toFolder, const char* to) noexcept {
    return static_cast<int>(
        guarded("rename", [=](bool) { return ::syscall(SYS_renameat, fromFolder, from, toFolder, to); }));
}

int close(int file) {
    return static_cast<int>(guarded("close", [=](bool) { return ::syscall(SYS_close, file); }));
}

} // extern "C"
