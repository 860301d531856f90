#include "core/io/json/document_json.h"
#include "tests/support/answers.h"
#include "tests/support/document_files.h"
#include "tests/support/test_window.h"
#include "ui/document/sharing/content_hash.h"
#include "ui/document/state_folder.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLockFile>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

using namespace std::chrono_literals;
using test::answerWith;
using test::chooseFile;
using test::TestWindow;

constexpr int kPatience = 60'000; // ms until a signal that does not come is a failure

/// A window on a document in a file.
class DocumentSessionTest : public testing::Test {
  protected:
    DocumentSessionTest() {
        qputenv("XDG_STATE_HOME", folder.filePath(u"state"_s).toUtf8());
        EXPECT_EQ(test::saveDocument(path, documentAt(1)), std::nullopt);
        session.fileWatch().setPause(1ms);
        EXPECT_TRUE(session.openFile(path));
    }
    ~DocumentSessionTest() override { qputenv("XDG_STATE_HOME", homeBefore); }

    static Document documentAt(double x) {
        Document document;
        document.sheets[test::kElevation].curves = {
            withPointsAdded(emptyCurve(test::kElevation), Points{{x, 0}, {1, 2}, {3, 0}})};
        return document;
    }
    void edit() { window.shown(test::kElevation).editor().addPoint({5, 5}); }
    [[nodiscard]] static QByteArray bytesOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] const Document& value() { return window.window.document().value(); }
    [[nodiscard]] Document onDisk() const { return std::get<LoadedFile>(test::loadDocument(path)).document; }
    [[nodiscard]] QString in(const QString& name) const { return folder.filePath(name); }

    /// Another program writes into the file, or removes it, and this one sees it.
    void changeElsewhere(double x) {
        QSignalSpy changed(&session.fileWatch(), &FileWatch::changed);
        EXPECT_EQ(test::saveDocument(path, documentAt(x)), std::nullopt);
        ASSERT_TRUE(changed.wait(kPatience));
    }
    void removeElsewhere() {
        QSignalSpy changed(&session.fileWatch(), &FileWatch::changed);
        ASSERT_TRUE(QFile::remove(path));
        ASSERT_TRUE(changed.wait(kPatience));
    }
    [[nodiscard]] QWidget& notice() { return *window.window.findChild<QWidget*>(u"notice"_s); }
    [[nodiscard]] QString noticed() { return notice().findChild<QLabel*>()->text(); }
    void press(const QString& name) { QTest::mouseClick(notice().findChild<QPushButton*>(name), Qt::LeftButton); }

    const QByteArray homeBefore = qgetenv("XDG_STATE_HOME");
    QTemporaryDir folder;
    const QString path = in(u"<img src=a>.kriva"_s);
    TestWindow window;
    DocumentSession& session = window.window.session();
};

TEST_F(DocumentSessionTest, aFileThatAWindowHasOpenIsShownThere) {
    MainWindow second{{window.preferences, window.language, window.theme, window.files, window.sheets}};
    second.session().show(startDocument());
    second.show();
    window.window.showMinimized();
    edit();
    second.session().openInstead(path);
    EXPECT_EQ(second.document().value(), startDocument());
    EXPECT_EQ(second.session().path(), QString());
    EXPECT_FALSE(window.window.isMinimized());
    EXPECT_TRUE(second.session().openFile(path)) << "it is open";
    EXPECT_TRUE(window.window.document().isModified()) << "and nothing became of what was changed";
}

TEST_F(DocumentSessionTest, aFileIsFreeOnceItsDocumentIsClosedOrSavedElsewhere) {
    OpenFiles other;
    EXPECT_TRUE(std::holds_alternative<OpenFiles::HeldElsewhere>(other.claim(path, &other)));
    EXPECT_TRUE(session.saveTo(in(u"b.kriva"_s)));
    EXPECT_FALSE(std::holds_alternative<OpenFiles::HeldElsewhere>(other.claim(path, &other)));
    EXPECT_TRUE(std::holds_alternative<OpenFiles::HeldElsewhere>(other.claim(in(u"b.kriva"_s), &other)));
    session.show({});
    EXPECT_FALSE(std::holds_alternative<OpenFiles::HeldElsewhere>(other.claim(in(u"b.kriva"_s), &other)));
}

