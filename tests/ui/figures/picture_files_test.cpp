#include "core/bezier/evaluate.h"
#include "core/bezier/nearest.h"
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

TEST(Png, dashesGoOnWhereALongLineIsCut) {
    constexpr int kPieces = 5'000;
    const auto pictureOf = [](const Points& points) {
        Drawing drawing;
        Stroke line{polyline(points), Role::curve};
        line.style.dash = LineDash::dashed;
        drawing.figure.layers = {{"curve", {line}}};
        drawing.page = pageOf(boxOf(drawing.figure));
        return QImage::fromData(writePng(drawing, textSource(), 150));
    };
    Points cut;
    for (int i = 0; i <= kPieces; ++i)
        cut.push_back({100.0 * i / kPieces, 30.0 * i / kPieces});
    const QImage whole = pictureOf({cut.front(), cut.back()});
    const QImage inParts = pictureOf(cut);
    ASSERT_EQ(inParts.size(), whole.size());
    int ink = 0, others = 0;
    for (int y = 0; y < whole.height(); ++y)
        for (int x = 0; x < whole.width(); ++x) {
            const int gray = qGray(whole.pixel(x, y));
            ink += gray < 128 ? 1 : 0;
            others += std::abs(gray - qGray(inParts.pixel(x, y))) > 100 ? 1 : 0;
        }
    EXPECT_GT(ink, 500);
    EXPECT_LT(others, ink / 100) << "a dash is where the line had a gap";
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
