#include "core/curve/limits.h"
#include "core/io/tables/points_reader.h"
#include "core/io/tables/points_writer.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {

using kriva::Points;

bool isWithinTheModel(const std::vector<Points>& curves) {
    std::size_t count = 0;
    for (const Points& points : curves) {
        count += points.size();
        for (const kriva::Point p : points)
            if (!(std::abs(p.x) <= kriva::limits::kNumber && std::abs(p.y) <= kriva::limits::kNumber))
                return false;
        if (points.empty())
            return false;
    }
    return count > 0 && count <= kriva::limits::kPointsInSheet;
}

kriva::Sheet sheetOf(const std::vector<Points>& curves) {
    kriva::Sheet sheet;
    for (const Points& points : curves) {
        kriva::CombinedCurve curve;
        curve.points = points;
        sheet.curves.emplace_back(curve);
    }
    return sheet;
}

} // namespace

// Any bytes are refused at a place of the text or are points within the limits of the model, in curves that are not
// empty; written as Kriva writes them, they read back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto read = kriva::readPointsTable({reinterpret_cast<const char*>(data), size});
    if (const auto* error = std::get_if<kriva::TableError>(&read)) {
        const bool isOfTheWhole = error->problem == kriva::TableProblem::empty;
        if (isOfTheWhole != (error->line == 0) || error->line > static_cast<int>(size) + 1 ||
            error->column > static_cast<int>(size) + 1)
            std::abort();
        return 0;
    }
    const auto& curves = std::get<std::vector<Points>>(read);
    if (!isWithinTheModel(curves))
        std::abort();
    const auto again = kriva::readPointsTable(kriva::writePointsCsv(sheetOf(curves)));
    if (again.index() != 0 || std::get<0>(again) != curves)
        std::abort();
    return 0;
}