TEST_F(DocumentSessionTest, asksBeforeItOpensWhatAnotherProgramHasOpen) {
    const QString theirs = in(u"theirs.kriva"_s);
    ASSERT_EQ(test::saveDocument(theirs, documentAt(7)), std::nullopt);
    OpenFiles other;
    auto claim = other.claim(theirs, &other);
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(session.openFile(theirs));
    EXPECT_EQ(value(), documentAt(1));
    answerWith(u"Open a copy"_s);
    EXPECT_TRUE(session.openFile(theirs));
    EXPECT_EQ(value(), documentAt(7));
    EXPECT_EQ(session.path(), QString());
    answerWith(u"Open anyway"_s);
    EXPECT_TRUE(session.openFile(theirs));
    EXPECT_EQ(session.path(), theirs);

    edit();
    const QByteArray before = bytesOf(theirs);
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(session.save());
    EXPECT_EQ(bytesOf(theirs), before);
    answerWith(u"Save as…"_s, [&] { chooseFile(in(u"mine.kriva"_s)); });
    EXPECT_TRUE(session.save());
    EXPECT_EQ(bytesOf(theirs), before);
    EXPECT_EQ(session.path(), in(u"mine.kriva"_s));
    answerWith(u"Overwrite"_s);
    EXPECT_TRUE(session.saveTo(theirs));
    EXPECT_NE(bytesOf(theirs), before);
    claim = OpenFiles::HeldElsewhere{}; // they close it
    EXPECT_TRUE(session.save()) << "nobody is asked";
}

TEST_F(DocumentSessionTest, whoOpenedAFileAnywayIsKnownToThoseWhoComeLater) {
    const QString theirs = in(u"theirs.kriva"_s);
    ASSERT_EQ(test::saveDocument(theirs, documentAt(7)), std::nullopt);
    OpenFiles other;
    OpenFiles third;
    auto claim = other.claim(theirs, &other);
    answerWith(u"Open anyway"_s);
    ASSERT_TRUE(session.openFile(theirs));
    claim = OpenFiles::HeldElsewhere{}; // they close it
    EXPECT_TRUE(std::holds_alternative<OpenFiles::HeldElsewhere>(third.claim(theirs, &third)));
    session.show({});
    EXPECT_FALSE(std::holds_alternative<OpenFiles::HeldElsewhere>(third.claim(theirs, &third)));
}

TEST_F(DocumentSessionTest, aFileThatTwoWindowsWriteIsOpenUntilBothAreClosed) {
    MainWindow second{{window.preferences, window.language, window.theme, window.files, window.sheets}};
    second.session().show(startDocument());
    answerWith(u"Overwrite"_s);
    EXPECT_TRUE(second.session().saveTo(path));
    session.show({});
    OpenFiles other;
    EXPECT_TRUE(std::holds_alternative<OpenFiles::HeldElsewhere>(other.claim(path, &other)));
    EXPECT_TRUE(second.session().save()) << "nobody is asked: no other window has it";
}

TEST_F(DocumentSessionTest, asksBeforeItSavesOverWhatAnotherWindowHasOpen) {
    MainWindow second{{window.preferences, window.language, window.theme, window.files, window.sheets}};
    second.session().show(startDocument());
    const QByteArray before = bytesOf(path);
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(second.session().saveTo(path));
    EXPECT_EQ(bytesOf(path), before);
    EXPECT_EQ(second.session().path(), QString());
}

TEST_F(DocumentSessionTest, whatChangedOnTheDiskIsToldAndReloadedWhenAsked) {
    EXPECT_FALSE(notice().isVisible());
    changeElsewhere(2);
    EXPECT_TRUE(notice().isVisible());
    EXPECT_EQ(noticed(), u"Another program changed the file “<img src=a>.kriva”."_s);
    EXPECT_EQ(value(), documentAt(1)) << "nothing is done unasked";
    press(u"act"_s);
    EXPECT_EQ(value(), documentAt(2));
    EXPECT_FALSE(notice().isVisible());
    EXPECT_FALSE(window.window.isWindowModified());
    changeElsewhere(3);
    press(u"leave"_s);
    EXPECT_FALSE(notice().isVisible());
    changeElsewhere(4);
    EXPECT_TRUE(notice().isVisible()) << "that is news again";
}

TEST_F(DocumentSessionTest, aReloadAsksBeforeChangesAreLost) {
    edit();
    changeElsewhere(2);
    const Document mine = value();
    answerWith(QMessageBox::Cancel);
    press(u"act"_s);
    EXPECT_EQ(value(), mine);
    answerWith(u"Reload"_s);
    press(u"act"_s);
    EXPECT_EQ(value(), documentAt(2));
}

TEST_F(DocumentSessionTest, asksBeforeItOverwritesWhatChangedOnTheDisk) {
    edit();
    const Document mine = value();
    EXPECT_EQ(test::saveDocument(path, documentAt(2)), std::nullopt); // and nobody told it yet
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(session.save());
    EXPECT_EQ(onDisk(), documentAt(2));
    EXPECT_TRUE(window.window.isWindowModified());
    answerWith(u"Save as…"_s, [&] { chooseFile(in(u"mine.kriva"_s)); });
    EXPECT_TRUE(session.save());
    EXPECT_EQ(onDisk(), documentAt(2));
    EXPECT_EQ(std::get<LoadedFile>(test::loadDocument(in(u"mine.kriva"_s))).document, mine);
}

