#include "core/io/open.h"
#include "tests/support/program.h"

#include <QDir>
#include <QImage>
#include <QRegularExpression>
#include <QStandardPaths>

namespace kriva {
namespace {

using app::ExitCode;
using test::expectOneLine;

class ExportCommand : public test::Program {
  protected:
    [[nodiscard]] QByteArray exported(const QString& options, const char* file) {
        const test::Outcome outcome =
            run((QStringLiteral("export arch.kriva -o %1 ").arg(QLatin1String(file)) + options)
                    .trimmed()
                    .toUtf8()
                    .constData());
        EXPECT_EQ(outcome.code, 0) << outcome.error.toStdString();
        return read(file);
    }
};

TEST_F(ExportCommand, writesEveryFormatTwiceTheSame) {
    qputenv("SOURCE_DATE_EPOCH", "1700000000");
    for (const char* suffix : {"svg", "pdf", "png", "tex", "csv"}) {
        const std::string first = std::string("first.") + suffix;
        const std::string second = std::string("second.") + suffix;
        const QByteArray bytes = exported({}, first.c_str());
        EXPECT_GT(bytes.size(), 20) << suffix;
        EXPECT_EQ(bytes, exported({}, second.c_str())) << suffix;
    }
    qunsetenv("SOURCE_DATE_EPOCH");
    EXPECT_TRUE(read("first.pdf").startsWith("%PDF-"));
    EXPECT_TRUE(read("first.pdf").contains("/CreationDate (D:20231114221320"));
    EXPECT_EQ(read("first.csv"), "curve,point,x,y\n0,0,0,0\n0,1,1,2\n0,2,3,2\n0,3,4,0.5\n");
    EXPECT_TRUE(read("first.tex").contains("\\documentclass"));
    EXPECT_FALSE(exported(QStringLiteral("--fragment"), "part.tex").contains("\\documentclass"));
}

TEST_F(ExportCommand, keepsTheSizeOfThePage) {
    EXPECT_TRUE(exported(QStringLiteral("--width 99.7mm"), "a.svg")
                    .contains("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"99.7mm\""));
    const QByteArray pdf = exported(QStringLiteral("--width 99.7mm"), "a.pdf");
    const QRegularExpressionMatch box =
        QRegularExpression(QStringLiteral("/MediaBox \\[0 0 ([0-9.]+) ([0-9.]+)\\]")).match(QString::fromLatin1(pdf));
    ASSERT_TRUE(box.hasMatch());
    EXPECT_NEAR(box.captured(1).toDouble() * 25.4 / 72, 99.7, 0.2);
    QImage picture = QImage::fromData(exported(QStringLiteral("--width 100mm --dpi 254"), "a.png"));
    EXPECT_EQ(picture.width(), 1000);
    EXPECT_EQ(picture.dotsPerMeterX(), 10'000);
    EXPECT_EQ(picture.pixelColor(0, 0), QColor(Qt::white));
    picture = QImage::fromData(exported(QStringLiteral("--width 100mm --transparent"), "b.png"));
    EXPECT_EQ(picture.pixelColor(0, 0).alpha(), 0);
}

TEST_F(ExportCommand, drawsTheLayersAndTheCurveAskedFor) {
    write("two.kriva", R"({"format":"kriva","version":1,"sheets":{"elevation":{"curves":[
        {"points":[[0,0],[1,2]]},{"points":[[5,5],[6,7],[8,8]]}]}}})");
    EXPECT_EQ(run("export two.kriva -o a.svg --curve 1 --layers curve,points --no-document").code, 0);
    const QByteArray svg = read("a.svg");
    EXPECT_TRUE(svg.contains("id=\"curve-1\""));
    EXPECT_FALSE(svg.contains("id=\"curve-0\""));
    EXPECT_TRUE(svg.contains("id=\"layer-points\""));
    EXPECT_FALSE(svg.contains("id=\"layer-control-polygon\""));
    EXPECT_EQ(run("export two.kriva -o a.csv --curve 1").code, 0);
    EXPECT_EQ(read("a.csv"), "curve,point,x,y\n1,0,5,5\n1,1,6,7\n1,2,8,8\n");
    EXPECT_FALSE(exported(QStringLiteral("--no-labels"), "b.svg").contains("<text"));
    EXPECT_TRUE(exported({}, "b.svg").contains("<text"));
    expectOneLine(run("export two.kriva -o a.svg --curve 2"), ExitCode::usage,
                  "kriva: two.kriva: there is no curve 2; the sheet has 2, counted from 0");
    expectOneLine(run("export two.kriva -o a.svg --layers curves"), ExitCode::usage,
                  "kriva: there is no layer curves; the sheet has convex-hull, all-polygons, control-polygon, "
                  "elevated-polygon, end-tangents, curve, points, labels");
}

