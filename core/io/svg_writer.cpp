#include "core/io/svg_writer.h"

#include "core/document/document_json.h"
#include "core/figure/color.h"
#include "core/figure/label_placement.h"
#include "core/figure/labels.h"
#include "core/figure/plot/plot_figure.h"
#include "core/io/svg_namespace.h"
#include "core/io/svg_path.h"
#include "core/io/xml_text.h"

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
    SvgText(const SvgContent& content, const TextSource& texts)
        : content_(content)
        , texts_(texts) {}

    [[nodiscard]] std::string take() &&;

  private:
    void head();
    void layer(const Layer& layer, const std::vector<PlacedLabel>& labels);
    void stroke(const Stroke& stroke, bool isOfCurves);
    void marks(const Marks& marks);
    void mark(Point centre, const RoleStyle& style);
    void label(const PlacedLabel& label);
    /// An upright part of a label, that much lower than what stands before it.
    void part(std::string_view text, double drop, double size);
    void line(std::string_view text) { text_.append(text).append("\n"); }
    /// name="value" behind a blank; the value must need no escape.
    void attribute(std::string_view name, std::string_view value) {
        text_.append(" ").append(name).append("=\"").append(value).append("\"");
    }

    const SvgContent& content_;
    const TextSource& texts_;
    std::string text_;
    std::set<int> namedCurves_; ///< whose path has its id already
};

std::string SvgText::take() && {
    head();
    const auto labels = placedLabels(content_.figure, content_.page, texts_);
    for (std::size_t i = 0; i < labels.size(); ++i)
        layer(content_.figure.layers[i], labels[i]);
    line("</svg>");
    return std::move(text_);
}

void SvgText::head() {
    const int decimals = decimalsOf(content_.page);
    const std::string width = plainNumber(content_.page.width, decimals);
    const std::string height = plainNumber(content_.page.height, decimals);
    line(R"(<?xml version="1.0" encoding="UTF-8"?>)");
    text_ += R"(<svg xmlns="http://www.w3.org/2000/svg")";
    attribute("width", width + "mm");
    attribute("height", height + "mm");
    attribute("viewBox", "0 0 " + width + " " + height);
    attribute("role", "img");
    attribute("xml:lang", xmlText(texts_.language));
    line(">");
    line("<title>" + xmlText(content_.title) + "</title>");
    line("<desc>" + xmlText(content_.description) + "</desc>");
    if (!content_.document.empty()) {
        text_.append("<metadata><kriva:document xmlns:kriva=\"").append(kSvgDocumentNamespace).append("\">");
        line(xmlJson(content_.document) + "</kriva:document></metadata>");
    }
    if (!content_.hasPaper)
        return;
    text_ += "<rect id=\"paper\"";
    attribute("width", width);
    attribute("height", height);
    attribute("fill", hexOf(paperColor(content_.theme)));
    line("/>");
}

void SvgText::layer(const Layer& layer, const std::vector<PlacedLabel>& labels) {
    text_ += "<g";
    attribute("id", "layer-" + std::string(layer.name));
    if (!labels.empty()) {
        attribute("font-family", kTextFamily);
        attribute("font-size", fromPoints(kTextSize));
    }
    line(">");
    for (const Stroke& s : layer.strokes)
        stroke(s, layer.name == "curve");
    for (const Marks& m : layer.marks)
        marks(m);
    for (const PlacedLabel& l : labels)
        label(l);
    line("</g>");
}

void SvgText::stroke(const Stroke& stroke, bool isOfCurves) {
    const std::string data = pathData(stroke.path, content_.page);
    if (data.empty())
        return;
    const RoleStyle style = styleOf(stroke, content_.theme);
    text_ += "<path";
    if (isOfCurves && stroke.curve >= 0 && namedCurves_.insert(stroke.curve).second)
        attribute("id", "curve-" + decimal(stroke.curve));
    attribute("d", data);
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
    const RoleStyle style = styleOf(marks, content_.theme);
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
        mark(onPage(content_.page, p), style);
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
    constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
    text_ += "<text";
    attribute("x", millimetres(label.baseline.x));
    attribute("y", millimetres(label.baseline.y));
    attribute("text-anchor", kAnchors[static_cast<std::size_t>(label.anchor)]);
    if (label.isVariable)
        attribute("font-style", "italic");
    attribute("fill", hexOf(styleOf(label.role, 0, content_.theme).color));
    text_.append(">").append(xmlText(label.text));
    if (!label.subscript.empty())
        part(label.subscript, kSubscriptDrop, kSubscriptSize);
    if (!label.suffix.empty())
        part(label.suffix, label.subscript.empty() ? 0 : -kSubscriptDrop, kTextSize);
    line("</text>");
}

void SvgText::part(std::string_view text, double drop, double size) {
    text_ += "<tspan";
    attribute("dy", fromPoints(drop));
    attribute("font-size", fromPoints(size));
    attribute("font-style", "normal");
    text_.append(">").append(xmlText(text)).append("</tspan>");
}

/// "Elevation: Control polygon, Curve, Points"
std::string describe(const Figure& figure, SheetIndex sheet, const TextSource& texts) {
    std::string text = texts.translate(captionOf(sheet));
    std::string_view separator = ": ";
    for (const Layer& layer : figure.layers) {
        for (const LayerInfo& info : layersOf(sheet)) {
            if (info.name == layer.name) {
                text.append(separator).append(texts.translate(info.caption));
                separator = ", ";
            }
        }
    }
    return text;
}

} // namespace

std::string writeSvg(const SvgContent& content, const TextSource& texts) {
    return SvgText(content, texts).take();
}

std::string writeSheetSvg(const Document& document, SheetIndex sheet, const TextSource& texts,
                          const SvgOptions& options) {
    SvgContent content;
    content.figure = figureOf(document.sheets[sheet], sheet);
    content.page = pageOf(boxOf(content.figure), document.sheets[sheet].view.mmPerUnit);
    content.title = document.title.empty() ? texts.translate(captionOf(sheet)) : document.title;
    content.description = describe(content.figure, sheet, texts);
    content.theme = options.theme;
    if (options.holdsDocument) {
        content.document = writeDocument(document, 0);
        content.document.pop_back(); // one line of the file, without its end
    }
    return writeSvg(content, texts);
}

std::string writePlotsSvg(std::span<const Plot> plots, const TextSource& texts, Theme theme) {
    const PlotSize size;
    SvgContent content;
    content.figure = plotFigure(plots, size);
    content.page = plotPage(plots.size(), size);
    content.theme = theme;
    for (const Plot& plot : plots)
        content.title.append(content.title.empty() ? "" : ", ").append(texts.translate(plot.caption));
    content.description = content.title;
    return writeSvg(content, texts);
}

} // namespace kriva