TEST_F(DocumentSessionTest, overwritesOrReloadsWhatChangedOnTheDiskWhenTold) {
    edit();
    const Document mine = value();
    EXPECT_EQ(test::saveDocument(path, documentAt(2)), std::nullopt);
    answerWith(u"Overwrite"_s);
    EXPECT_TRUE(session.save());
    EXPECT_EQ(onDisk(), mine);
    EXPECT_FALSE(window.window.isWindowModified());
    EXPECT_TRUE(session.save()) << "nobody is asked: it is its own";
    edit();
    EXPECT_EQ(test::saveDocument(path, documentAt(3)), std::nullopt);
    answerWith(u"Reload"_s, [] { answerWith(u"Reload"_s); });
    EXPECT_FALSE(session.save());
    EXPECT_EQ(value(), documentAt(3));
    EXPECT_EQ(onDisk(), documentAt(3));
}

TEST_F(DocumentSessionTest, aFileThatIsGoneIsToldAndSavedAgain) {
    removeElsewhere();
    EXPECT_EQ(noticed(), u"The file “<img src=a>.kriva” was deleted or moved by another program."_s);
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(window.window.close()) << "the window has the last of it";
    press(u"act"_s);
    EXPECT_EQ(onDisk(), documentAt(1));
    EXPECT_FALSE(notice().isVisible());
    EXPECT_TRUE(window.window.close());
}

TEST_F(DocumentSessionTest, whatIsGoneFromTheDiskIsKeptForTheNextStart) {
    const auto kept = [&] { return QDir(in(u"state/kriva/recovery"_s)).entryList({u"*.kriva"_s}).size(); };
    session.keepForNextStart();
    EXPECT_TRUE(window.files.recovery.finishWithin(60s));
    EXPECT_EQ(kept(), 0) << "the file has it";
    removeElsewhere();
    session.keepForNextStart();
    EXPECT_TRUE(window.files.recovery.finishWithin(60s));
    EXPECT_EQ(kept(), 1);
    EXPECT_TRUE(session.save());
    EXPECT_TRUE(window.files.recovery.finishWithin(60s));
    EXPECT_EQ(kept(), 0);
}

/// Another program puts something else in the place of the document, and a person leaves it as it is.
class FileHoldsSomethingElse : public DocumentSessionTest {
  protected:
    FileHoldsSomethingElse() {
        QSignalSpy changed(&session.fileWatch(), &FileWatch::changed);
        EXPECT_EQ(safeWrite(path, "no document"), std::nullopt);
        EXPECT_TRUE(changed.wait(kPatience));
        press(u"leave"_s);
        EXPECT_FALSE(window.window.document().isModified());
    }
};

TEST_F(FileHoldsSomethingElse, theWindowHasTheLastOfItAndIsNotClosedUnasked) {
    EXPECT_TRUE(window.window.isWindowModified());
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(window.window.close());
    EXPECT_EQ(bytesOf(path), "no document");
    answerWith(QMessageBox::Discard);
    EXPECT_TRUE(window.window.close());
    EXPECT_EQ(bytesOf(path), "no document");
}

TEST_F(FileHoldsSomethingElse, overwritesItWhenTold) {
    answerWith(u"Overwrite"_s);
    EXPECT_TRUE(window.window.close());
    EXPECT_EQ(onDisk(), documentAt(1));
    EXPECT_FALSE(window.window.isWindowModified());
}

TEST_F(FileHoldsSomethingElse, savesUnderAnotherNameWhenTold) {
    answerWith(u"Save as…"_s, [&] { chooseFile(in(u"mine.kriva"_s)); });
    EXPECT_TRUE(window.window.close());
    EXPECT_EQ(bytesOf(path), "no document");
    EXPECT_EQ(std::get<LoadedFile>(test::loadDocument(in(u"mine.kriva"_s))).document, documentAt(1));
}

TEST_F(FileHoldsSomethingElse, keepsItForTheNextStart) {
    session.keepForNextStart();
    EXPECT_TRUE(window.files.recovery.finishWithin(60s));
    EXPECT_EQ(QDir(in(u"state/kriva/recovery"_s)).entryList({u"*.kriva"_s}).size(), 1);
}

TEST_F(FileHoldsSomethingElse, isNoMatterOnceItIsAsItWas) {
    QSignalSpy changed(&session.fileWatch(), &FileWatch::changed);
    EXPECT_EQ(test::saveDocument(path, documentAt(1)), std::nullopt);
    ASSERT_TRUE(changed.wait(kPatience));
    EXPECT_FALSE(window.window.isWindowModified());
    EXPECT_TRUE(window.window.close()) << "nobody is asked";
}

