#include "core/io/json/document_json.h"
#include "tests/support/program.h"
#include "tests/support/sheet_curves.h"

namespace kriva {
namespace {

using app::ExitCode;
using test::expectOneLine;

class ImportCommand : public test::Program {
  protected:
    [[nodiscard]] Document document(const char* file) const {
        const auto read = readDocument(this->read(file).toStdString());
        EXPECT_TRUE(std::holds_alternative<Document>(read));
        return std::get<Document>(read);
    }
};

TEST_F(ImportCommand, makesADocumentOfAllPaths) {
    write("a.svg", "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0C1 -2 3 -2 4 0'/>"
                   "<circle cx='1' cy='1' r='1'/></svg>");
    write("b.txt", "M 0 0 L 5 -5");
    write("c.csv", "x;y\n0,5;1\n2;3\n");
    EXPECT_EQ(run("import a.svg b.txt c.csv -o out.kriva --sheet spline").code, 0);
    const Document made = document("out.kriva");
    EXPECT_EQ(made.active, test::kSpline);
    const std::vector<const SplineCurve*> curves = curvesOf<SplineCurve>(made.sheets[test::kSpline]);
    ASSERT_EQ(curves.size(), 4U);
    EXPECT_EQ(segmentsOf(*curves[0]).front(), (Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}}));
    EXPECT_TRUE(curves[1]->closed);
    EXPECT_EQ(curves[2]->knots[1].at, (Point{5, 5}));
    EXPECT_EQ(curves[3]->knots[0].at, (Point{0.5, 1}));
    EXPECT_EQ(run("report out.kriva").code, 0);
}

TEST_F(ImportCommand, bringsBackThePointsThatItExported) {
    EXPECT_EQ(run("export arch.kriva -o arch.csv").code, 0);
    EXPECT_EQ(run("import arch.csv -o back.kriva --sheet elevation").code, 0);
    EXPECT_EQ(std::get<ElevationCurve>(document("back.kriva").sheets[test::kElevation].curves[0]).points,
              (Points{{0, 0}, {1, 2}, {3, 2}, {4, 0.5}}));
}

TEST_F(ImportCommand, scalesAndMoves) {
    write("a.csv", "1 2\n3 4\n");
    EXPECT_EQ(run("import a.csv -o out.kriva --sheet combined --scale 2 --offset 10,-1").code, 0);
    EXPECT_EQ(std::get<CombinedCurve>(document("out.kriva").sheets[test::kCombined].curves[0]).points,
              (Points{{12, 3}, {16, 7}}));
}

TEST_F(ImportCommand, namesTheFileAndTheLimitWhereItHasTooManyPaths) {
    write("a.svg", "<svg><path d='" + QByteArray("M0 0v1").repeated(1001) + "'/></svg>");
    expectOneLine(run("import a.svg -o out.kriva --sheet spline"), ExitCode::refused,
                  "kriva: a.svg: a sheet takes at most 1000 curves, and these are 1001");
}

TEST_F(ImportCommand, readsAndWritesTheStandardStreams) {
    write("a.csv", "1 2\n3 4\n");
    const QStringList line = QStringLiteral("import - -o - --sheet elevation").split(QLatin1Char(' '));
    const test::Outcome outcome = run(line, {}, path(QStringLiteral("a.csv")));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(std::holds_alternative<Document>(readDocument(outcome.out.toStdString())));
}

TEST_F(ImportCommand, refusesInOneLineThatNamesThePlace) {
    write("a.svg", "<svg>\n<path d='M0 0X'/></svg>");
    expectOneLine(run("import a.svg -o out.kriva --sheet spline"), ExitCode::refused,
                  "kriva: a.svg: line 2, column 2: the attribute \u201cd\u201d cannot be read");
    write("b.svg", "<svg><text>M0 0L1 1</text></svg>");
    expectOneLine(run("import b.svg -o out.kriva --sheet spline"), ExitCode::refused,
                  "kriva: b.svg: there is no path to import");
    write("c.csv", "1 2\n3 four\n");
    expectOneLine(run("import c.csv -o out.kriva --sheet spline"), ExitCode::refused,
                  "kriva: c.csv: line 2, column 3: \u201cfour\u201d is no number");
    expectOneLine(run("import missing.csv -o out.kriva --sheet spline"), ExitCode::refused,
                  "kriva: missing.csv: there is no such file");
    write("d.csv", QByteArray("1 2\n3 4\n").repeated(101));
    expectOneLine(run("import d.csv -o out.kriva --sheet elevation"), ExitCode::refused,
                  "kriva: d.csv: curve 1: this curve takes at most 201 points, and would have 202");
    EXPECT_EQ(read("out.kriva"), QByteArray());
}

} // namespace
} // namespace kriva
