#include "tests/support/program.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>

#include <sys/stat.h>

namespace kriva::app {
namespace {

using test::expectOneLine;
using test::Outcome;
using test::Program;

TEST_F(Program, tellsItsVersionAndItsUse) {
    EXPECT_EQ(run("--version").out.left(6), "kriva ");
    const Outcome help = run("--help");
    EXPECT_EQ(help.code, 0);
    EXPECT_TRUE(help.out.contains("kriva export FILE... -o OUT."));
    EXPECT_EQ(help.error, "");
}

TEST_F(Program, refusesWrongUsageWithOneLine) {
    expectOneLine(run("report arch.kriva --foo"), ExitCode::usage,
                  "kriva: unknown option --foo; kriva --help tells more");
}

TEST_F(Program, reportsAsJson) {
    const Outcome outcome = run("report arch.kriva --format json");
    EXPECT_EQ(outcome.code, 0);
    const QJsonObject report = QJsonDocument::fromJson(outcome.out).object();
    EXPECT_EQ(report[QLatin1String("document")].toString(), QStringLiteral("arch.kriva"));
    const QJsonObject sheets = report[QLatin1String("sheets")].toObject();
    EXPECT_TRUE(sheets.contains(QLatin1String("elevation")));
    const Outcome one = run("report arch.kriva --format json --sheet subdivision");
    EXPECT_FALSE(one.out.contains("elevation"));
}

TEST_F(Program, reportsAsATableInTheLanguageAskedFor) {
    const Outcome english = run("report arch.kriva");
    EXPECT_TRUE(english.out.contains("Curve 0: arch\n")) << english.out.constData();
    EXPECT_TRUE(english.out.contains("(0; 0) – (4; 1.")) << english.out.constData();
    const QStringList bulgarian{QStringLiteral("report"), QStringLiteral("arch.kriva"),
                                QStringLiteral("--language=bg")};
    EXPECT_TRUE(run(bulgarian).out.contains("(0; 0) – (4; 1,"));
}

TEST_F(Program, exportsTheFirstSheetThatHoldsACurve) {
    EXPECT_EQ(run("export arch.kriva -o a.svg").code, 0);
    EXPECT_TRUE(read("a.svg").contains("id=\"curve-0\""));
    EXPECT_EQ(run("export arch.kriva -o b.svg --sheet elevation").code, 0);
    EXPECT_EQ(read("a.svg"), read("b.svg"));
}

TEST_F(Program, opensItsOwnFigures) {
    EXPECT_EQ(run("export arch.kriva -o a.svg").code, 0);
    const QByteArray fromDocument = run("report arch.kriva").out;
    EXPECT_EQ(run("report a.svg").out, fromDocument);
    EXPECT_FALSE(fromDocument.isEmpty());
}

TEST_F(Program, saysWhenThereIsNothingToDraw) {
    expectOneLine(run("export arch.kriva -o a.svg --sheet subdivision"), ExitCode::failure,
                  "kriva: arch.kriva: there is no curve to draw");
    write("empty.kriva", R"({"format":"kriva","version":1})");
    EXPECT_EQ(run("export empty.kriva -o a.svg").code, 1);
    EXPECT_FALSE(QFile::exists(path(QStringLiteral("a.svg"))));
}

TEST_F(Program, namesThePlaceOfWhatItRefuses) {
    write("a.kriva", R"({"format":"kriva","version":1,"sheets":{"elevation":{"curves":[{"points":[[0,0],[1]]}]}}})");
    expectOneLine(run("report a.kriva --format json"), ExitCode::refused,
                  "kriva: a.kriva: sheets.elevation.curves[0].points[1]: expected two finite numbers");
    write("b.kriva", "{\n  nothing");
    expectOneLine(run("export b.kriva -o b.svg"), ExitCode::refused,
                  "kriva: b.kriva: line 2, column 4: this is no JSON");
    write("c.svg", "<svg/>");
    EXPECT_EQ(run("report c.svg").code, 3);
    expectOneLine(run("report none.kriva"), ExitCode::refused, "kriva: none.kriva: there is no such file");
}

TEST_F(Program, keepsItsLinesShortAndHarmless) {
    write("a.kriva", QByteArray(R"({"format":"kriva","version":1,")") + QByteArray(5000, 'k') + "\u202e\":1}");
    const QByteArray error = run("report a.kriva").error;
    EXPECT_EQ(QString::fromUtf8(error).size(), 1001);
    const Outcome outcome =
        run({QStringLiteral("report"), QStringLiteral("a\nb\u202e"), QStringLiteral("--language=en")});
    expectOneLine(outcome, ExitCode::refused, "kriva: a\\u000ab\\u202e: there is no such file");
}

TEST_F(Program, reportsNoCharacterThatMovesACursorOrTurnsALine) {
    write("a.kriva", R"({"format":"kriva","version":1,"sheets":{"spline":{"curves":[
        {"name":"\u001b[31m\u202eabc\u2066\u0085\u009b","knots":[{"at":[0,0]},{"at":[1,1]}]}]}}})");
    const QByteArray json = run("report a.kriva --format json").out;
    EXPECT_TRUE(json.contains(R"("name": "\u001b[31m\u202eabc\u2066\u0085\u009b")")) << json.toStdString();
    const QByteArray table = run("report a.kriva").out;
    EXPECT_TRUE(table.contains(R"(\u001b[31m\u202eabc\u2066\u0085\u009b)")) << table.toStdString();
}

TEST_F(Program, refusesPipesFoldersAndDevices) {
    ASSERT_EQ(mkfifo(QFile::encodeName(path(QStringLiteral("pipe"))).constData(), 0600), 0);
    expectOneLine(run("report pipe"), ExitCode::refused, "kriva: pipe: this is no regular file");
    expectOneLine(run("report ."), ExitCode::refused, "kriva: .: this is no regular file");
    EXPECT_EQ(run("report /dev/zero").code, 3);
    ASSERT_EQ(mkfifo(QFile::encodeName(path(QStringLiteral("pipe.svg"))).constData(), 0600), 0);
    EXPECT_EQ(run("export arch.kriva -o pipe.svg").code, 4);
    EXPECT_EQ(run("export arch.kriva -o none/a.svg").code, 4);
}

TEST_F(Program, noticesWhenStdoutIsFull) {
    const Outcome outcome = run("report arch.kriva", QStringLiteral("/dev/full"));
    EXPECT_EQ(outcome.code, 4);
    EXPECT_EQ(outcome.error, "kriva: the output could not be written\n");
    EXPECT_EQ(run("--version", QStringLiteral("/dev/full")).code, 4);
}

TEST_F(Program, saysThatTheEditorNeedsADisplay) {
    expectOneLine(run("arch.kriva"), ExitCode::failure,
                  "kriva: the editor needs a display; export and report do without one");
}

} // namespace
} // namespace kriva::app
