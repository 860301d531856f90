#pragma once

#include "core/curve/limits.h"
#include "core/document/document.h"
#include "tests/support/sheet_curves.h"

#include <rapidcheck.h>

#include <bit>
#include <cmath>

namespace kriva::test {

/// A title or a name with everything that writers stumble over: markup, quotes, control characters, emoji, what XML
/// does not allow.
inline rc::Gen<std::string> anyText() {
    const auto piece = rc::gen::element<std::string>("a", "ж", "č", "<", ">", "&", "\"", "'", "\\", "]]>", "\n", "\t",
                                                     "\x01", "\x7f", "\u0085", "\u202e", "\uFFFE", "\U0001F642", " ");
    return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece),
                        [](const std::vector<std::string>& pieces) {
                            std::string text;
                            for (const std::string& part : pieces)
                                text += part;
                            return text;
                        });
}

/// Any double that a document may hold, bit for bit.
inline rc::Gen<double> anyCoordinate() {
    const auto fromBits = [](std::uint64_t bits) { return std::bit_cast<double>(bits); };
    const auto isAllowed = [](double x) { return std::isfinite(x) && std::abs(x) <= limits::kNumber; };
    return rc::gen::oneOf(rc::gen::element(0.0, -0.0, 1.0 / 3, limits::kNumber, 5e-324),
                          rc::gen::map(rc::gen::inRange(-1000, 1000), [](int n) { return n / 8.0; }),
                          rc::gen::suchThat(rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), fromBits), isAllowed));
}

inline rc::Gen<Points> anyPoints() {
    const auto point =
        rc::gen::map(rc::gen::pair(anyCoordinate(), anyCoordinate()), [](const std::pair<double, double>& xy) {
            return Point{xy.first, xy.second};
        });
    return rc::gen::resize(8, rc::gen::container<Points>(point));
}

/// Some curves in every sheet, with names, styles and views.
inline rc::Gen<Document> anyDocument() {
    return rc::gen::exec([] {
        Document document;
        document.title = *anyText();
        document.active = *rc::gen::inRange<SheetIndex>(0, 2);
        const int curves = *rc::gen::inRange(0, 4);
        for (int i = 0; i < curves; ++i) {
            ElevationCurve raised;
            raised.name = *anyText();
            raised.points = *anyPoints();
            raised.times = *rc::gen::inRange(0, 5);
            raised.view.isShown = *rc::gen::arbitrary<bool>();
            document.sheets[test::kElevation].curves.emplace_back(raised);
            SubdivisionCurve cut;
            cut.points = *anyPoints();
            cut.multiplicity.assign(cut.points.size(), *rc::gen::inRange(1, 3));
            cut.t = *rc::gen::element(0.5, 0.1, 1.0 / 3);
            cut.style.width = *rc::gen::element(0.5, 2.25);
            cut.style.dash = *rc::gen::element<std::optional<LineDash>>(std::nullopt, LineDash::solid, LineDash::dashed,
                                                                        LineDash::dotted, LineDash::dashDot);
            cut.style.marker = *rc::gen::element<std::optional<Marker>>(std::nullopt, Marker::none, Marker::circle,
                                                                        Marker::square, Marker::diamond);
            cut.style.hasLabels = *rc::gen::arbitrary<bool>();
            document.sheets[test::kSubdivision].curves.emplace_back(cut);
            SplineCurve chain;
            for (const Point p : *anyPoints())
                chain.knots.push_back({p, SplineKnot::Join::automatic, {}, {}});
            chain.rule = *rc::gen::element(SplineCurve::Rule::mirror, SplineCurve::Rule::natural,
                                           SplineCurve::Rule::clamped, SplineCurve::Rule::catmullRom);
            chain.degree = *rc::gen::inRange(2, 6);
            chain.closed = *rc::gen::arbitrary<bool>();
            document.sheets[test::kSpline].curves.emplace_back(chain);
            CombinedCurve runs;
            runs.points = *anyPoints();
            runs.method = *rc::gen::element(CombinedCurve::Method::approximation, CombinedCurve::Method::interpolation,
                                            CombinedCurve::Method::pairs);
            document.sheets[test::kCombined].curves.emplace_back(runs);
        }
        document.sheets[test::kElevation].view.layers["labels"] = *rc::gen::arbitrary<bool>();
        document.sheets[test::kSubdivision].view =
            withNumbers({}, kFurtherParameters,
                        *rc::gen::elementOf(std::vector<std::vector<double>>{{}, {0.5}, {1.0 / 3, 5e-324}}));
        FigureFileOptions written;
        written.format = *rc::gen::element(FigureFormat::svg, FigureFormat::pdf, FigureFormat::png, FigureFormat::tikz,
                                           FigureFormat::csv);
        written.drawing = {.width = *rc::gen::element<std::optional<double>>(std::nullopt, 120.5),
                           .mmPerUnit = *rc::gen::element<std::optional<double>>(std::nullopt, 1.0 / 3),
                           .margin = *rc::gen::element(6.0, 0.0, 1.0 / 3),
                           .hasLabels = *rc::gen::arbitrary<bool>(),
                           .theme = *rc::gen::element(Theme::light, Theme::dark)};
        written.drawing.layers = *rc::gen::element<std::optional<std::vector<std::string>>>(
            std::nullopt, std::vector<std::string>{}, std::vector<std::string>{"curve", "labels"});
        written.holdsDocument = *rc::gen::arbitrary<bool>();
        written.decimals = *rc::gen::element<std::optional<int>>(std::nullopt, 0, 12);
        written.hasInkscapeLayers = *rc::gen::arbitrary<bool>();
        written.hasOutlines = *rc::gen::arbitrary<bool>();
        written.dpi = *rc::gen::element(10, 300, 4800);
        written.isTransparent = *rc::gen::arbitrary<bool>();
        written.tikz = *rc::gen::element(TikzKind::standalone, TikzKind::fragment);
        written.frames =
            *rc::gen::element(std::vector<FramePlace>{}, std::vector<FramePlace>{{FramePlace::Over::stage, 7}},
                              std::vector<FramePlace>{{FramePlace::Over::t, 1.0 / 3}, {FramePlace::Over::t, 0.5}});
        written.isAnimated = *rc::gen::arbitrary<bool>();
        written.frameSeconds = *rc::gen::element(0.5, 0.01, 60.0);
        if (*rc::gen::arbitrary<bool>())
            document.sheets[test::kSubdivision].view.exported = written;
        const SheetView withPoints = withNumbers({}, kPolylinePoints, {*rc::gen::element(2.0, 8.0, 100.0)});
        document.sheets[test::kSpline].view =
            withNumbers(withPoints, kCombScale, {*rc::gen::element(1.0, 0.01, 2.0 / 3, 100.0)});
        return document;
    });
}

} // namespace kriva::test
