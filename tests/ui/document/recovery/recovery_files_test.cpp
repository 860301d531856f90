#include "core/io/json/document_json.h"
#include "tests/support/faulty_save.h"
#include "tests/support/long_run.h"
#include "ui/document/file_rights.h"
#include "ui/document/recovery/found_recoveries.h"
#include "ui/document/recovery/recovery_files.h"
#include "ui/document/sharing/content_hash.h"
#include "ui/document/state_folder.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QTemporaryDir>

#include <random>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

const auto kId = QString::fromLatin1(test::kRecoveryId);

RecoveryNote noteOf(const QByteArray& work) {
    return {u"/home/a/крива.kriva"_s, contentHash("file"), contentHash(work), contentHash("before"),
            QDateTime(QDate(2026, 2, 1), QTime(1, 2, 3, 4), Qt::UTC)};
}

Document oneCurveInEachSheet() {
    Document document;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        document.sheets[sheet].curves = {withPointsAdded(emptyCurve(sheet), Points{{0, 0}, {1, 2.5}, {3, 2}, {4, 0}})};
    return document;
}

class RecoveryFilesTest : public testing::Test {
  protected:
    static QByteArray bytesOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void put(const QString& path, const QByteArray& bytes) {
        ASSERT_EQ(safeWrite(path, bytes, WriteAccess::OwnerOnly), std::nullopt);
    }
    static mode_t modeOf(const QString& path) { return rightsOf(path).value_or(FileRights()).permissions; }
    std::vector<FoundRecovery> found() const { return takeRecoveries(folder.path()); }
    QStringList names() const { return QDir(folder.path()).entryList(QDir::Files); }

    QTemporaryDir folder;
    const RecoveryFiles files{folder.path(), kId};
    Document document = oneCurveInEachSheet();
    const QByteArray work = QByteArray::fromStdString(writeDocument(document, 0));
};

TEST_F(RecoveryFilesTest, aNoteComesBack) {
    const RecoveryNote note = noteOf(work);
    EXPECT_EQ(readNote(writeNote(note)), note);
    const RecoveryNote untitled{{}, {}, contentHash(work), {}, note.time};
    EXPECT_EQ(readNote(writeNote(untitled)), untitled);
}

TEST_F(RecoveryFilesTest, whatWasWrittenIsFoundAndIsTheOwnersAlone) {
    EXPECT_EQ(writeRecovery(files, noteOf(work), work), std::nullopt);
    const auto recoveries = found();
    ASSERT_EQ(recoveries.size(), 1U);
    EXPECT_EQ(recoveries[0].state, RecoveryState::Whole);
    EXPECT_EQ(recoveries[0].note, noteOf(work));
    EXPECT_EQ(std::get<LoadedFile>(documentFrom(readRecovery(recoveries[0]))).document, document);
    for (const QString& path : {files.document(), files.note(), files.lock()})
        EXPECT_EQ(modeOf(path), 0600U) << path.toStdString();
}

TEST_F(RecoveryFilesTest, theWorkBeforeIsWholeUntilTheNewOneIsThere) {
    RecoveryNote note = noteOf("the next one, not written yet");
    note.previousHash = contentHash(work);
    put(files.note(), writeNote(note));
    put(files.document(), work);
    ASSERT_EQ(found().size(), 1U);
    EXPECT_EQ(found()[0].state, RecoveryState::Whole);
}

TEST_F(RecoveryFilesTest, aNoteWithoutWorkIsToldAndStaysUntilItIsDiscarded) {
    put(files.note(), writeNote(noteOf(work)));
    ASSERT_EQ(found().size(), 1U);
    EXPECT_EQ(found()[0].state, RecoveryState::Missing);
    EXPECT_EQ(found()[0].note, noteOf(work));
    EXPECT_EQ(found()[0].time, noteOf(work).time);
    EXPECT_EQ(names(), QStringList{QFileInfo(files.note()).fileName()});
    put(files.note(), "{");
    ASSERT_EQ(found().size(), 1U);
    EXPECT_EQ(found()[0].note, std::nullopt);
    EXPECT_TRUE(found()[0].time.isValid());
    discardRecovery(std::move(found().at(0)));
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveryFilesTest, aLockAloneIsNothingToRecover) {
    put(files.lock(), "");
    EXPECT_TRUE(found().empty());
}

TEST_F(RecoveryFilesTest, workWithoutANoteIsOfferedWithAWarning) {
    put(files.document(), work);
    ASSERT_EQ(found().size(), 1U);
    EXPECT_EQ(found()[0].state, RecoveryState::Damaged);
    EXPECT_EQ(found()[0].note, std::nullopt);
    EXPECT_TRUE(found()[0].time.isValid());
}

