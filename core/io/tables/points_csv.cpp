#include "core/io/tables/points_csv.h"

#include "core/curve/table.h"
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

} // namespace kriva
