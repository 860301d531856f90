#include "core/curve/text/utf8.h"
#include "core/io/json/document_json.h"
#include "tests/support/document_files.h"
#include "tests/support/test_window.h"
#include "ui/document/document_file.h"

#include <gtest/gtest.h>
#include <QClipboard>
#include <QLineEdit>
#include <QListView>
#include <QMimeData>
#include <QTemporaryDir>

namespace kriva::ui {
namespace {

/// Texts of every kind: whole characters, halves of them in both orders, what is none, controls, the end of a C string.
QStringList kindsOfText() {
    QStringList texts{QStringLiteral("крива č 🙂"), QStringLiteral("\u202e\u0085\u009b\u2028\ufeff"),
                      QStringLiteral("\"\\/")};
    texts << QString(QChar(0xd83d)) << QString(QChar(0xde42)) << QString(QChar(0xde42)) + QChar(0xd83d);
    texts << QStringLiteral("a") + QChar(0xd800) + QStringLiteral("b");
    texts << QString(QChar(0xffff)) << QStringLiteral("a") + QChar(0) + QStringLiteral("b") << QString(QChar(1));
    return texts;
}

QByteArray quoted(const QByteArray& label) {
    return "<svg xmlns:inkscape='i'><path inkscape:label='" + label + "' d='M0 0L1 1'/></svg>";
}

/// The same as labels of an SVG file, and bytes of other encodings.
QList<QByteArray> kindsOfLabel() {
    QList<QByteArray> labels{"\xCA\xF0\xE8\xE2\xE0", "\xE4",      "\xED\xA0\x80", "\xC0\xAF",
                             "\xF5\x80\x80\x80",     "a\xF0\x9F", "&#xD800;",     "&#0;",
                             "&#x110000;",           "&#xFFFF;",  "&#x202e;",     "&#1;"};
    for (const QString& text : kindsOfText())
        if (!text.contains(QChar(0)) && !text.contains(QChar(1)) && !text.contains(QChar(0xffff)))
            labels.append(text.toHtmlEscaped().toUtf8());
    return labels;
}

/// Those of a file that is no XML.
QList<QByteArray> kindsOfRefusedLabel() {
    return {"\x01", "\xEF\xBF\xBF"};
}

class AnyText : public testing::Test {
  protected:
    /// Saves, opens again, and saves what was opened: the bytes are the same.
    void expectToOpenAgain() {
        const QString path = folder_.filePath(QStringLiteral("a.kriva"));
        const std::string bytes = writeDocument(window_.window.document().value());
        EXPECT_TRUE(isUtf8(bytes));
        ASSERT_FALSE(test::saveDocument(path, window_.window.document().value()));
        const auto opened = test::loadDocument(path);
        ASSERT_TRUE(std::holds_alternative<LoadedFile>(opened)) << bytes;
        const Document& document = std::get<LoadedFile>(opened).document;
        EXPECT_EQ(document, window_.window.document().value());
        EXPECT_EQ(writeDocument(document), bytes);
    }
    [[nodiscard]] ui::SheetTab& tab() { return window_.window.tab(test::kSpline); }
    [[nodiscard]] std::string lastName() { return nameOf(tab().editor().sheet().curves.back()); }

    test::TestWindow window_;
    QTemporaryDir folder_;
};

TEST_F(AnyText, typedOrPastedAsTheNameOfACurveIsReadAgain) {
    test::seeAllPanels(window_.shown(test::kSpline));
    auto* list = tab().findChild<QListView*>(QStringLiteral("curves"));
    ASSERT_NE(list, nullptr);
    for (const QString& text : kindsOfText()) {
        tab().editor().renameCurve(tab().editor().activeSerial(), QStringLiteral("before"));
        list->setCurrentIndex(list->model()->index(0, 0));
        list->edit(list->currentIndex());
        auto* field = list->findChild<QLineEdit*>();
        ASSERT_NE(field, nullptr);
        QGuiApplication::clipboard()->setText(text);
        field->selectAll();
        field->paste();
        QTest::keyClick(field, Qt::Key_Return);
        QApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        ASSERT_EQ(list->findChild<QLineEdit*>(), nullptr) << "the name is still being edited";
        const std::string& name = nameOf(tab().editor().sheet().curves[0]);
        EXPECT_NE(name, "before");
        EXPECT_TRUE(isUtf8(name));
        expectToOpenAgain();
    }
}

TEST_F(AnyText, setAsTheNameOfACurveIsReadAgain) {
    window_.shown(test::kSpline);
    for (const QString& text : kindsOfText()) {
        tab().editor().renameCurve(tab().editor().activeSerial(), text);
        EXPECT_EQ(nameOf(*tab().editor().activeCurve()).find('\0'), std::string::npos);
        expectToOpenAgain();
    }
    tab().editor().renameCurve(tab().editor().activeSerial(),
                               QStringLiteral("a") + QChar(0xd800) + QStringLiteral("b"));
    EXPECT_EQ(nameOf(*tab().editor().activeCurve()), "a\uFFFDb");
}

TEST_F(AnyText, pastedAsTheLabelOfAPathIsReadAgain) {
    window_.shown(test::kSpline);
    for (const QByteArray& label : kindsOfLabel()) {
        auto* clip = new QMimeData;
        clip->setData(QStringLiteral("image/svg+xml"), quoted(label));
        QGuiApplication::clipboard()->setMimeData(clip);
        const std::size_t before = tab().editor().sheet().curves.size();
        QTest::keyClick(&tab().canvas(), Qt::Key_V, Qt::ControlModifier);
        EXPECT_EQ(tab().editor().sheet().curves.size(), before + 1) << label.toStdString();
        EXPECT_TRUE(isUtf8(lastName())) << label.toStdString();
        expectToOpenAgain();
    }
    for (const QByteArray& label : kindsOfRefusedLabel()) {
        auto* clip = new QMimeData;
        clip->setData(QStringLiteral("image/svg+xml"), quoted(label));
        QGuiApplication::clipboard()->setMimeData(clip);
        const std::size_t before = tab().editor().sheet().curves.size();
        QTest::keyClick(&tab().canvas(), Qt::Key_V, Qt::ControlModifier);
        EXPECT_EQ(tab().editor().sheet().curves.size(), before) << label.toStdString();
    }
    for (const QString& text : kindsOfText()) {
        QGuiApplication::clipboard()->setText(QString::fromUtf8(quoted("X")).replace(u'X', text.toHtmlEscaped()));
        QTest::keyClick(&tab().canvas(), Qt::Key_V, Qt::ControlModifier);
        expectToOpenAgain();
    }
}

TEST_F(AnyText, inAFragmentIsRefusedOrReadAgain) {
    window_.shown(test::kSpline);
    for (const QByteArray& name : {QByteArray("\xE4"), QByteArray("\\ud800"), QByteArray("\\udc00a"),
                                   QByteArray("\\u0000"), QByteArray("\\ud83d\\ude42"), QByteArray("\\u009b")}) {
        auto* clip = new QMimeData;
        clip->setData(QStringLiteral("application/x-kriva-fragment+json"),
                      R"({"format":"kriva-fragment","version":1,"content":"curve","sheet":"spline","curve":{"name":")" +
                          name + R"(","knots":[{"at":[0,0]},{"at":[1,1]}]}})");
        QGuiApplication::clipboard()->setMimeData(clip);
        QTest::keyClick(&tab().canvas(), Qt::Key_V, Qt::ControlModifier);
        EXPECT_TRUE(isUtf8(lastName()));
        expectToOpenAgain();
    }
}

} // namespace
} // namespace kriva::ui
