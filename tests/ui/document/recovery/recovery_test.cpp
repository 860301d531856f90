#include "core/io/json/document_json.h"
#include "tests/support/sheet_curves.h"
#include "ui/document/recovery/recovery.h"
#include "ui/document/state_folder.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QLockFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <optional>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

using namespace std::chrono_literals;

constexpr SheetIndex kSheet = kSheetOf<ElevationCurve>;
const StepLabel kEdit{"Move point %1", 3};
constexpr int kPatience = 60'000; // ms until a signal that does not come is a failure

Curve archAt(double x) {
    return withPointsAdded(emptyCurve(kSheet), Points{{x, 0}, {x, 1}, {2, 2}});
}

/// A document whose unsaved work is kept in a folder of the test's own.
class RecoveryTest : public testing::Test {
  protected:
    RecoveryTest() {
        qputenv("XDG_STATE_HOME", folder.path().toUtf8());
        Document start;
        start.sheets[kSheet].curves = {archAt(0)};
        document.replace(start);
        begin({1ms, 5ms});
    }
    ~RecoveryTest() override {
        recovery.reset();
        writer.reset();
        qputenv("XDG_STATE_HOME", homeBefore);
    }
    void begin(RecoveryTiming timing) {
        recovery.reset();
        writer.emplace(timing);
        recovery.emplace(document, *writer);
        written.emplace(&*writer, &RecoveryWriter::written);
    }
    void change(double x) { document.change(kSheet, document.serials(kSheet)[0], archAt(x), kEdit); }
    [[nodiscard]] bool waitForWriting() { return written->wait(kPatience); }
    [[nodiscard]] bool settle() { return writer->finishWithin(60s); }
    /// Turns of the event loop, in which its clocks go.
    void waitUntilGone() {
        do
            QCoreApplication::processEvents();
        while (settle() && !names().isEmpty());
    }
    [[nodiscard]] QString files() const { return folder.filePath(u"kriva/recovery"_s); }
    [[nodiscard]] QStringList names() const { return QDir(files()).entryList(QDir::Files); }
    /// What is on the disk, whoever holds it.
    [[nodiscard]] Document onDisk() const {
        for (const QString& name : names())
            if (name.endsWith(u".kriva"))
                return std::get<LoadedFile>(loadDocument(files() + u'/' + name)).document;
        ADD_FAILURE() << "nothing is there";
        return {};
    }

    const QByteArray homeBefore = qgetenv("XDG_STATE_HOME");
    QTemporaryDir folder;
    OpenDocument document;
    std::optional<RecoveryWriter> writer;
    std::optional<Recovery> recovery;
    std::optional<QSignalSpy> written;
};

TEST_F(RecoveryTest, keepsWhatIsUnsavedUntilItIsSaved) {
    change(5);
    ASSERT_TRUE(waitForWriting());
    EXPECT_EQ(onDisk(), document.value());
    EXPECT_EQ(names().size(), 3) << "work, note, lock";
    document.markSaved();
    ASSERT_TRUE(settle());
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveryTest, keepsNothingOfADocumentThatIsSaved) {
    document.setActiveSheet(test::kSubdivision);
    document.setViewNumbers(test::kSpline, kCombScale, {3});
    QCoreApplication::processEvents();
    ASSERT_TRUE(settle());
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveryTest, whatIsUndoneIsNotKept) {
    change(5);
    ASSERT_TRUE(waitForWriting());
    document.undo();
    ASSERT_TRUE(settle());
    EXPECT_EQ(names(), QStringList());
    document.redo();
    ASSERT_TRUE(waitForWriting());
    EXPECT_EQ(onDisk(), document.value());
}

TEST_F(RecoveryTest, keepsThePreviewOfAGesture) {
    document.beginGesture(kSheet, document.serials(kSheet)[0], kEdit);
    document.preview(archAt(7));
    ASSERT_TRUE(waitForWriting());
    EXPECT_EQ(onDisk().sheets[kSheet].curves[0], archAt(7));
    EXPECT_TRUE(document.hasGesture());
    document.cancelGesture();
    waitUntilGone();
    EXPECT_EQ(document.history(kSheet).count(), 0);
}

TEST_F(RecoveryTest, aGestureThatEndsWhereItBeganIsNotKept) {
    document.beginGesture(kSheet, document.serials(kSheet)[0], kEdit);
    document.preview(archAt(7));
    ASSERT_TRUE(waitForWriting());
    document.preview(archAt(0));
    document.endGesture();
    waitUntilGone();
    EXPECT_FALSE(document.isModified());
}