TEST_F(RecoveryFilesTest, whatIsDiscardedIsGone) {
    EXPECT_EQ(writeRecovery(files, noteOf(work), work), std::nullopt);
    discardRecovery(std::move(found().at(0)));
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveryFilesTest, noOtherProgramTakesWhatIsTaken) {
    EXPECT_EQ(writeRecovery(files, noteOf(work), work), std::nullopt);
    const auto first = found();
    EXPECT_EQ(first.size(), 1U);
    EXPECT_TRUE(found().empty());
    EXPECT_EQ(bytesOf(files.document()), work);
}

TEST_F(RecoveryFilesTest, whatAProgramThatIsNoMoreHadIsTaken) {
    EXPECT_EQ(writeRecovery(files, noteOf(work), work), std::nullopt);
    const pid_t child = ::fork();
    if (child == 0) {
        QLockFile lock(files.lock());
        const bool isLocked = lockNow(lock);
        ::_exit(isLocked ? 0 : 1); // without unlocking
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
    EXPECT_TRUE(QFile::exists(files.lock()));
    EXPECT_EQ(found().size(), 1U);
}

TEST_F(RecoveryFilesTest, aLockOfAProgramThatHadThisOnesNumberIsTakenOver) {
    {
        QLockFile lock(files.lock());
        ASSERT_TRUE(lockNow(lock));
        ASSERT_TRUE(QFile::copy(files.lock(), files.lock() + u".kept"_s));
    }
    ASSERT_TRUE(QFile::rename(files.lock() + u".kept"_s, files.lock()));
    QLockFile lock(files.lock());
    EXPECT_TRUE(lockNow(lock));
    QLockFile second(files.lock());
    EXPECT_FALSE(lockNow(second)) << "it is held by now";
}

TEST_F(RecoveryFilesTest, linksAreNotFollowed) {
    QTemporaryDir elsewhere;
    const QString secret = elsewhere.filePath(u"secret"_s);
    put(secret, work);
    ASSERT_TRUE(QFile::link(secret, files.document()));
    ASSERT_TRUE(QFile::link(secret, files.note()));
    EXPECT_EQ(writeRecovery(files, noteOf(work), work), WriteError{WriteFault::NotRegular});
    const auto recoveries = found();
    ASSERT_EQ(recoveries.size(), 1U);
    EXPECT_EQ(recoveries[0].state, RecoveryState::Unreadable);
    EXPECT_EQ(recoveries[0].note, std::nullopt);
    EXPECT_EQ(bytesOf(secret), work);
}

TEST_F(RecoveryFilesTest, filesOfOtherNamesAreLeftAlone) {
    for (const QString& name : {u"a.kriva"_s, u".kriva"_s, u"notes.txt"_s, u"6f1d8a3e.json"_s})
        put(folder.filePath(name), "{}");
    EXPECT_TRUE(found().empty());
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 4);
}

/// One file of the two after the other, damaged at 64 places.
class DamagedRecovery : public RecoveryFilesTest, public testing::WithParamInterface<bool> {
  protected:
    /// The damage is told, and is never taken for the work itself.
    void expectDamage(const QByteArray& whole, const QByteArray& damaged, const char* what, qsizetype at) {
        SCOPED_TRACE(testing::Message() << what << " at " << at);
        ASSERT_NE(whole, damaged);
        put(damagedFile(), damaged);
        const auto recoveries = found();
        ASSERT_EQ(recoveries.size(), 1U);
        const FoundRecovery& one = recoveries[0];
        EXPECT_NE(one.state, RecoveryState::Whole);
        const bool isReadable = std::holds_alternative<LoadedFile>(documentFrom(readRecovery(one)));
        EXPECT_EQ(one.state == RecoveryState::Damaged, isReadable);
        if (isNote()) {
            EXPECT_EQ(one.note, std::nullopt) << "it may name a wrong file";
            EXPECT_TRUE(isReadable);
        }
        EXPECT_EQ(bytesOf(damagedFile()), damaged) << "nothing is removed that nobody discarded";
    }
    [[nodiscard]] static bool isNote() { return GetParam(); }
    [[nodiscard]] QString damagedFile() const { return isNote() ? files.note() : files.document(); }
};

TEST_P(DamagedRecovery, cutsAndChangedBytesAreSeen) {
    constexpr int kDamages = 64;
    EXPECT_EQ(writeRecovery(files, noteOf(work), work), std::nullopt);
    const QByteArray whole = bytesOf(damagedFile());
    std::mt19937 random(20260201);
    for (int i = 0; i < kDamages; ++i) {
        const qsizetype cut = whole.size() * i / kDamages;
        expectDamage(whole, whole.first(cut), "cut", cut);
        const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(whole.size()));
        QByteArray changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ (1 + random() % 255));
        expectDamage(whole, changed, "changed", at);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, DamagedRecovery, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "theNote" : "theWork"; });

