#include "core/io/svg/svg_writer.h"

#include "core/figure/label_placement.h"
#include "core/figure/labels.h"
#include "core/figure/style/color.h"
#include "core/io/json/document_json.h"
#include "core/io/numbers/plain_number.h"
#include "core/io/svg/drawn_sheet.h"
#include "core/io/svg/svg_animation.h"
#include "core/io/svg/svg_path.h"
#include "core/io/svg/xml/svg_names.h"
#include "core/io/svg/xml/xml_text.h"

#include <algorithm>
#include <set>

namespace kriva {
namespace {

/// Millimetres, for what needs no more: a tenth of a micrometre.
std::string millimetres(double value) {
    return plainNumber(value, 4);
}

std::string fromPoints(double points) {
    return millimetres(points * kMillimetresPerPoint);
}

class SvgText {
  public:
    SvgText(const Drawing& drawing, const TextSource& texts, const SvgOptions& options)
        : drawing_(drawing)
        , texts_(texts)
        , options_(options)
        , decimals_(options.decimals.value_or(decimalsOf(drawing.page))) {}

    /// The drawing alone.
    [[nodiscard]] std::string take() &&;
    /// The drawing and further frames.
    [[nodiscard]] std::string takeAnimated(std::span<const Drawing> frames, double seconds) &&;

  private:
    void head();
    void layer(const Drawing& drawing, std::size_t index, const std::vector<PlacedLabel>& labels,
               std::string_view idSuffix = {});
    void metadata();
    void stroke(const Stroke& stroke, bool isOfCurves);
    void marks(const Marks& marks);
    void mark(Point centre, const RoleStyle& style);
    void label(const PlacedLabel& label);
    void outline(const PlacedLabel& label);
    /// An upright part of a label, that much lower than what stands before it.
    void part(std::string_view text, double drop, double size);
    void line(std::string_view text) { text_.append(text).append("\n"); }
    /// name="value" behind a blank; the value must need no escape.
    void attribute(std::string_view name, std::string_view value) {
        text_.append(" ").append(name).append("=\"").append(value).append("\"");
    }

