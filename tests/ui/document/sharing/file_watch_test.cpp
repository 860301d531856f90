#include "ui/document/safe_write.h"
#include "ui/document/sharing/content_hash.h"
#include "ui/document/sharing/file_watch.h"

#include <gtest/gtest.h>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

using namespace std::chrono_literals;

constexpr int kPatience = 60'000; // ms until a signal that does not come is a failure

class FileWatchTest : public testing::Test {
  protected:
    FileWatchTest() {
        watch.setPause(1ms);
        put("one");
        watch.watch(path, contentHash("one"));
    }
    void put(const QByteArray& bytes) { EXPECT_EQ(safeWrite(path, bytes), std::nullopt); }
    /// As programs do that know no better.
    void writeInPlace(const QByteArray& bytes) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(bytes);
    }
    /// Waits until that is told, past what a file written in several steps was meanwhile.
    void expectTold(FileState state) {
        while (watch.state() != state)
            ASSERT_TRUE(changed.wait(kPatience));
        EXPECT_EQ(watch.look(), state);
        EXPECT_EQ(watch.lookIfWritten(), state);
    }

    QTemporaryDir folder;
    const QString path = folder.filePath(u"a.kriva"_s);
    FileWatch watch;
    QSignalSpy changed{&watch, &FileWatch::changed};
};

TEST_F(FileWatchTest, seesEachReplacementAfterAnother) {
    for (int i = 0; i < 5; ++i) {
        put(QByteArray::number(i));
        ASSERT_TRUE(changed.wait(kPatience)) << i;
        EXPECT_EQ(watch.state(), FileState::Changed);
    }
    put("one");
    expectTold(FileState::Same);
}

TEST_F(FileWatchTest, seesWhatIsWrittenInPlace) {
    writeInPlace("two");
    expectTold(FileState::Changed);
    writeInPlace("three");
    ASSERT_TRUE(changed.wait(kPatience));
    writeInPlace("one");
    expectTold(FileState::Same);
}

TEST_F(FileWatchTest, seesThatAFileIsGoneAndBack) {
    ASSERT_TRUE(QFile::remove(path));
    expectTold(FileState::Gone);
    put("one");
    expectTold(FileState::Same);
    ASSERT_TRUE(QFile::rename(path, folder.filePath(u"b.kriva"_s)));
    expectTold(FileState::Gone);
    put("other");
    expectTold(FileState::Changed);
}

TEST_F(FileWatchTest, whatIsWrittenHereIsNoNews) {
    put("two");
    watch.watch(path, contentHash("two"));
    put("two"); // the same again
    QFile other(folder.filePath(u"other"_s));
    ASSERT_TRUE(other.open(QIODevice::WriteOnly));
    other.close();
    put("three");
    ASSERT_TRUE(changed.wait(kPatience));
    EXPECT_EQ(changed.count(), 1);
    EXPECT_EQ(watch.state(), FileState::Changed);
}

TEST_F(FileWatchTest, seesWhatHappenedLongBefore) {
    put("two");
    watch.watch(path, contentHash("one"));
    watch.lookSoon();
    expectTold(FileState::Changed);
}

TEST_F(FileWatchTest, looksByItselfWithoutWaitingToBeTold) {
    put("two");
    EXPECT_EQ(watch.look(), FileState::Changed);
    EXPECT_EQ(watch.lookIfWritten(), FileState::Changed);
    ASSERT_TRUE(QFile::remove(path));
    EXPECT_EQ(watch.look(), FileState::Gone);
    EXPECT_EQ(watch.lookIfWritten(), FileState::Gone);
}

TEST_F(FileWatchTest, aDocumentWithoutAFileIsAlwaysTheSame) {
    writeInPlace("two");
    expectTold(FileState::Changed);
    watch.watch({}, {});
    EXPECT_EQ(watch.state(), FileState::Same);
    EXPECT_EQ(watch.look(), FileState::Same);
    EXPECT_EQ(watch.lookIfWritten(), FileState::Same);
    EXPECT_EQ(changed.takeLast()[0].value<FileState>(), FileState::Same);
}

} // namespace
} // namespace kriva::ui