TEST_F(RecoveryTest, changesWithoutAPauseAreWrittenAllTheSame) {
    begin({10min, 1ms}); // the pause never comes
    change(5);
    EXPECT_TRUE(waitForWriting());
    EXPECT_EQ(onDisk(), document.value());
}

TEST_F(RecoveryTest, aPauseIsEnough) {
    begin({1ms, 10min});
    change(5);
    EXPECT_TRUE(waitForWriting());
}

TEST_F(RecoveryTest, nothingIsWrittenBeforeAPause) {
    begin({10min, 10min});
    change(5);
    QCoreApplication::processEvents();
    ASSERT_TRUE(settle());
    EXPECT_EQ(names(), QStringList());
    recovery->keep();
    ASSERT_TRUE(settle());
    EXPECT_EQ(onDisk(), document.value());
}

TEST_F(RecoveryTest, whatIsKeptOutlivesTheWindowAndIsFoundWithItsFile) {
    begin({10min, 10min});
    recovery->setFile(u"/home/a/arch.kriva"_s, "hash of the file");
    change(5);
    recovery->keep();
    recovery.reset();
    ASSERT_TRUE(settle());
    EXPECT_TRUE(takeRecoveries(files()).empty()) << "this program still runs";
    writer.reset();
    const auto found = takeRecoveries(files());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].state, RecoveryState::Whole);
    EXPECT_EQ(found[0].note->path, u"/home/a/arch.kriva"_s);
    EXPECT_EQ(found[0].note->fileHash, "hash of the file");
    EXPECT_LE(std::abs(found[0].time.secsTo(QDateTime::currentDateTime())), 3600);
    EXPECT_EQ(std::get<LoadedFile>(documentFrom(readRecovery(found[0]))).document, document.value());
}

TEST_F(RecoveryTest, whoGoesOnAfterAllKeepsNoMoreThanIsUnsavedInTheEnd) {
    change(5);
    recovery->keep();
    EXPECT_TRUE(recovery->isKept());
    change(6);
    EXPECT_FALSE(recovery->isKept());
    recovery.reset(); // the window is closed, and asked before
    ASSERT_TRUE(settle());
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveryTest, goesOnWithWhatWasFoundUnderTheSameName) {
    change(5);
    recovery->keep();
    recovery.reset();
    writer.reset();
    auto found = takeRecoveries(files());
    ASSERT_EQ(found.size(), 1U);
    const QStringList before = names();
    begin({1ms, 5ms});
    document.replace(std::get<LoadedFile>(documentFrom(readRecovery(found[0]))).document);
    recovery->adopt(std::move(found[0]));
    document.markUnsaved();
    EXPECT_TRUE(document.isModified());
    ASSERT_TRUE(waitForWriting());
    change(6);
    ASSERT_TRUE(waitForWriting());
    EXPECT_EQ(names(), before);
    EXPECT_EQ(onDisk(), document.value());
    EXPECT_TRUE(takeRecoveries(files()).empty()) << "it is locked all the time";
    document.undo();
    EXPECT_TRUE(document.isModified()) << "no file has it";
    document.markSaved();
    ASSERT_TRUE(settle());
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveryTest, aReplacedDocumentIsNotKept) {
    change(5);
    ASSERT_TRUE(waitForWriting());
    document.replace({});
    ASSERT_TRUE(settle());
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveryTest, aDiskThatTakesNothingIsToldOnceAndTheWorkGoesOn) {
    ASSERT_EQ(safeWrite(folder.filePath(u"kriva"_s), "a file where the folder should be"), std::nullopt);
    QSignalSpy failed(&*recovery, &Recovery::failed);
    change(5);
    ASSERT_TRUE(failed.wait(kPatience));
    for (int i = 6; i < 9; ++i) {
        change(i);
        recovery->keep(); // hands over at once
        ASSERT_TRUE(settle());
        QCoreApplication::processEvents();
    }
    EXPECT_EQ(failed.count(), 1);
    EXPECT_FALSE(writer->isAllWritten());
    QFile::remove(folder.filePath(u"kriva"_s));
    change(10);
    ASSERT_TRUE(waitForWriting());
    EXPECT_TRUE(writer->isAllWritten());
    EXPECT_EQ(onDisk(), document.value());
}

TEST_F(RecoveryTest, ofSeveralDocumentsEachHasItsOwn) {
    OpenDocument second;
    Recovery ofSecond(second, *writer);
    change(5);
    second.add(kSheet, 0, archAt(9), kEdit);
    ofSecond.keep();
    recovery->keep();
    ASSERT_TRUE(settle());
    EXPECT_EQ(names().filter(u".kriva"_s).size(), 2);
}

} // namespace
} // namespace kriva::ui
