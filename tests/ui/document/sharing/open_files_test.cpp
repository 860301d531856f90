#include "ui/document/safe_write.h"
#include "ui/document/sharing/open_files.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <sys/wait.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

using Claim = std::unique_ptr<OpenFiles::Claim>;

class OpenFilesTest : public testing::Test {
  protected:
    OpenFilesTest() {
        qputenv("XDG_STATE_HOME", folder.filePath(u"state"_s).toUtf8());
        EXPECT_EQ(safeWrite(path, "a document"), std::nullopt);
    }
    ~OpenFilesTest() override { qputenv("XDG_STATE_HOME", homeBefore); }
    /// Null where somebody else has it.
    static Claim claimed(OpenFiles& files, const QString& path, const QObject* holder) {
        auto result = files.claim(path, holder);
        Claim* claim = std::get_if<Claim>(&result);
        return claim ? std::move(*claim) : nullptr;
    }

    const QByteArray homeBefore = qgetenv("XDG_STATE_HOME");
    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.kriva"_s);
    QObject first;
    QObject second;
    OpenFiles files;
    OpenFiles otherProgram; ///< the lock is the system's, and does not know that both are this one
};

TEST_F(OpenFilesTest, aFileIsOneHoldersInThisProgramAndInOthers) {
    Claim claim = claimed(files, path, &first);
    ASSERT_NE(claim, nullptr);
    EXPECT_EQ(files.holderOf(path), &first);
    EXPECT_EQ(claimed(files, path, &second), nullptr);
    EXPECT_EQ(claimed(otherProgram, path, &second), nullptr);
    EXPECT_EQ(otherProgram.holderOf(path), nullptr);
    claim.reset();
    EXPECT_EQ(files.holderOf(path), nullptr);
    EXPECT_NE(claimed(otherProgram, path, &second), nullptr);
}

TEST_F(OpenFilesTest, whoHasAFileBesideAnotherHasItStillWhenThatOneGoes) {
    OpenFiles thirdProgram;
    Claim claim = claimed(files, path, &first);
    Claim beside = otherProgram.claimBeside(path, &second);
    EXPECT_TRUE(claim->comesFirst());
    EXPECT_FALSE(beside->comesFirst());
    claim.reset();
    EXPECT_EQ(claimed(thirdProgram, path, &first), nullptr) << "nobody has asked yet who comes first";
    EXPECT_TRUE(beside->comesFirst());
    EXPECT_EQ(claimed(thirdProgram, path, &first), nullptr);
    const Claim later = thirdProgram.claimBeside(path, &first);
    EXPECT_FALSE(later->comesFirst());
    EXPECT_TRUE(beside->comesFirst());
    beside.reset();
    EXPECT_EQ(claimed(files, path, &second), nullptr);
    EXPECT_TRUE(later->comesFirst());
}

TEST_F(OpenFilesTest, nobodyHasAFileBesideAProgramThatIsNoMore) {
    const pid_t child = ::fork();
    if (child == 0) {
        Claim kept = claimed(files, path, &first);
        const Claim beside = otherProgram.claimBeside(path, &second);
        ::_exit(beside->comesFirst() ? 1 : 0); // without giving up either
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
    Claim claim = claimed(files, path, &first);
    ASSERT_NE(claim, nullptr);
    claim.reset();
    EXPECT_EQ(QDir(folder.filePath(u"state/kriva/locks"_s)).entryList(QDir::Files), QStringList());
}

TEST_F(OpenFilesTest, aFileOfTwoWindowsIsThatOfTheSecondWhenTheFirstIsClosed) {
    Claim claim = claimed(files, path, &first);
    Claim beside = files.claimBeside(path, &second);
    EXPECT_TRUE(claim->isOn(path));
    EXPECT_TRUE(beside->isOn(folder.filePath(u"./a.kriva"_s)));
    EXPECT_FALSE(beside->comesFirst());
    EXPECT_EQ(files.holderOf(path), &first);
    claim.reset();
    EXPECT_EQ(files.holderOf(path), &second);
    EXPECT_TRUE(beside->comesFirst());
    EXPECT_EQ(claimed(otherProgram, path, &first), nullptr);
    beside.reset();
    EXPECT_EQ(files.holderOf(path), nullptr);
    EXPECT_NE(claimed(otherProgram, path, &first), nullptr);
}

TEST_F(OpenFilesTest, allNamesOfAFileAreTheSame) {
    ASSERT_TRUE(QFile::link(path, folder.filePath(u"link.kriva"_s)));
    ASSERT_TRUE(QDir(folder.path()).mkdir(u"deep"_s));
    const Claim claim = claimed(files, folder.filePath(u"link.kriva"_s), &first);
    for (const QString& name : {path, folder.filePath(u"deep/../a.kriva"_s), QDir().relativeFilePath(path)})
        EXPECT_EQ(files.holderOf(name), &first) << name.toStdString();
}

TEST_F(OpenFilesTest, aFileThatIsNotThereYetHasItsName) {
    const QString future = folder.filePath(u"future.kriva"_s);
    const Claim claim = claimed(files, future, &first);
    EXPECT_EQ(files.holderOf(folder.filePath(u"./future.kriva"_s)), &first);
    EXPECT_EQ(safeWrite(future, "now it is"), std::nullopt);
    EXPECT_EQ(files.holderOf(future), &first);
}

TEST_F(OpenFilesTest, bringsUpTheOneWhoHasIt) {
    QSignalSpy asked(&files, &OpenFiles::bringUpAsked);
    EXPECT_FALSE(files.bringUp(path));
    const Claim claim = claimed(files, path, &first);
    EXPECT_TRUE(files.bringUp(path));
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked[0][0].value<const QObject*>(), &first);
}

TEST_F(OpenFilesTest, withoutAFolderForLocksEveryFileCanBeOpened) {
    ASSERT_EQ(safeWrite(folder.filePath(u"state"_s), "a file"), std::nullopt);
    const Claim claim = claimed(files, path, &first);
    EXPECT_NE(claim, nullptr);
    EXPECT_EQ(files.holderOf(path), &first);
    const Claim beside = otherProgram.claimBeside(path, &second);
    EXPECT_TRUE(beside->comesFirst()) << "nobody knows of the other";
}

TEST_F(OpenFilesTest, aNameAsLongAsNamesCanBeIsLockedToo) {
    const QString longName = folder.filePath(QString(255, u'n'));
    const Claim claim = claimed(files, longName, &first);
    EXPECT_EQ(claimed(otherProgram, longName, &second), nullptr);
}

} // namespace
} // namespace kriva::ui
