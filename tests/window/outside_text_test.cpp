#include "core/document/conversion.h"
#include "core/io/json/document_json.h"
#include "tests/support/picture_trap.h"
#include "tests/support/sheet_curves.h"
#include "tests/support/test_window.h"
#include "ui/base/language/plain_text.h"
#include "ui/document/safe_write.h"
#include "ui/panels/tables/table_model.h"
#include "ui/window/dialogs/import_dialog.h"

#include <gtest/gtest.h>
#include <QClipboard>
#include <QCompleter>
#include <QFileDialog>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QToolTip>

namespace kriva::ui {
namespace {

/// Everything that shows text of a file, the name of a file or the clipboard, with a text that opens a FIFO where it
/// is read as HTML.
class OutsideText : public testing::Test {
  protected:
    OutsideText() { EXPECT_TRUE(folder_.isValid()); }

    [[nodiscard]] QString inFolder(const QString& name) const { return folder_.filePath(name); }
    /// A file whose name is HTML.
    [[nodiscard]] QString hostileFile() const {
        return inFolder(trap_.htmlWithoutSlashes() + QStringLiteral(".kriva"));
    }
    void write(const QString& path, const QString& text) const { ASSERT_FALSE(safeWrite(path, text.toUtf8())); }

    /// One curve in each sheet, and its name and the title are HTML.
    [[nodiscard]] Document hostileDocument() const {
        Document document = startDocument();
        document.title = trap_.html().toStdString();
        for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
            document.sheets[sheet].curves = {
                renamed(withPointsAdded(emptyCurve(sheet), Points{{0, 0}, {1, 2}, {3, 1}, {5, 4}}), document.title)};
        return document;
    }

    /// Paints every window, and every tool tip and menu of them.
    void lookAtEverything() {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (widget->isVisible())
                widget->grab();
            for (const QWidget* child : widget->findChildren<QWidget*>())
                showToolTip(child->toolTip());
            for (const QAction* action : widget->findChildren<QAction*>())
                showToolTip(action->toolTip());
            for (auto* menu : widget->findChildren<QMenu*>())
                menu->grab();
            for (const auto* view : widget->findChildren<QAbstractItemView*>())
                lookAt(view);
        }
        EXPECT_FALSE(trap_.wasOpened());
    }
    void lookAt(const QAbstractItemView* view) {
        const QAbstractItemModel* model = view->model();
        for (int row = 0; model && row < std::min(model->rowCount(), 50); ++row)
            for (int column = 0; column < model->columnCount(); ++column)
                showToolTip(model->index(row, column).data(Qt::ToolTipRole).toString());
    }
    void showToolTip(const QString& text) {
        if (shownTips_.contains(text))
            return;
        shownTips_.insert(text);
        QToolTip::showText(QPoint(10, 10), text);
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (widget->inherits("QTipLabel"))
                widget->grab();
        QToolTip::hideText();
    }

    /// Looks at the next box and closes it; how many there were is counted.
    void lookAtNextBox(QMessageBox::StandardButton button = QMessageBox::Ok) {
        QTimer::singleShot(0, [this, button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(box, nullptr);
            ++boxes_;
            lookAtEverything();
            boxText_ = box->text();
            box->button(button) ? box->button(button)->click() : box->reject();
        });
    }

    test::PictureTrap trap_;
    QTemporaryDir folder_;
    QSet<QString> shownTips_;
    QString boxText_;
    int boxes_ = 0;
};

TEST_F(OutsideText, ofADocumentIsShownLetterByLetterInEveryTabAndPanel) {
    write(hostileFile(), QString::fromStdString(writeDocument(hostileDocument())));
    test::TestWindow window;
    ASSERT_TRUE(window.window.session().openFile(hostileFile()));
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        ui::SheetTab& tab = window.shown(sheet);
        test::seeAllPanels(tab);
        tab.editor().selectAll();
        QApplication::processEvents();
        const auto* curves = tab.findChild<QListView*>(QStringLiteral("curves"));
        ASSERT_NE(curves, nullptr);
        EXPECT_EQ(curves->model()->index(0, 0).data().toString(), trap_.html());
        lookAtEverything();
    }
    EXPECT_TRUE(window.window.windowTitle().contains(trap_.htmlWithoutSlashes()));
    window.window.document().setActiveSheet(test::kElevation);
    window.window.tab(test::kElevation).editor().addPoint({7, 7});
    lookAtNextBox(QMessageBox::Cancel);
    EXPECT_FALSE(window.window.session().mayClose());
    EXPECT_TRUE(boxText_.contains(trap_.htmlWithoutSlashes())) << boxText_.toStdString();
    EXPECT_EQ(boxes_, 1);
}