TEST_F(ExportCommand, drawsLettersAsOutlinesOnDemand) {
    const QByteArray svg = exported(QStringLiteral("--outlines"), "outlines.svg");
    EXPECT_FALSE(svg.contains("<text"));
    EXPECT_EQ(svg.count("<path aria-label=\"b"), 4);
    // Both look the same.
    const auto drawn = [this](const char* file) {
        QProcess renderer;
        renderer.start(QStringLiteral("rsvg-convert"),
                       {QStringLiteral("-w"), QStringLiteral("600"), path(QLatin1String(file))});
        EXPECT_TRUE(renderer.waitForFinished());
        return QImage::fromData(renderer.readAllStandardOutput()).convertToFormat(QImage::Format_Grayscale8);
    };
    EXPECT_TRUE(exported({}, "letters.svg").contains("<text"));
    const QImage outlines = drawn("outlines.svg");
    const QImage letters = drawn("letters.svg");
    ASSERT_EQ(outlines.size(), letters.size());
    int different = 0;
    for (int y = 0; y < letters.height(); ++y)
        for (int x = 0; x < letters.width(); ++x)
            different += std::abs(qGray(outlines.pixel(x, y)) - qGray(letters.pixel(x, y))) > 128 ? 1 : 0;
    EXPECT_LT(different, 200) << "of some thousand pixels of letters";
}

TEST_F(ExportCommand, drawsFramesOfTheAnimation) {
    const QByteArray strip = exported(QStringLiteral("--frames 0,1,5 --width 150mm"), "strip.svg");
    EXPECT_TRUE(strip.contains("width=\"150mm\""));
    EXPECT_EQ(strip.count("id=\"curve-0\""), 1);
    const QByteArray animated = exported(QStringLiteral("--frames 0..4 --animate --seconds 0.25"), "anim.svg");
    EXPECT_EQ(animated.count("<animate attributeName=\"visibility\""), 4) << "without elevation there is no polygon";
    EXPECT_TRUE(animated.contains("dur=\"1.25s\""));
    EXPECT_EQ(animated.count("id=\"layer-curve\""), 1) << "what stands still is there once";
    EXPECT_TRUE(std::holds_alternative<Document>(readAnyDocument(animated.toStdString())));
    EXPECT_EQ(run("export arch.kriva -o f-{frame}.svg --frames 0,5").code, 0);
    EXPECT_FALSE(read("f-000.svg").contains("elevated-polygon"));
    EXPECT_TRUE(read("f-001.svg").contains("elevated-polygon"));
    expectOneLine(run("export arch.kriva -o a.svg --frames 20000"), ExitCode::failure,
                  "kriva: arch.kriva: the animation of the curve has no such frame");
    expectOneLine(run("export arch.kriva -o a.svg --frames t=0.5"), ExitCode::failure,
                  "kriva: arch.kriva: the animation of the curve has no such frame");
    expectOneLine(run("export arch.kriva -o a.png --frames 0,1 --animate"), ExitCode::usage,
                  "kriva: --animate needs --frames and an SVG file; kriva --help tells more");
}

TEST_F(ExportCommand, writesManyFilesEachUnderItsName) {
    write("second one;$(x).kriva", test::kArch);
    write("broken.kriva", "{");
    EXPECT_EQ(run({QStringLiteral("export"), QStringLiteral("arch.kriva"), QStringLiteral("broken.kriva"),
                   QStringLiteral("second one;$(x).kriva"), QStringLiteral("-o"), QStringLiteral("{name}-{sheet}.svg")})
                  .code,
              3)
        << "the worst of all, and the others are there";
    EXPECT_TRUE(read("arch-elevation.svg").contains("<svg"));
    EXPECT_TRUE(read("second_one___x_-elevation.svg").contains("<svg"));
}

TEST_F(ExportCommand, readsAndWritesStandardStreams) {
    const QByteArray file = exported({}, "a.svg");
    const test::Outcome outcome =
        run({QStringLiteral("export"), QStringLiteral("-"), QStringLiteral("-o"), QStringLiteral("-"),
             QStringLiteral("--format"), QStringLiteral("svg"), QStringLiteral("--language=en")},
            {}, path(QStringLiteral("arch.kriva")));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out, file);
}