    const Drawing& drawing_;
    const TextSource& texts_;
    const SvgOptions& options_;
    int decimals_;
    std::string text_;
    std::set<int> namedCurves_; ///< whose path has its id already
};

std::string SvgText::take() && {
    head();
    const auto labels = placedLabels(drawing_.figure, drawing_.page, texts_);
    for (std::size_t i = 0; i < labels.size(); ++i)
        layer(drawing_, i, labels[i]);
    line("</svg>");
    return std::move(text_);
}

std::string SvgText::takeAnimated(std::span<const Drawing> frames, double seconds) && {
    head();
    for (const FrameLayer& layer : frameLayers(frames, texts_)) {
        if (layer.standsStill) {
            this->layer(frames.front(), layer.parts.front().index, layer.parts.front().labels);
            continue;
        }
        for (const FrameLayer::Part& part : layer.parts) {
            line(groupOfFrame(part.frame, frames.size(), seconds));
            this->layer(frames[part.frame], part.index, part.labels, "-" + decimal(static_cast<int>(part.frame)));
            line("</g>");
        }
    }
    line("</svg>");
    return std::move(text_);
}

void SvgText::head() {
    // However few decimals the lines have, the page has its size.
    const int decimals = decimalsOf(drawing_.page);
    const std::string width = plainNumber(drawing_.page.width, decimals);
    const std::string height = plainNumber(drawing_.page.height, decimals);
    line(R"(<?xml version="1.0" encoding="UTF-8"?>)");
    text_ += R"(<svg xmlns="http://www.w3.org/2000/svg")";
    if (options_.hasInkscapeLayers)
        attribute("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    attribute("width", width + "mm");
    attribute("height", height + "mm");
    attribute("viewBox", "0 0 " + width + " " + height);
    attribute("role", "img");
    attribute("xml:lang", xmlText(texts_.language));
    line(">");
    line("<title>" + xmlText(drawing_.title) + "</title>");
    line("<desc>" + xmlText(drawing_.description) + "</desc>");
    if (!options_.document.empty())
        metadata();
    if (!drawing_.hasPaper)
        return;
    text_ += "<rect id=\"paper\"";
    attribute("width", width);
    attribute("height", height);
    attribute("fill", hexOf(paperColor(drawing_.theme)));
    line("/>");
}

void SvgText::metadata() {
    const auto element = [&](std::string_view name, const std::string& json) {
        text_.append("<kriva:").append(name).append(" xmlns:kriva=\"").append(kSvgNamespace).append("\">");
        text_.append(xmlJson(json)).append("</kriva:").append(name).append(">");
    };
    text_ += "<metadata>";
    element(kSvgDocument, options_.document);
    if (drawing_.sheet)
        element(kSvgDrawing, writeDrawnSheet(drawnSheetOf(drawing_, decimals_)));
    line("</metadata>");
}

void SvgText::layer(const Drawing& drawing, std::size_t index, const std::vector<PlacedLabel>& labels,
                    std::string_view idSuffix) {
    const Layer& layer = drawing.figure.layers[index];
    text_ += "<g";
    attribute("id", std::string(kSvgLayerId).append(layer.name).append(idSuffix));
    if (options_.hasInkscapeLayers) {
        attribute("inkscape:groupmode", "layer");
        attribute("inkscape:label", xmlText(drawing.layerTitles[index]));
    }
    if (!labels.empty()) {
        attribute("font-family", kTextFamily);
        attribute("font-size", fromPoints(kTextSize));
    }
    line(">");
    for (const Stroke& s : layer.strokes)
        stroke(s, layer.name == kCurveLayer);
    for (const Marks& m : layer.marks)
        marks(m);
    for (const PlacedLabel& l : labels)
        label(l);
    line("</g>");
}

void SvgText::stroke(const Stroke& stroke, bool isOfCurves) {
    const std::vector<int>& degrees = stroke.path.degrees;
    if (std::ranges::all_of(degrees, [](int degree) { return degree == 0; }))
        return;
    const RoleStyle style = styleOf(stroke, drawing_.theme);
    text_ += "<path";
    if (isOfCurves && stroke.curve >= 0 && namedCurves_.insert(stroke.curve).second)
        attribute("id", std::string(kSvgCurveId) + decimal(stroke.curve));
    text_ += " d=\"";
    appendPathData(text_, stroke.path, drawing_.page, decimals_);
    text_ += '"';
    attribute("fill", "none");
    attribute("stroke", hexOf(style.color));
    attribute("stroke-width", fromPoints(style.width));
    attribute("stroke-linejoin", "round");
    if (style.dashes.empty()) {
        attribute("stroke-linecap", "round");
    } else {
        std::string dashes;
        for (const double length : style.dashes)
            dashes.append(dashes.empty() ? "" : " ").append(fromPoints(length));
        attribute("stroke-dasharray", dashes);
    }
    if (stroke.strength < 1)
        attribute("stroke-opacity", plainNumber(stroke.strength, 3));
    line("/>");
}

void SvgText::marks(const Marks& marks) {
    const RoleStyle style = styleOf(marks, drawing_.theme);
    if (style.marker == Marker::none || marks.at.empty())
        return;
    text_ += "<g";
    attribute("fill", style.marker == Marker::ring ? "none" : hexOf(style.markerFill));
    if (style.markerWidth > 0) {
        attribute("stroke", hexOf(style.color));
        attribute("stroke-width", fromPoints(style.markerWidth));
    }
    line(">");
    for (const Point p : marks.at)
        mark(onPage(drawing_.page, p), style);
    line("</g>");
}

void SvgText::mark(Point centre, const RoleStyle& style) {
    const double size = style.markerSize * kMillimetresPerPoint;
    const auto [x, y] = centre;
    if (style.marker == Marker::square) {
        text_ += "<rect";
        attribute("x", millimetres(x - size / 2));
        attribute("y", millimetres(y - size / 2));
        attribute("width", millimetres(size));
        attribute("height", millimetres(size));
    } else if (style.marker == Marker::diamond) {
        const auto corner = [&](double dx, double dy) {
            return millimetres(x + dx * size / 2) + "," + millimetres(y + dy * size / 2);
        };
        text_ += "<polygon";
        attribute("points", corner(0, -1) + " " + corner(1, 0) + " " + corner(0, 1) + " " + corner(-1, 0));
    } else {
        text_ += "<circle";
        attribute("cx", millimetres(x));
        attribute("cy", millimetres(y));
        attribute("r", millimetres(size / 2));
    }
    line("/>");
}

void SvgText::label(const PlacedLabel& label) {
    if (options_.outlineOf)
        return outline(label);
    constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
    text_ += "<text";
    attribute("x", millimetres(label.baseline.x));
    attribute("y", millimetres(label.baseline.y));
    attribute("text-anchor", kAnchors[static_cast<std::size_t>(label.anchor)]);
    if (label.isVariable)
        attribute("font-style", "italic");
    attribute("fill", hexOf(labelColor(label.role, drawing_.theme)));
    text_.append(">").append(xmlText(label.text));
    if (!label.subscript.empty())
        part(label.subscript, kSubscriptDrop, kSubscriptSize);
    if (!label.suffix.empty())
        part(label.suffix, label.subscript.empty() ? 0 : -kSubscriptDrop, kTextSize);
    line("</text>");
}

void SvgText::outline(const PlacedLabel& label) {
    text_ += "<path";
    attribute("aria-label", xmlText(label.text + label.subscript + label.suffix));
    attribute("d", options_.outlineOf(label));
    attribute("fill", hexOf(labelColor(label.role, drawing_.theme)));
    line("/>");
}

void SvgText::part(std::string_view text, double drop, double size) {
    text_ += "<tspan";
    attribute("dy", fromPoints(drop));
    attribute("font-size", fromPoints(size));
    attribute("font-style", "normal");
    text_.append(">").append(xmlText(text)).append("</tspan>");
}

} // namespace

std::string writeSvg(const Drawing& drawing, const TextSource& texts, const SvgOptions& options) {
    return SvgText(drawing, texts, options).take();
}

std::string writeAnimatedSvg(std::span<const Drawing> frames, double seconds, const TextSource& texts,
                             const SvgOptions& options) {
    return SvgText(frames.front(), texts, options).takeAnimated(frames, seconds);
}

std::string documentForSvg(const Document& document) {
    std::string json = writeDocument(document, 0);
    json.pop_back(); // without the end of its line
    return json;
}

} // namespace kriva
