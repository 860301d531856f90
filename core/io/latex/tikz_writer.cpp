#include "core/io/latex/tikz_writer.h"

#include "core/figure/label_placement.h"
#include "core/figure/labels.h"
#include "core/io/drawing/drawn_pieces.h"
#include "core/io/latex/latex_text.h"
#include "core/io/numbers/plain_number.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace kriva {
namespace {

/// A TeX length is a multiple of 5.4e-6 mm.
constexpr int kTexDecimals = 5;

/// TeX has points of its own; these are the ones of figures, 1/72 inch.
std::string bigPoints(double points) {
    return plainNumber(points, 3) + "bp";
}

std::string colorText(Color color) {
    return "{rgb,255:red," + decimal(color.red) + ";green," + decimal(color.green) + ";blue," + decimal(color.blue) +
           "}";
}

/// By all bits, in the order of x, then y.
struct PointOrder {
    bool operator()(Point a, Point b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

class TikzText {
  public:
    TikzText(const Drawing& drawing, const TextSource& texts)
        : drawing_(drawing)
        , labels_(placedLabels(drawing.figure, drawing.page, texts)) {}

    [[nodiscard]] std::string take() &&;
    /// The line that loads the encodings of fonts that the labels need; none where they are plain letters, for which
    /// TeX's own fonts do.
    [[nodiscard]] std::string encodingsLine() const;

  private:
    void nameCoordinates();
    void layer(std::size_t index);
    void stroke(const Stroke& stroke, std::string_view layer);
    void piece(std::span<const Point> piece);
    void curveTo(std::string_view firstControl, std::string_view secondControl, std::string_view end);
    void marks(const Marks& marks, std::string_view layer);
    void mark(Point at, const RoleStyle& style);
    void label(const PlacedLabel& label, std::string_view layer);

    /// The name of the style with these options, made where there is none: "kriva curve", "kriva curve 2".
    std::string styleNamed(const std::string& name, const std::string& options);
    /// Of a place on the page: "(b3)" where it has a name, else "(12.5,7)".
    [[nodiscard]] std::string coordinate(Point p) const;
    /// With TeX's y, which goes up.
    [[nodiscard]] std::string onTex(Point p) const {
        return "(" + plainNumber(p.x, kTexDecimals) + "," + plainNumber(drawing_.page.height - p.y, kTexDecimals) + ")";
    }
    void line(std::string_view text) { body_.append("  ").append(text).append("\n"); }

    const Drawing& drawing_;
    std::vector<std::vector<PlacedLabel>> labels_;
    std::map<Point, std::string, PointOrder> names_;                   ///< of places on the page
    std::map<std::string, std::map<std::string, std::string>> styles_; ///< by name and options: what it is called
    std::string coordinates_;
    std::string definitions_;
    std::string body_;
};

std::string TikzText::take() && {
    nameCoordinates();
    const std::string corner = "(" + plainNumber(drawing_.page.width, kTexDecimals) + "," +
                               plainNumber(drawing_.page.height, kTexDecimals) + ")";
    line("\\path[use as bounding box] (0,0) rectangle " + corner + ";");
    if (drawing_.hasPaper && drawing_.theme == Theme::dark)
        line("\\fill[fill=" + colorText(paperColor(drawing_.theme)) + "] (0,0) rectangle " + corner + ";");
    for (std::size_t i = 0; i < drawing_.figure.layers.size(); ++i)
        layer(i);
    return "\\begin{tikzpicture}[x=1mm, y=1mm, line join=round,\n" + definitions_ + "]\n" + coordinates_ + body_ +
           "\\end{tikzpicture}\n";
}

std::string TikzText::encodingsLine() const {
    std::string text;
    for (const std::vector<PlacedLabel>& ofLayer : labels_)
        for (const PlacedLabel& label : ofLayer)
            text += latexText(label.text + label.suffix);
    const bool isPlain = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (isPlain)
        return {};
    return std::string("\\usepackage[").append(hasCyrillic(text) ? "T1,T2A" : "T1").append("]{fontenc}\n");
}

void TikzText::nameCoordinates() {
    std::set<std::string> taken;
    for (const Layer& layer : drawing_.figure.layers) {
        for (const Label& label : layer.labels) {
            // "b" and "3"; what has brackets in its name, or none, is no name for TikZ.
            const std::string name = label.text + label.subscript;
            const Point at = onPage(drawing_.page, label.at);
            const bool isName = !label.subscript.empty() && std::ranges::all_of(name, [](char c) {
                return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
            });
            if (!isName || names_.contains(at) || !taken.insert(name).second)
                continue;
            names_.emplace(at, name);
            coordinates_.append("  \\coordinate (").append(name).append(") at ").append(onTex(at)).append(";\n");
        }
    }
}

std::string TikzText::coordinate(Point p) const {
    const auto named = names_.find(p);
    return named == names_.end() ? onTex(p) : "(" + named->second + ")";
}

std::string TikzText::styleNamed(const std::string& name, const std::string& options) {
    std::map<std::string, std::string>& ofName = styles_[name];
    const auto known = ofName.find(options);
    if (known != ofName.end())
        return known->second;
    const std::string number = ofName.empty() ? "" : " " + decimal(static_cast<int>(ofName.size()) + 1);
    std::string called = "kriva " + name + number;
    definitions_.append("  ").append(called).append("/.style={").append(options).append("},\n");
    ofName.emplace(options, called);
    return called;
}

void TikzText::layer(std::size_t index) {
    const Layer& layer = drawing_.figure.layers[index];
    line("% " + std::string(layer.name));
    for (const Stroke& s : layer.strokes)
        stroke(s, layer.name);
    for (const Marks& m : layer.marks)
        marks(m, layer.name);
    for (const PlacedLabel& l : labels_[index])
        label(l, layer.name);
}

void TikzText::stroke(const Stroke& stroke, std::string_view layer) {
    if (stroke.path.degrees.empty())
        return;
    const RoleStyle style = styleOf(stroke, drawing_.theme);
    std::string options = "draw=" + colorText(style.color) + ", line width=" + bigPoints(style.width);
    if (style.dashes.empty()) {
        options += ", line cap=round";
    } else {
        options += ", dash pattern=";
        for (std::size_t i = 0; i < style.dashes.size(); ++i)
            options.append(i > 0 ? " " : "").append(i % 2 == 0 ? "on " : "off ").append(bigPoints(style.dashes[i]));
    }
    if (stroke.strength < 1)
        options += ", draw opacity=" + plainNumber(stroke.strength, 3);
    body_.append("  \\path[").append(styleNamed(std::string(layer), options)).append("] ");
    body_ += coordinate(onPage(drawing_.page, stroke.path.points.front()));
    forEachDrawnPiece(stroke.path, drawing_.page, [this](std::span<const Point> p) { piece(p); });
    body_.append(stroke.path.isClosed ? " -- cycle;\n" : ";\n");
}

void TikzText::piece(std::span<const Point> piece) {
    const std::string end = coordinate(piece.back());
    if (piece.size() == 2) {
        body_.append(" -- ").append(end);
    } else if (piece.size() == 4) {
        curveTo(coordinate(piece[1]), coordinate(piece[2]), end);
    } else {
        // The cubic that is this parabola: TikZ has no parabolas of two controls.
        constexpr double kTwoThirds = 2.0 / 3;
        curveTo(coordinate(lerp(piece[0], piece[1], kTwoThirds)), coordinate(lerp(piece[2], piece[1], kTwoThirds)),
                end);
    }
}

void TikzText::curveTo(std::string_view firstControl, std::string_view secondControl, std::string_view end) {
    body_.append("\n    .. controls ").append(firstControl).append(" and ").append(secondControl).append(" .. ");
    body_ += end;
}

void TikzText::marks(const Marks& marks, std::string_view layer) {
    const RoleStyle style = styleOf(marks, drawing_.theme);
    if (style.marker == Marker::none || marks.at.empty())
        return;
    std::string options = style.marker == Marker::ring ? "fill=none" : "fill=" + colorText(style.markerFill);
    if (style.markerWidth > 0)
        options += ", draw=" + colorText(style.color) + ", line width=" + bigPoints(style.markerWidth);
    body_.append("  \\path[").append(styleNamed(std::string(layer) + " marks", options)).append("]");
    for (const Point p : marks.at)
        mark(onPage(drawing_.page, p), style);
    body_ += ";\n";
}

void TikzText::mark(Point at, const RoleStyle& style) {
    const std::string half = bigPoints(style.markerSize / 2);
    const std::string side = bigPoints(style.markerSize);
    body_.append("\n    ").append(coordinate(at));
    if (style.marker == Marker::square)
        body_.append(" ++(-" + half + ",-" + half + ") rectangle ++(" + side + "," + side + ")");
    else if (style.marker == Marker::diamond)
        body_.append(" +(-" + half + ",0) -- +(0," + half + ") -- +(" + half + ",0) -- +(0,-" + half + ") -- cycle");
    else
        body_.append(" circle[radius=" + half + "]");
}

void TikzText::label(const PlacedLabel& label, std::string_view layer) {
    constexpr std::string_view kAnchors[] = {"base west", "base", "base east"};
    const std::string style =
        styleNamed(std::string(layer) + " text",
                   "inner sep=0, font=\\footnotesize, text=" + colorText(labelColor(label.role, drawing_.theme)));
    const std::string subscript = label.subscript.empty() ? "" : "_{" + latexFormula(label.subscript) + "}";
    std::string text;
    if (label.isVariable)
        text = "$" + latexFormula(label.text) + subscript + "$";
    else
        text = latexText(label.text) + (subscript.empty() ? "" : "$" + subscript + "$");
    body_.append("  \\node[").append(style).append(", anchor=");
    body_.append(kAnchors[static_cast<std::size_t>(label.anchor)]).append("] at ").append(onTex(label.baseline));
    body_.append(" {").append(text).append(latexText(label.suffix)).append("};\n");
}

} // namespace

std::string writeTikz(const Drawing& drawing, const TextSource& texts, TikzKind kind) {
    TikzText picture(drawing, texts);
    const std::string title = "% " + latexText(drawing.title) + "\n";
    if (kind == TikzKind::fragment)
        return title + std::move(picture).take();
    const std::string encodings = picture.encodingsLine();
    return title + "\\documentclass{standalone}\n" + encodings +
           "\\usepackage[utf8]{inputenc}\n\\usepackage{tikz}\n\\begin{document}\n" + std::move(picture).take() +
           "\\end{document}\n";
}

} // namespace kriva