TEST_F(ExportCommand, writesTexThatLatexBuildsInEveryAlphabet) {
    if (QStandardPaths::findExecutable(QStringLiteral("pdflatex")).isEmpty())
        GTEST_SKIP() << "LaTeX is not installed";
    write("chain.kriva", R"({"format":"kriva","version":1,"sheets":{"spline":{"curves":[
        {"knots":[{"at":[0,0]},{"at":[2,3]},{"at":[5,2]},{"at":[7,4]}]}]}}})");
    for (const char* language : {"en", "bg", "sl", "uk"}) {
        const test::Outcome outcome =
            run({QStringLiteral("export"), QStringLiteral("chain.kriva"), QStringLiteral("-o"), QStringLiteral("a.tex"),
                 QStringLiteral("--layers"), QStringLiteral("curve,knots,all-rules,labels"),
                 QStringLiteral("--language"), QString::fromLatin1(language)});
        EXPECT_EQ(outcome.code, 0);
        QProcess latex;
        latex.setWorkingDirectory(path({}));
        latex.start(QStringLiteral("pdflatex"), {QStringLiteral("-interaction=nonstopmode"),
                                                 QStringLiteral("-halt-on-error"), QStringLiteral("a.tex")});
        EXPECT_TRUE(latex.waitForFinished(120'000));
        EXPECT_EQ(latex.exitCode(), 0) << language << latex.readAllStandardOutput().toStdString();
    }
}

class Inkscape : public ExportCommand {
  protected:
    void SetUp() override {
        ExportCommand::SetUp();
        if (kProgram.isEmpty())
            GTEST_SKIP() << "Inkscape is not installed";
    }
    void inkscape(const QStringList& arguments) const {
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("HOME"), path({}));
        program.setProcessEnvironment(environment);
        program.setWorkingDirectory(path({}));
        program.start(kProgram, arguments);
        EXPECT_TRUE(program.waitForFinished(120'000));
        EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    }

  private:
    const QString kProgram = QStandardPaths::findExecutable(QStringLiteral("inkscape"));
};

TEST_F(Inkscape, givesFiguresBack) {
    const QDir examples(QStringLiteral(KRIVA_SOURCE_DIR "/resources/examples"));
    for (const char* name : {"start", "de-casteljau", "clamped-spline", "five-runs"}) {
        const QString example = examples.filePath(QString::fromLatin1(name) + QStringLiteral(".kriva"));
        const QStringList options{QStringLiteral("--inkscape-layers"), QStringLiteral("--language=en")};
        EXPECT_EQ(run(QStringList{QStringLiteral("export"), example, QStringLiteral("-o"), QStringLiteral("own.svg")} +
                      options)
                      .code,
                  0);
        inkscape({QStringLiteral("--export-plain-svg"), QStringLiteral("--export-filename=plain.svg"),
                  QStringLiteral("own.svg")});
        // The document inside gives the same figure, byte for byte; the lines drawn give the same curves.
        const test::Outcome again = run(QStringList{QStringLiteral("export"), QStringLiteral("plain.svg"),
                                                    QStringLiteral("-o"), QStringLiteral("again.svg")} +
                                        options);
        EXPECT_EQ(again.code, 0);
        EXPECT_EQ(again.error, "") << name << " was not edited";
        EXPECT_EQ(read("again.svg"), read("own.svg")) << name;
        EXPECT_EQ(run("import own.svg -o own.kriva --sheet spline").code, 0);
        EXPECT_EQ(run("import plain.svg -o plain.kriva --sheet spline").code, 0);
        EXPECT_EQ(read("plain.kriva"), read("own.kriva")) << name;
    }
}

TEST_F(Inkscape, movesACurve) {
    EXPECT_EQ(exported(QStringLiteral("--sheet elevation"), "own.svg").count("id=\"curve-0\""), 1);
    inkscape({QStringLiteral("--actions=select-by-id:curve-0;transform-translate:10,0;export-plain-svg;"
                             "export-filename:moved.svg;export-do"),
              QStringLiteral("own.svg")});
    expectOneLine(run("export moved.svg -o again.svg"), ExitCode::done,
                  "kriva: moved.svg: its lines were edited in another program; the document inside is taken as it was");
}

TEST_F(ExportCommand, tellsWhatAFormatCannotDraw) {
    expectOneLine(run("export arch.kriva -o a.png --width 900mm --dpi 4800"), ExitCode::failure,
                  "kriva: arch.kriva: the picture would have more than 16384 pixels a side");
    expectOneLine(run("export arch.kriva -o a.tex --width 5800mm"), ExitCode::failure,
                  "kriva: arch.kriva: TeX draws at most 5700 mm a side; give the figure a width");
}

} // namespace
} // namespace kriva
