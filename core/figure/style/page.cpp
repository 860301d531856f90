#include "core/figure/style/page.h"

namespace kriva {
namespace {

double fittingScale(const Box& box, double margin) {
    const double scale = (kPageSide - 2 * margin) / std::max(box.width(), box.height());
    // The smallest boxes (below 1e-306) have no scale within the range of doubles.
    return std::isfinite(scale) ? scale : 1;
}

} // namespace

Page pageOf(const Box& box, std::optional<double> mmPerUnit, double margin) {
    Page page;
    page.box = box.isEmpty() ? Box{0, 0, 0, 0} : box;
    page.margin = margin;
    page.mmPerUnit = mmPerUnit ? *mmPerUnit : fittingScale(page.box, margin);
    page.width = page.box.width() * page.mmPerUnit + 2 * margin;
    page.height = page.box.height() * page.mmPerUnit + 2 * margin;
    return page;
}

Page pageOfWidth(const Box& box, double width, double margin) {
    const double room = width - 2 * margin;
    const double scale = room / box.width();
    const bool hasWidth = !box.isEmpty() && std::isfinite(scale);
    Page page = pageOf(box, hasWidth ? std::optional(scale) : std::nullopt, margin);
    page.width = width;
    if (hasWidth)
        return page;
    const double halfOfRoom = room / 2 / page.mmPerUnit;
    page.box.xmin -= halfOfRoom;
    page.box.xmax += halfOfRoom;
    return page;
}

Point onPage(const Page& page, Point p) {
    // The differences come first: far from the origin they are exact, the scaled coordinates would not be.
    return {page.margin + (p.x - page.box.xmin) * page.mmPerUnit, page.margin + (page.box.ymax - p.y) * page.mmPerUnit};
}

} // namespace kriva
