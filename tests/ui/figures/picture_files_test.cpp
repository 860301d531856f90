#include "core/bezier/evaluate.h"
#include "core/bezier/nearest.h"
#include "core/figure/labels.h"
#include "ui/document/safe_write.h"
#include "ui/figures/caption_text.h"
#include "ui/figures/figure_file.h"
#include "ui/figures/picture_files.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <cstdlib>

namespace kriva::ui {
namespace {

const Points kLoop{{0, 0}, {9, 7}, {-4, 7}, {5, 0}};
const Points kOfDegreeSix{{0, 0}, {0, 8}, {9, 9}, {2, -6}, {5, 9}, {9, 3}, {9, 0}};

Drawing drawingOfCurve(const Points& curve) {
    Drawing drawing;
    drawing.figure.layers = {{"curve", {{singleCurve(curve), Role::curve}}}};
    drawing.page = pageOf(boxOf(drawing.figure));
    return drawing;
}

/// How the ink of a picture fits a curve.
struct Ink {
    double distance = 0; ///< how far it lies from the curve at most, beyond half its pen, in pixels
    bool isWhole = true; ///< it is wherever the curve is
};
Ink inkAlong(const QImage& picture, const Drawing& drawing, const Points& curve, double dpi) {
    constexpr int kWhite = 250;
    constexpr int kSamples = 4000;
    const double pixel = 25.4 / dpi;
    const double halfPen = styleOf(Role::curve, 0, Theme::light).width * kMillimetresPerPoint / 2 / pixel;
    Points inPixels;
    for (const Point p : curve) {
        const Point at = onPage(drawing.page, p);
        inPixels.push_back({at.x / pixel, at.y / pixel});
    }
    Ink found;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (qGray(picture.pixel(x, y)) < kWhite) {
                const Point centre{x + 0.5, y + 0.5};
                found.distance = std::max(found.distance, nearest(inPixels, centre).distance - halfPen);
            }
    for (int i = 0; i <= kSamples; ++i) {
        const Point at = evaluate(inPixels, static_cast<double>(i) / kSamples);
        if (qGray(picture.pixel(static_cast<int>(at.x), static_cast<int>(at.y))) >= kWhite)
            found.isWhole = false;
    }
    return found;
}

TEST(Png, liesWithinAPixelOfTheExactCurve) {
    constexpr int kDpi = 100; // pixels are larger against the curve's errors at 300, and there are more of them
    for (const Points& curve : {kLoop, kOfDegreeSix}) {
        const Drawing drawing = drawingOfCurve(curve);
        const Ink found = inkAlong(QImage::fromData(writePng(drawing, textSource(), kDpi)), drawing, curve, kDpi);
        EXPECT_LE(found.distance, 1);
        EXPECT_TRUE(found.isWhole);
    }
}

/// A picture of one stroke along these points.
QImage pictureOfLine(const Points& points, LineDash dash = LineDash::solid) {
    Drawing drawing;
    Stroke line{polyline(points), Role::curve};
    line.style.dash = dash;
    drawing.figure.layers = {{"curve", {line}}};
    drawing.page = pageOf(boxOf(drawing.figure));
    return QImage::fromData(writePng(drawing, textSource(), 150));
}

/// How many pixels of two pictures differ by more than some grays, for each that has ink in the first.
double shareOfOthers(const QImage& first, const QImage& second, int grays) {
    EXPECT_EQ(first.size(), second.size());
    int ink = 0;
    int others = 0;
    for (int y = 0; y < first.height(); ++y)
        for (int x = 0; x < first.width(); ++x) {
            const int gray = qGray(first.pixel(x, y));
            ink += gray < 128 ? 1 : 0;
            others += std::abs(gray - qGray(second.pixel(x, y))) > grays ? 1 : 0;
        }
    EXPECT_GT(ink, 500);
    return static_cast<double>(others) / ink;
}

/// The points of a polyline and so many between each two of them.
Points refined(const Points& points, int between) {
    Points fine;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        for (int k = 0; k <= between; ++k)
            fine.push_back(lerp(points[i], points[i + 1], static_cast<double>(k) / (between + 1)));
    fine.push_back(points.back());
    return fine;
}

TEST(Png, dashesGoOnWhereALongLineIsCut) {
    const Points line{{0, 0}, {100, 30}};
    const QImage whole = pictureOfLine(line, LineDash::dashed);
    EXPECT_LT(shareOfOthers(whole, pictureOfLine(refined(line, 5'000), LineDash::dashed), 100), 0.01)
        << "a dash is where the line had a gap";
}

TEST(Png, longStraightPiecesLookAsShortOnesDo) {
    const Points corners{{0, 0}, {100, 8}, {3, 20}, {100, 40}, {100, 90}, {0, 30}};
    EXPECT_LT(shareOfOthers(pictureOfLine(corners), pictureOfLine(refined(corners, 50)), 60), 0.01);
}

TEST(Png, linesOfManyPointsLookAsTheirCornersDo) {
    Points turns;
    for (int i = 0; i <= 1'500; ++i)
        turns.push_back({0.03 * i * std::cos(i / 30.0), 0.03 * i * std::sin(i / 30.0)});
    EXPECT_LT(shareOfOthers(pictureOfLine(turns), pictureOfLine(refined(turns, 20)), 60), 0.01);
}

TEST(Png, marksThatAreLeftOutAreNotMissed) {
    const auto pictureOf = [](int count) {
        Drawing drawing;
        Points places;
        for (int i = 0; i <= count; ++i)
            places.push_back({100.0 * i / count, 30.0 * i / count});
        drawing.figure.layers = {{"points", {}, {{places, Role::point}}}};
        drawing.page = pageOf(boxOf(drawing.figure));
        return QImage::fromData(writePng(drawing, textSource(), 150));
    };
    const QImage all = pictureOf(1'500); // each is painted, half a pixel from the one before
    const QImage fewer = pictureOf(6'000);
    ASSERT_EQ(fewer.size(), all.size());
    int ink = 0, others = 0;
    for (int y = 0; y < all.height(); ++y)
        for (int x = 0; x < all.width(); ++x) {
            ink += qGray(all.pixel(x, y)) < 250 ? 1 : 0;
            others += (qGray(all.pixel(x, y)) < 250) != (qGray(fewer.pixel(x, y)) < 250) ? 1 : 0;
        }
    EXPECT_GT(ink, 2'000);
    EXPECT_LT(others, ink / 10) << "the outline of all of them";
}

TEST(Png, hasTheSizeOfThePageAtItsResolution) {
    Drawing drawing = drawingOfCurve(kLoop);
    const QImage picture = QImage::fromData(writePng(drawing, textSource(), 300));
    EXPECT_EQ(picture.size(), pixelSize(drawing.page, 300));
    EXPECT_EQ(picture.dotsPerMeterX(), 11'811);
    EXPECT_EQ(picture.pixelColor(0, 0), QColor(Qt::white));
    drawing.hasPaper = false;
    EXPECT_EQ(QImage::fromData(writePng(drawing, textSource(), 300)).pixelColor(0, 0).alpha(), 0);
}

TEST(Png, isTheSameWhereItIsPaintedInParts) {
    Drawing drawing = drawingOfCurve(kLoop);
    Stroke dashed{polyline(refined(kLoop, 1'000)), Role::controlPolygon};
    dashed.style.dash = LineDash::dashed;
    drawing.figure.layers.push_back({"control-polygon", {dashed}, {{kLoop, Role::point}}, indexedLabels("P", kLoop)});
    drawing.page = pageOf(boxOf(drawing.figure));
    for (const bool hasPaper : {true, false}) {
        drawing.hasPaper = hasPaper;
        const QByteArray whole = writePng(drawing, textSource(), 150);
        EXPECT_TRUE(writePng(drawing, textSource(), 150, 100'000) == whole) << hasPaper;
        EXPECT_TRUE(writePng(drawing, textSource(), 150, 10'000) == whole) << hasPaper;
        EXPECT_EQ(QImage::fromData(whole).hasAlphaChannel(), !hasPaper);
    }
}

TEST(Png, drawsLongCurvesWithoutSeams) {
    Points points;
    for (int i = 0; i <= 1000; ++i)
        points.push_back({i / 10.0, 5 * std::sin(i / 30.0)});
    Drawing drawing;
    drawing.figure.layers = {{"curve", {{polyline(points), Role::curve}}}};
    drawing.page = pageOf(boxOf(drawing.figure));
    const QImage picture = QImage::fromData(writePng(drawing, textSource(), 150));
    for (const Point p : points) {
        const Point at = onPage(drawing.page, p);
        EXPECT_LT(qGray(picture.pixel(static_cast<int>(at.x / 25.4 * 150), static_cast<int>(at.y / 25.4 * 150))), 150);
    }
}

/// What a program of the system prints about the file; nothing where it is not installed or does not accept it.
std::optional<QString> said(const char* program, const QStringList& arguments) {
    if (QStandardPaths::findExecutable(QLatin1String(program)).isEmpty())
        return {};
    QProcess process;
    process.start(QLatin1String(program), arguments);
    process.waitForFinished();
    EXPECT_EQ(process.exitCode(), 0) << program;
    return QString::fromUtf8(process.readAllStandardOutput());
}

/// A drawing in a file of the folder, and what programs make of it at 300 dpi.
class Rendered : public testing::TestWithParam<FigureFormat> {
  protected:
    static constexpr int kDpi = 300;

    [[nodiscard]] QImage rendered(const Drawing& drawing) {
        FigureFileOptions options;
        options.format = GetParam();
        const FigureFile file = drawingFile(drawing, options);
        const QString name = QStringLiteral("a") + suffixOf(GetParam());
        EXPECT_FALSE(safeWrite(folder_.filePath(name), std::get<QByteArray>(file)));
        const QString dpi = QString::number(kDpi);
        if (GetParam() == FigureFormat::svg)
            run("rsvg-convert", {QStringLiteral("-d"), dpi, QStringLiteral("-p"), dpi, name, QStringLiteral("-o"),
                                 QStringLiteral("a.png")});
        if (GetParam() == FigureFormat::tikz)
            run("pdflatex", {QStringLiteral("-interaction=batchmode"), name});
        if (GetParam() == FigureFormat::tikz || GetParam() == FigureFormat::pdf)
            run("pdftoppm", {QStringLiteral("-r"), dpi, QStringLiteral("-png"), QStringLiteral("-singlefile"),
                             QStringLiteral("a.pdf"), QStringLiteral("a")});
        return QImage(folder_.filePath(QStringLiteral("a.png")));
    }
    [[nodiscard]] static bool isInstalled() {
        return GetParam() != FigureFormat::tikz ||
               !QStandardPaths::findExecutable(QStringLiteral("pdflatex")).isEmpty();
    }

  private:
    void run(const char* program, const QStringList& arguments) {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(QLatin1String(program), arguments);
        EXPECT_TRUE(process.waitForFinished(60'000));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    }

    QTemporaryDir folder_;
};

TEST_P(Rendered, liesWithinAPixelOfTheExactCurve) {
    if (!isInstalled())
        GTEST_SKIP() << "LaTeX is not installed";
    for (const Points& curve : {kLoop, kOfDegreeSix}) {
        const Drawing drawing = drawingOfCurve(curve);
        const QImage picture = rendered(drawing);
        ASSERT_FALSE(picture.isNull());
        const Ink found = inkAlong(picture, drawing, curve, kDpi);
        EXPECT_LE(found.distance, 1);
        EXPECT_TRUE(found.isWhole);
    }
}

INSTANTIATE_TEST_SUITE_P(EachFormat, Rendered,
                         testing::Values(FigureFormat::svg, FigureFormat::pdf, FigureFormat::png, FigureFormat::tikz));

TEST(Pdf, isSoundWithItsFontsInsideAndItsWordsReadable) {
    Drawing drawing = drawingOfCurve(kLoop);
    Layer labels{"labels"};
    labels.labels = {{{0, 0}, Caption::none, "Крива", ""}, {{5, 0}, Caption::none, "krivulja čšž", ""}};
    drawing.figure.layers.push_back(labels);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.pdf"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(writePdf(drawing, textSource()));
    file.close();
    if (const auto check = said("qpdf", {QStringLiteral("--check"), path})) {
        EXPECT_TRUE(check->contains(QStringLiteral("No syntax or stream encoding errors"))) << check->toStdString();
    }
    if (const auto words = said("pdftotext", {path, QStringLiteral("-")})) {
        EXPECT_TRUE(words->contains(QStringLiteral("Крива"))) << words->toStdString();
        EXPECT_TRUE(words->contains(QStringLiteral("krivulja čšž"))) << words->toStdString();
    }
    if (const auto fonts = said("pdffonts", {path})) {
        const QStringList lines = fonts->split(u'\n', Qt::SkipEmptyParts).mid(2);
        EXPECT_FALSE(lines.isEmpty());
        for (const QString& line : lines)
            EXPECT_EQ(line.simplified().section(u' ', -5, -5), QStringLiteral("yes")) << line.toStdString();
    }
}

} // namespace
} // namespace kriva::ui