TEST_F(DocumentSessionTest, whatChangedOnTheDiskAMomentAgoIsAskedAboutToo) {
    EXPECT_EQ(test::saveDocument(path, documentAt(2)), std::nullopt); // and nobody told it yet
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(window.window.close());
}

TEST_F(DocumentSessionTest, aRefusedSaveOffersAnotherName) {
    edit();
    const Document mine = value();
    const QString refused = in(u"none/a.kriva"_s);
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(session.saveTo(refused));
    EXPECT_TRUE(window.window.document().isModified());
    EXPECT_EQ(session.path(), path);
    EXPECT_EQ(onDisk(), documentAt(1));
    answerWith(u"Save as…"_s, [&] { chooseFile(in(u"other.kriva"_s)); });
    EXPECT_TRUE(session.saveTo(refused));
    EXPECT_EQ(session.path(), in(u"other.kriva"_s));
    EXPECT_FALSE(window.window.document().isModified());
    EXPECT_EQ(std::get<LoadedFile>(test::loadDocument(in(u"other.kriva"_s))).document, mine);
    EXPECT_EQ(onDisk(), documentAt(1));
}

TEST_F(DocumentSessionTest, aNameAsLongAsNamesCanBeIsSavedAgainAndAgain) {
    const QString longest = in(QString(249, u'n') + u".kriva"_s);
    for (int i = 0; i < 3; ++i) {
        edit();
        EXPECT_TRUE(session.saveTo(longest));
        EXPECT_EQ(std::get<LoadedFile>(test::loadDocument(longest)).document, value());
    }
}

/// Unsaved work as a program leaves it that was killed.
class RecoveredSession : public DocumentSessionTest {
  protected:
    [[nodiscard]] QString left() const { return in(u"state/kriva/recovery"_s); }
    /// Of the document, changed, that belongs to a file.
    [[nodiscard]] FoundRecovery found(const QString& file) {
        const QString place = std::get<QString>(privateFolder(u"recovery"_s));
        const QByteArray work = QByteArray::fromStdString(writeDocument(documentAt(9), 0));
        const QByteArray hash = file.isEmpty() ? QByteArray() : contentHash(bytesOf(file));
        EXPECT_EQ(writeRecovery({place, u"6f1d8a3e-35a1-4e0c-9d55-0d6a3f1b2c47"_s},
                                {file, hash, contentHash(work), {}, QDateTime::currentDateTimeUtc()}, work),
                  std::nullopt);
        auto all = takeRecoveries(place);
        EXPECT_EQ(all.size(), 1U);
        return std::move(all.at(0));
    }
    [[nodiscard]] QStringList names() const { return QDir(left()).entryList(QDir::Files); }
};

TEST_F(RecoveredSession, isModifiedAndItsFileIsUntouchedUntilItIsSaved) {
    session.show({});
    const QByteArray before = bytesOf(path);
    ASSERT_TRUE(session.recover(found(path)));
    EXPECT_EQ(value(), documentAt(9));
    EXPECT_EQ(session.path(), path);
    EXPECT_TRUE(window.window.isWindowModified());
    EXPECT_EQ(bytesOf(path), before);
    EXPECT_FALSE(names().isEmpty()) << "it is still unsaved";
    ASSERT_TRUE(session.save()) << "nobody is asked: the file is as it was";
    EXPECT_EQ(onDisk(), documentAt(9));
    ASSERT_TRUE(window.files.recovery.finishWithin(60s));
    EXPECT_EQ(names(), QStringList());
}

TEST_F(RecoveredSession, asksWhereTheFileChangedSince) {
    FoundRecovery recovery = found(path);
    session.show({});
    EXPECT_EQ(test::saveDocument(path, documentAt(2)), std::nullopt);
    ASSERT_TRUE(session.recover(std::move(recovery)));
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(session.save());
    EXPECT_EQ(onDisk(), documentAt(2));
}

TEST_F(RecoveredSession, withoutAFileItHasNone) {
    ASSERT_TRUE(session.recover(found({})));
    EXPECT_EQ(session.path(), QString());
    EXPECT_TRUE(window.window.windowTitle().startsWith(u"Untitled[*]"_s));
    answerWith(QMessageBox::Discard);
    EXPECT_TRUE(window.window.close());
}

TEST_F(RecoveredSession, whatCannotBeReadIsToldAndStays) {
    FoundRecovery recovery = found(path);
    const Document before = value();
    const QString file = recovery.files.document();
    ASSERT_EQ(safeWrite(file, "{"), std::nullopt);
    answerWith(QMessageBox::Ok);
    EXPECT_FALSE(session.recover(std::move(recovery)));
    EXPECT_EQ(value(), before);
    EXPECT_TRUE(QFile::exists(file));
}

} // namespace
} // namespace kriva::ui
