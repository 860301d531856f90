#include "core/io/drawing/drawn_pieces.h"
#include "core/io/json/document_json.h"
#include "core/io/open.h"
#include "core/io/svg/drawn_document.h"
#include "core/io/svg/paths/svg_paths.h"
#include "core/io/svg/svg_writer.h"
#include "tests/support/any_document.h"
#include "tests/support/sheet_svg.h"

#include <gtest/gtest.h>

// A figure is exported, and read by Kriva as a document and as a drawing.
namespace kriva {
namespace {

const TextSource kRoundTripTexts{[](Caption) { return "Word"; }, [](double, int) { return std::string(); }, "en"};

/// What an SVG shows of the curves of a sheet, in millimetres of the page with y up.
std::vector<Points> drawnCurves(const Drawing& drawing) {
    std::vector<Points> drawn;
    for (const Layer& layer : drawing.figure.layers)
        for (const Stroke& stroke : layer.name == "curve" ? layer.strokes : std::vector<Stroke>()) {
            Points points;
            forEachDrawnPiece(stroke.path, drawing.page, [&](std::span<const Point> piece) {
                for (const Point p : points.empty() ? piece : piece.subspan(1))
                    points.push_back({p.x, -p.y});
            });
            if (!points.empty())
                drawn.push_back(std::move(points));
        }
    return drawn;
}

void expectDrawn(const std::string& svg, const Drawing& drawing) {
    const std::vector<Points> expected = drawnCurves(drawing);
    if (expected.empty())
        return;
    const auto read = readSvgPaths(svg);
    const auto* paths = std::get_if<std::vector<ImportedPath>>(&read);
    ASSERT_TRUE(paths);
    ASSERT_EQ(paths->size(), expected.size());
    const double tolerance = 1e-12 * std::hypot(drawing.page.width, drawing.page.height);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Points& points = (*paths)[i].path.points;
        ASSERT_EQ(points.size(), expected[i].size());
        for (std::size_t k = 0; k < points.size(); ++k)
            ASSERT_LE(distance(points[k], expected[i][k]), tolerance);
    }
}

TEST(SvgRoundTrip, bringsBackAThousandDocumentsAndTheirCurves) {
    constexpr int kSize = 20; // of lists, as RapidCheck counts
    const rc::Gen<Document> any = test::anyDocument();
    int drawn = 0;
    for (std::uint64_t seed = 0; seed < 1000 && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        const Document document = any(rc::Random(seed), kSize).value();
        for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
            if (document.sheets[sheet].curves.empty())
                continue;
            const std::string svg = test::sheetSvg(document, sheet, kRoundTripTexts);
            const auto back = readAnyDocument(svg);
            ASSERT_TRUE(std::holds_alternative<Document>(back));
            // The text tells -0.0 from 0.0, which compare equal.
            EXPECT_EQ(writeDocument(std::get<Document>(back)), writeDocument(document));
            const Drawing drawing = drawingOf(document, sheet, kRoundTripTexts);
            expectDrawn(svg, drawing);
            EXPECT_FALSE(drawnDocument(svg, document)) << "nobody edited it";
            EXPECT_FALSE(drawnDocument(test::sheetSvg(document, sheet, kRoundTripTexts, {}, {{}, 2}), document));
            drawn += drawnCurves(drawing).empty() ? 0 : 1;
        }
    }
    EXPECT_GT(drawn, 500) << "most of them show something";
}

} // namespace
} // namespace kriva
