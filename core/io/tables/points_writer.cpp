#include "core/io/tables/points_writer.h"

#include "core/curve/table.h"
#include "core/io/numbers/typed_number.h"
#include "core/io/tables/table_writer.h"

namespace kriva {

std::string writePointsCsv(const Sheet& sheet, std::optional<std::size_t> curve) {
    Table table{Caption::points,
                {{Caption::none, "curve"}, {Caption::none, "point"}, {Caption::none, "x"}, {Caption::none, "y"}},
                {}};
    for (std::size_t i = 0; i < sheet.curves.size(); ++i) {
        const bool isWanted = curve ? i == *curve : viewOf(sheet.curves[i]).isShown;
        for (int k = 0; isWanted && k < static_cast<int>(pointCount(sheet.curves[i])); ++k) {
            const Point at = pointAt(sheet.curves[i], k);
            table.rows.push_back({{static_cast<int>(i)}, {k}, {at.x}, {at.y}});
        }
    }
    return writeDelimited(table, {}, ',');
}

std::string writePointsTable(std::span<const Point> points, std::string_view decimalSign) {
    std::string text;
    for (const Point p : points) {
        if (!text.empty())
            text += '\n';
        text += writeTypedNumber(p.x, decimalSign) + '\t' + writeTypedNumber(p.y, decimalSign);
    }
    return text;
}

} // namespace kriva