TEST_F(OutsideText, noLabelReadsItsTextForHtml) {
    test::TestWindow window;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        test::seeAllPanels(window.shown(sheet));
    const auto labels = window.window.findChildren<QLabel*>();
    EXPECT_GT(labels.size(), 10);
    for (const QLabel* label : labels)
        EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->text().toStdString();
}

TEST_F(OutsideText, ofRecentFilesHasNoMnemonicsAndNoHtml) {
    const QString name = QStringLiteral("a & <b>b<") + QChar(u'\u202e') + QStringLiteral(".kriva");
    write(inFolder(name), QString::fromStdString(writeDocument({})));
    test::TestWindow window;
    ASSERT_TRUE(window.window.session().openFile(inFolder(name)));
    const auto actions = window.window.findChildren<QAction*>();
    const auto recent = std::ranges::find_if(
        actions, [](const QAction* action) { return action->text().startsWith(QStringLiteral("a && <b>")); });
    ASSERT_NE(recent, actions.end());
    EXPECT_EQ((*recent)->text(), QStringLiteral("a && <b>b<\\u202e.kriva"));
    EXPECT_EQ((*recent)->toolTip(), toolTipOf(inFolder(name)));
}

TEST_F(OutsideText, ofALongNameWidensNeitherTheMenuOfRecentFilesNorTheWindow) {
    const QString name = QString(100, u'w') + QStringLiteral(".a & b.") + QString(135, u'm') + QStringLiteral(".kriva");
    ASSERT_LE(name.size(), 255);
    write(inFolder(name), QString::fromStdString(writeDocument({})));
    test::TestWindow window;
    const int narrowest = window.window.minimumSizeHint().width();
    ui::FileWatch& watch = window.window.session().fileWatch();
    watch.setPause(std::chrono::milliseconds(1));
    ASSERT_TRUE(window.window.session().openFile(inFolder(name)));
    const auto actions = window.window.findChildren<QAction*>();
    const auto recent = std::ranges::find_if(
        actions, [](const QAction* action) { return action->text().startsWith(QStringLiteral("www")); });
    ASSERT_NE(recent, actions.end());
    EXPECT_TRUE((*recent)->text().contains(u'…'));
    EXPECT_TRUE((*recent)->text().endsWith(QStringLiteral("m.kriva")));
    EXPECT_EQ((*recent)->toolTip(), toolTipOf(inFolder(name)));
    const auto* menu = qobject_cast<QMenu*>((*recent)->associatedObjects().constFirst());
    ASSERT_NE(menu, nullptr);
    EXPECT_LT(menu->sizeHint().width(), 600);

    QSignalSpy changed(&watch, &ui::FileWatch::changed);
    ASSERT_TRUE(QFile::remove(inFolder(name)));
    ASSERT_TRUE(changed.wait(60'000));
    ASSERT_TRUE(window.window.findChild<QWidget*>(QStringLiteral("notice"))->isVisible());
    QApplication::processEvents();
    EXPECT_LE(window.window.minimumSizeHint().width(), std::max(narrowest, 900));
}

TEST_F(OutsideText, ofAFileWhoseNameHasTheSignOfAModifiedDocumentStaysInTheTitle) {
    const QString path = inFolder(QStringLiteral("a[*].kriva"));
    write(path, QString::fromStdString(writeDocument({})));
    test::TestWindow window;
    ASSERT_TRUE(window.window.session().openFile(path));
    EXPECT_EQ(window.window.windowTitle(), QStringLiteral("a[*][*].kriva[*] – Kriva"));
}

TEST_F(OutsideText, ofARefusedFileStandsInTheMessage) {
    const QString html = trap_.htmlWithoutQuotes();
    write(hostileFile(), QStringLiteral(R"({"format":"kriva","version":1,"%1":1})").arg(html));
    test::TestWindow window;
    lookAtNextBox();
    EXPECT_FALSE(window.window.session().openFile(hostileFile()));
    EXPECT_EQ(boxes_, 1);
    EXPECT_EQ(boxText_, QStringLiteral("%1: %2: unknown key").arg(hostileFile(), html));
}

TEST_F(OutsideText, ofAFileThatCannotBeSavedStandsInTheMessage) {
    test::TestWindow window;
    lookAtNextBox();
    EXPECT_FALSE(window.window.session().saveTo(inFolder(trap_.html() + QStringLiteral("/a.kriva"))));
    EXPECT_EQ(boxes_, 1);
    EXPECT_TRUE(boxText_.contains(trap_.html())) << boxText_.toStdString();
}

TEST_F(OutsideText, pastedStandsInTheStatusRow) {
    test::TestWindow window;
    ui::SheetTab& tab = window.shown(test::kElevation);
    const auto told = [&] { return window.window.findChild<QLabel*>(QStringLiteral("hint"))->text(); };
    QGuiApplication::clipboard()->setText(QStringLiteral("1,2\n3,") + trap_.htmlWithoutQuotes());
    QTest::keyClick(&tab.canvas(), Qt::Key_V, Qt::ControlModifier);
    EXPECT_TRUE(told().contains(trap_.htmlWithoutQuotes().first(15))) << told().toStdString();
    lookAtEverything();
    QGuiApplication::clipboard()->setText(QStringLiteral("<svg><path %1='1'").arg(QChar(u'\u202e')));
    QTest::keyClick(&tab.canvas(), Qt::Key_V, Qt::ControlModifier);
    EXPECT_TRUE(told().startsWith(QStringLiteral("The clipboard: "))) << told().toStdString();
    lookAtEverything();
}

TEST_F(OutsideText, pastedIsRefusedWithThePlaceInItAndNoPathIntoADocument) {
    test::TestWindow window;
    ui::SheetTab& tab = window.shown(test::kSpline);
    const auto pasted = [&](const QString& text) {
        QGuiApplication::clipboard()->setText(text);
        QTest::keyClick(&tab.canvas(), Qt::Key_V, Qt::ControlModifier);
        return window.window.findChild<QLabel*>(QStringLiteral("hint"))->text();
    };
    EXPECT_EQ(pasted(QStringLiteral("M0 0L1 1X")),
              QStringLiteral("The clipboard: line 1, column 10: this is no path data"));
    EXPECT_EQ(pasted(QStringLiteral("<svg>\n<path d='M0 0L1e10 1'/></svg>")),
              QStringLiteral("The clipboard: line 2, column 2: the attribute “d” leads beyond the coordinates from "
                             "-1000000000 to 1000000000"));
    QString many = QStringLiteral("M0 0");
    for (int i = 0; i < 1001; ++i)
        many += QStringLiteral("M%1 0v1").arg(i);
    EXPECT_EQ(pasted(many), QStringLiteral("The clipboard: a sheet takes at most 1000 curves, and these are 1001"));
    auto* clip = new QMimeData;
    clip->setData(
        QStringLiteral("application/x-kriva-fragment+json"),
        R"({"format":"kriva-fragment","version":1,"content":"curve","sheet":"spline","curve":{"knots":[7]}})");
    QGuiApplication::clipboard()->setMimeData(clip);
    QTest::keyClick(&tab.canvas(), Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(window.window.findChild<QLabel*>(QStringLiteral("hint"))->text(),
              QStringLiteral("The clipboard: its curve cannot be read: expected an object"));
}

TEST_F(OutsideText, ofImportedPathsIsShownLetterByLetter) {
    const LanguageSwitch language(Language::English); // "2 points"
    const QString html = trap_.htmlWithoutQuotes().toHtmlEscaped();
    const QString svg = QStringLiteral("<svg xmlns:inkscape='i'><g inkscape:label='%1' id='%1'><path d='M0 0h1'/>"
                                       "<path inkscape:label='%1&#x202e;' id='%1' d='M0 0h1'/></g></svg>")
                            .arg(html);
    auto read = readSvgPaths(svg.toStdString());
    ASSERT_TRUE(std::holds_alternative<std::vector<ImportedPath>>(read));
    auto paths = std::get<std::vector<ImportedPath>>(std::move(read));
    paths[1].path.points.resize(300);
    paths[1].path.degrees.clear();
    ImportDialog dialog(paths, 0);
    dialog.show();
    const auto* list = dialog.findChild<QListWidget*>();
    EXPECT_EQ(list->item(0)->text(), trap_.htmlWithoutQuotes() + QStringLiteral(": 2 points"));
    EXPECT_TRUE(list->item(1)->text().contains(QStringLiteral("\\u202e")));
    for (const QLabel* label : dialog.findChildren<QLabel*>())
        EXPECT_EQ(label->textFormat(), Qt::PlainText);
    const auto labels = dialog.findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(
        labels, [&](const QLabel* label) { return label->text().contains(trap_.htmlWithoutQuotes()); }));
    lookAtEverything();
}

TEST_F(OutsideText, ofAFileThatWouldBeOverwrittenStandsInTheQuestionOfTheFileDialog) {
    write(hostileFile(), QString());
    test::TestWindow window;
    QFileDialog dialog(&window.window);
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDirectory(folder_.path());
    dialog.selectFile(hostileFile());
    lookAtNextBox(QMessageBox::No);
    static_cast<QDialog&>(dialog).accept();
    EXPECT_EQ(boxes_, 1);
    EXPECT_TRUE(boxText_.contains(trap_.htmlWithoutSlashes())) << boxText_.toStdString();
}

TEST_F(OutsideText, ofANameOfAFileIsNotTurnedAroundInTheListsOfTheFileDialog) {
    const QString name = QStringLiteral("a\u202Eg\npj.svg");
    write(inFolder(name), QStringLiteral("1 2\n"));
    TestWindow window;
    QFileDialog dialog(&window.window, QString(), inFolder(QString()));
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.show();
    int lists = 0;
    for (const auto* view : dialog.findChildren<QAbstractItemView*>()) {
        if (const auto* names = qobject_cast<const QStyledItemDelegate*>(view->itemDelegate());
            names &&
            (view->objectName() == QLatin1String("listView") || view->objectName() == QLatin1String("treeView"))) {
            EXPECT_EQ(names->displayText(name, QLocale()), QStringLiteral("a\\u202eg\\u000apj.svg"));
            ++lists;
        }
    }
    EXPECT_EQ(lists, 2);
    const auto* field = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    const auto* completions = qobject_cast<const QStyledItemDelegate*>(field->completer()->popup()->itemDelegate());
    ASSERT_NE(completions, nullptr);
    EXPECT_EQ(completions->displayText(name, QLocale()), QStringLiteral("a\\u202eg\\u000apj.svg"));
}

TEST_F(OutsideText, whatAnEditIsRefusedForIsSaidWithoutAPathIntoADocument) {
    test::TestWindow window;
    ui::SheetTab& tab = window.shown(test::kCombined);
    CombinedCurve curve;
    for (int i = 0; i < 300; ++i)
        curve.points.push_back({static_cast<double>(i), static_cast<double>(i % 3)});
    Document document;
    document.active = test::kCombined;
    document.sheets[test::kCombined].curves = test::curves({curve});
    window.window.session().show(document);
    curve.method = CombinedCurve::Method::interpolation;
    const Serial serial = tab.editor().activeSerial();
    EXPECT_FALSE(window.window.document().change(3, serial, Curve(curve), {"Set the method"}));
    EXPECT_EQ(window.window.findChild<QLabel*>(QStringLiteral("hint"))->text(),
              QStringLiteral("interpolation takes at most 201 points in a monotone run, and one has 300"));
}

} // namespace
} // namespace kriva::ui