TEST_F(RecoveryFilesTest, aFaultInWritingLeavesOneWorkOrTheOtherWithItsNote) {
    const QList<int> sizes = test::isLongRun() ? QList<int>{5'000, 100'000, 3'000'000} : QList<int>{5'000};
    int faultCount = 0;
    for (const int size : sizes) {
        const QByteArray before = test::savedVersion(0, size);
        ASSERT_EQ(writeRecovery(files, noteOf(before), before), std::nullopt);
        const QStringList calls = test::saveUnder(folder.path(), size, u"recovery"_s, {}).calls;
        ASSERT_EQ(calls.count(u"write"_s), 2);
        for (const test::Fault& fault : test::allFaults(calls)) {
            SCOPED_TRACE(test::nameOf(fault, size));
            ASSERT_EQ(writeRecovery(files, noteOf(before), before), std::nullopt);
            const test::SaveOutcome outcome = test::saveUnder(folder.path(), size, u"recovery"_s, fault);
            const QByteArray left = bytesOf(files.document());
            const bool isNew = left == test::savedVersion(1, size);
            EXPECT_TRUE(isNew || left == before);
            EXPECT_TRUE(isNew || !outcome.saidSaved);
            const auto recoveries = found();
            ASSERT_EQ(recoveries.size(), 1U);
            ASSERT_NE(recoveries[0].note, std::nullopt);
            EXPECT_TRUE(recoveries[0].hash == recoveries[0].note->hash ||
                        recoveries[0].hash == recoveries[0].note->previousHash);
            EXPECT_EQ(modeOf(files.document()), 0600U);
            ++faultCount;
        }
    }
    EXPECT_GE(faultCount, test::isLongRun() ? 600 : 200);
}

class StateFolder : public testing::Test {
  protected:
    void SetUp() override { qputenv("XDG_STATE_HOME", folder_.path().toUtf8()); }
    void TearDown() override { qputenv("XDG_STATE_HOME", before_); }
    [[nodiscard]] QString in(const QString& name) const { return folder_.filePath(name); }

  private:
    const QByteArray before_ = qgetenv("XDG_STATE_HOME");
    QTemporaryDir folder_;
};

TEST_F(StateFolder, isTheOwnersAlone) {
    const mode_t mask = ::umask(0);
    const auto folder = privateFolder(u"recovery"_s);
    ::umask(mask);
    EXPECT_EQ(std::get<QString>(folder), in(u"kriva/recovery"_s));
    EXPECT_EQ(rightsOf(in(u"kriva/recovery"_s))->permissions, 0700U);
    ::chmod(QFile::encodeName(in(u"kriva/recovery"_s)).constData(), 0777);
    EXPECT_EQ(std::get<QString>(privateFolder(u"recovery"_s)), in(u"kriva/recovery"_s));
    EXPECT_EQ(rightsOf(in(u"kriva/recovery"_s))->permissions, 0700U);
}

TEST_F(StateFolder, isNoLinkAndNoFileAndNobodyElses) {
    QTemporaryDir elsewhere;
    ASSERT_TRUE(QDir().mkpath(in(u"kriva"_s)));
    ASSERT_TRUE(QFile::link(elsewhere.path(), in(u"kriva/recovery"_s)));
    EXPECT_EQ(std::get<WriteError>(privateFolder(u"recovery"_s)).fault, WriteFault::NotRegular);
    ASSERT_EQ(safeWrite(in(u"kriva/locks"_s), "a file"), std::nullopt);
    EXPECT_EQ(std::get<WriteError>(privateFolder(u"locks"_s)).fault, WriteFault::NotRegular);
    if (::getuid() != 0)
        return;
    ASSERT_TRUE(QDir().mkpath(in(u"kriva/others"_s)));
    ASSERT_EQ(::chown(QFile::encodeName(in(u"kriva/others"_s)).constData(), 1234, 2345), 0);
    EXPECT_EQ(std::get<WriteError>(privateFolder(u"others"_s)).fault, WriteFault::Denied);
}

TEST_F(StateFolder, isInTheHomeWhereTheVariableNamesNoPlace) {
    for (const char* value : {"", "relative/place"}) {
        qputenv("XDG_STATE_HOME", value);
        EXPECT_EQ(stateFolder(), QDir::homePath() + u"/.local/state/kriva"_s);
    }
}

} // namespace
} // namespace kriva::ui
