#pragma once

#include "tests/support/failing_syscalls.h"
#include "tests/support/save_versions.h"

#include <gtest/gtest.h>
#include <QProcess>

#include <cerrno>
#include <vector>

namespace kriva::test {

struct SaveOutcome {
    bool wasKilled = false;
    bool saidSaved = false;
    QStringList calls;
};

/// A save of version 1 by a process of its own, hit by a fault: see save_once.cpp.
[[nodiscard]] inline SaveOutcome saveUnder(const QString& path, int size, const QString& how, const Fault& fault) {
    QProcess process;
    process.start(QStringLiteral(KRIVA_SAVE_ONCE),
                  {path, QString::number(size), how, QString::number(static_cast<int>(fault.kind)),
                   QString::number(fault.call), QString::number(fault.error),
                   QString::number(fault.isLasting ? 1 : 0)});
    EXPECT_TRUE(process.waitForFinished());
    const bool wasKilled = process.exitStatus() == QProcess::CrashExit;
    EXPECT_TRUE(wasKilled || process.exitCode() < 2) << process.errorString().toStdString();
    return {wasKilled, !wasKilled && process.exitCode() == 0,
            QString::fromLatin1(process.readAllStandardOutput()).split(QLatin1Char(' '), Qt::SkipEmptyParts)};
}

/// Every fault at every one of these system calls.
[[nodiscard]] inline std::vector<Fault> allFaults(const QStringList& calls) {
    std::vector<Fault> faults;
    for (int call = 0; call < calls.size(); ++call) {
        for (const int error : {ENOSPC, EIO, EDQUOT, EACCES})
            for (const bool isLasting : {false, true})
                faults.push_back({FaultKind::Error, call, error, isLasting});
        for (const FaultKind kind : {FaultKind::KillBefore, FaultKind::KillAfter})
            faults.push_back({kind, call});
        if (calls[call] != QLatin1String("write"))
            continue;
        for (const FaultKind kind : {FaultKind::ShortWrite, FaultKind::ShortThenFull, FaultKind::KillHalfway})
            faults.push_back({kind, call, 0, kind == FaultKind::ShortWrite});
    }
    return faults;
}

[[nodiscard]] inline testing::Message nameOf(const Fault& fault, int size) {
    return testing::Message() << "size " << size << " kind " << static_cast<int>(fault.kind) << " call " << fault.call
                              << " errno " << fault.error << " lasting " << fault.isLasting;
}

} // namespace kriva::test
