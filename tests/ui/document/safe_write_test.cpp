#include "tests/support/faulty_save.h"
#include "tests/support/long_run.h"
#include "ui/document/file_rights.h"
#include "ui/document/safe_write.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <cerrno>
#include <functional>
#include <random>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

using test::Fault;
using test::FaultKind;
using test::savedVersion;

constexpr std::array kSizes = {5'000, 100'000, 3'000'000};

class SafeWrite : public ::testing::Test {
  protected:
    QString in(const QString& name) const { return folder.filePath(name); }
    QStringList names() const { return QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot); }

    static QByteArray bytesOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void put(const QString& path, const QByteArray& bytes) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        ASSERT_EQ(file.write(bytes), bytes.size());
    }
    static mode_t modeOf(const QString& path) {
        struct stat status = {};
        EXPECT_EQ(::stat(QFile::encodeName(path).constData(), &status), 0);
        return status.st_mode & 07777;
    }

    QTemporaryDir folder;
};

TEST_F(SafeWrite, writesNewFilesAndReplacesOldOnes) {
    for (const int size : {0, 1, 5'000, 3'000'000}) {
        EXPECT_EQ(safeWrite(in(u"a"_s), savedVersion(size, size)), std::nullopt);
        EXPECT_EQ(bytesOf(in(u"a"_s)), savedVersion(size, size));
    }
    EXPECT_EQ(names(), QStringList{u"a"_s});
}

TEST_F(SafeWrite, anExistingFileKeepsItsPermissions) {
    put(in(u"a"_s), "old");
    ::chmod(QFile::encodeName(in(u"a"_s)).constData(), 0640);
    EXPECT_EQ(safeWrite(in(u"a"_s), "new"), std::nullopt);
    EXPECT_EQ(modeOf(in(u"a"_s)), 0640U);
}

TEST_F(SafeWrite, aNameAsLongAsNamesCanBeIsWrittenAgainAndAgain) {
    for (const int length : {1, 249, 250, 251, 254, 255}) {
        const QString path = in(QString(length, u'n'));
        for (const QByteArray& bytes : QByteArrayList{"one", "two", "three"}) {
            EXPECT_EQ(safeWrite(path, bytes), std::nullopt) << length;
            EXPECT_EQ(bytesOf(path), bytes);
        }
    }
    EXPECT_EQ(safeWrite(in(QString(256, u'n')), "new"), (WriteError{WriteFault::Failed, ENAMETOOLONG}));
}

TEST_F(SafeWrite, anExistingFileKeepsItsOwnerAndGroup) {
    if (::getuid() != 0)
        GTEST_SKIP() << "only root gives files away";
    constexpr uid_t kSomebody = 1234;
    constexpr gid_t kTheirGroup = 2345;
    put(in(u"a"_s), "old");
    const QByteArray name = QFile::encodeName(in(u"a"_s));
    ASSERT_EQ(::chown(name.constData(), kSomebody, kTheirGroup), 0);
    ASSERT_EQ(::chmod(name.constData(), 0664), 0);
    const auto before = rightsOf(in(u"a"_s));
    EXPECT_EQ(safeWrite(in(u"a"_s), "new"), std::nullopt);
    EXPECT_EQ(rightsOf(in(u"a"_s)), before);
    EXPECT_EQ(before, (FileRights{kSomebody, kTheirGroup, 0664}));
}

TEST_F(SafeWrite, aFileOfTheOwnerAloneIsReadableByNobodyElse) {
    put(in(u"a"_s), "old");
    ::chmod(QFile::encodeName(in(u"a"_s)).constData(), 0644);
    for (const QString& name : {u"a"_s, u"b"_s}) {
        EXPECT_EQ(safeWrite(in(name), "new", WriteAccess::OwnerOnly), std::nullopt);
        EXPECT_EQ(modeOf(in(name)), 0600U);
    }
}

TEST_F(SafeWrite, theFileBehindALinkIsReplacedAndTheLinkStays) {
    QDir(folder.path()).mkdir(u"deep"_s);
    put(in(u"deep/file"_s), "old");
    QFile::link(u"deep/file"_s, in(u"second"_s));
    QFile::link(u"second"_s, in(u"first"_s));
    EXPECT_EQ(safeWrite(in(u"first"_s), "new"), std::nullopt);
    EXPECT_TRUE(QFileInfo(in(u"first"_s)).isSymLink());
    EXPECT_TRUE(QFileInfo(in(u"second"_s)).isSymLink());
    EXPECT_EQ(bytesOf(in(u"deep/file"_s)), "new");
}

TEST_F(SafeWrite, aLinkIsRefusedWhereTheFileIsTheOwnersAlone) {
    put(in(u"file"_s), "old");
    QFile::link(u"file"_s, in(u"link"_s));
    EXPECT_EQ(safeWrite(in(u"link"_s), "new", WriteAccess::OwnerOnly), WriteError{WriteFault::NotRegular});
    EXPECT_EQ(bytesOf(in(u"file"_s)), "old");
}

TEST_F(SafeWrite, whatIsNoRegularFileIsRefused) {
    ::mkfifo(QFile::encodeName(in(u"pipe"_s)).constData(), 0600);
    QDir(folder.path()).mkdir(u"folder"_s);
    QFile::link(u"pipe"_s, in(u"toPipe"_s));
    QFile::link(u"loop"_s, in(u"loop"_s));
    for (const QString& path : {in(u"pipe"_s), in(u"folder"_s), in(u"toPipe"_s), in(u"loop"_s), u"/dev/full"_s})
        EXPECT_EQ(safeWrite(path, "new"), WriteError{WriteFault::NotRegular}) << path.toStdString();
    EXPECT_TRUE(QFileInfo(in(u"toPipe"_s)).isSymLink());
}

TEST_F(SafeWrite, aMissingFolderIsNamedAsTheReason) {
    EXPECT_EQ(safeWrite(in(u"missing/a"_s), "new"), (WriteError{WriteFault::NoFolder, ENOENT}));
    put(in(u"file"_s), "old");
    EXPECT_EQ(safeWrite(in(u"file/a"_s), "new"), (WriteError{WriteFault::NoFolder, ENOTDIR}));
}

/// Runs `check` as a person without special rights and tells whether it came out true.
bool holdsWithoutRoot(const std::function<bool()>& check) {
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t kNobody = 65534;
        const bool isPlain = ::getuid() != 0 || (::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
        ::_exit(isPlain && check() ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(SafeWrite, aReadOnlyFolderOrFileIsDeniedAndTheOldFileStands) {
    const QByteArray folderName = QFile::encodeName(folder.path());
    put(in(u"a"_s), "old");
    ::chmod(QFile::encodeName(in(u"a"_s)).constData(), 0666);
    ::chmod(folderName.constData(), 0555);
    const auto isDenied = [&] {
        const auto error = safeWrite(in(u"a"_s), "new");
        return error && error->fault == WriteFault::Denied;
    };
    EXPECT_TRUE(holdsWithoutRoot(isDenied));
    ::chmod(folderName.constData(), 0777);
    ::chmod(QFile::encodeName(in(u"a"_s)).constData(), 0444);
    EXPECT_TRUE(holdsWithoutRoot(isDenied));
    EXPECT_EQ(bytesOf(in(u"a"_s)), "old");
    EXPECT_EQ(names(), QStringList{u"a"_s});
}

TEST_F(SafeWrite, whatAnotherGroupMightIsNotGivenToOnesOwn) {
    if (::getuid() != 0)
        GTEST_SKIP() << "only root makes files of others";
    put(in(u"a"_s), "old");
    const QByteArray name = QFile::encodeName(in(u"a"_s));
    ::chmod(QFile::encodeName(folder.path()).constData(), 0777);
    ASSERT_EQ(::chown(name.constData(), 1234, 2345), 0);
    ASSERT_EQ(::chmod(name.constData(), 0676), 0);
    EXPECT_TRUE(holdsWithoutRoot([&] {
        const auto before = rightsOf(in(u"a"_s));
        return !safeWrite(in(u"a"_s), "new") && !keptRights(before, in(u"a"_s));
    }));
    EXPECT_EQ(bytesOf(in(u"a"_s)), "new");
    EXPECT_EQ(modeOf(in(u"a"_s)), 0666U);
}

/// Saves that are hit by a fault.
class FaultySave : public SafeWrite, public testing::WithParamInterface<QString> {
  protected:
    /// Puts `old` there, or nothing if it is empty.
    void start(const QByteArray& old) const {
        QDir(folder.path()).removeRecursively();
        QDir().mkpath(folder.path());
        if (!old.isEmpty()) {
            put(path, old);
            ::chmod(QFile::encodeName(path).constData(), 0640); // to be kept
        }
    }

    /// Saves under the fault in the place of `old` and looks at what is left. The exchange is the system call that
    /// puts the new file in the place of the old one.
    void tryFault(const QByteArray& old, int size, const Fault& fault, qsizetype exchange) {
        SCOPED_TRACE(test::nameOf(fault, size));
        start(old);
        const test::SaveOutcome outcome = test::saveUnder(path, size, GetParam(), fault);
        const QByteArray left = bytesOf(path);
        const bool isNew = left == savedVersion(1, size);
        EXPECT_TRUE(isNew || left == old) << "neither old nor new";
        EXPECT_TRUE(isNew || !outcome.saidSaved) << "said saved and is not";
        if (!outcome.saidSaved && !outcome.wasKilled && fault.call <= exchange) {
            EXPECT_EQ(left, old) << "refused, and yet changed";
        }
        if (!outcome.wasKilled) {
            EXPECT_EQ(names(), left.isEmpty() ? QStringList() : QStringList{u"a"_s}) << "litter";
        }
        if (!old.isEmpty()) {
            EXPECT_EQ(modeOf(path) & ~0640U, 0U) << "open to more than before";
        }
        ++faultCount;
    }

    /// Every fault in turn at every system call of a save that replaces `old`.
    void tryAllFaults(const QByteArray& old, int size) {
        start(old);
        const QStringList calls = test::saveUnder(path, size, GetParam(), {}).calls;
        const qsizetype exchange =
            calls.lastIndexOf(old.isEmpty() && GetParam() == u"unnamed" ? u"linkat"_s : u"rename"_s);
        ASSERT_GE(exchange, 0);
        ASSERT_GE(calls.count(u"fsync"_s), 2) << "file and folder";
        ASSERT_EQ(calls.contains(u"fchmod"_s), !old.isEmpty());
        for (const Fault& fault : test::allFaults(calls))
            tryFault(old, size, fault, exchange);
    }

    const QString path = in(u"a"_s);
    int faultCount = 0;
};

TEST_P(FaultySave, leavesTheOldFileOrTheNewAndNeverClaimsWhatIsNot) {
    tryAllFaults({}, kSizes.front());
    tryAllFaults(savedVersion(0, kSizes.front()), kSizes.front());
    if (test::isLongRun() || GetParam() == u"unnamed")
        for (const int size : {kSizes[1], kSizes[2]})
            tryAllFaults(savedVersion(0, size), size);
    EXPECT_GE(faultCount, test::isLongRun() || GetParam() == u"unnamed" ? 250 : 200);
    RecordProperty("faults", faultCount);
}

TEST_P(FaultySave, aShortWriteIsContinued) {
    const QStringList calls = test::saveUnder(path, kSizes[1], GetParam(), {}).calls;
    const int firstWrite = static_cast<int>(calls.indexOf(u"write"_s));
    EXPECT_TRUE(test::saveUnder(path, kSizes[1], GetParam(), {FaultKind::ShortWrite, firstWrite, 0, true}).saidSaved);
    EXPECT_EQ(bytesOf(path), savedVersion(1, kSizes[1]));
}

TEST_P(FaultySave, permissionsThatCannotBeSetAreLostToEverybodyElseAndSeen) {
    start("old");
    const auto before = rightsOf(path);
    const QStringList calls = test::saveUnder(path, kSizes[0], GetParam(), {}).calls;
    EXPECT_TRUE(keptRights(before, path));
    const int call = static_cast<int>(calls.indexOf(u"fchmod"_s));
    EXPECT_TRUE(test::saveUnder(path, kSizes[0], GetParam(), {FaultKind::Error, call, EPERM}).saidSaved);
    EXPECT_FALSE(keptRights(before, path));
    EXPECT_EQ(modeOf(path), 0600U);
}

INSTANTIATE_TEST_SUITE_P(ByWayOf, FaultySave, testing::Values(u"unnamed"_s, u"named"_s),
                         [](const auto& tested) { return tested.param.toStdString(); });

TEST_F(SafeWrite, aKillAtAnyMomentLosesNothingThatWasSaidToBeSaved) {
    const QString path = in(u"a"_s);
    if (!test::isLongRun())
        GTEST_SKIP() << "only in the long run";
    std::mt19937 random(20240229);
    for (int kill = 0; kill < 200; ++kill) {
        const int size = kSizes[static_cast<std::size_t>(kill) % kSizes.size()];
        put(path, savedVersion(0, size));
        QProcess process;
        process.start(QStringLiteral(KRIVA_SAVE_ONCE), {path, QString::number(size), u"forever"_s});
        ASSERT_TRUE(process.waitForReadyRead());
        ::usleep(static_cast<useconds_t>(random() % 20'000));
        process.kill();
        ASSERT_TRUE(process.waitForFinished());
        const int said = process.readAllStandardOutput().trimmed().split('\n').last().toInt();
        const QByteArray left = bytesOf(path);
        EXPECT_TRUE(left == savedVersion(said, size) || left == savedVersion(said + 1, size)) << "kill " << kill;
    }
}

} // namespace
} // namespace kriva::ui
