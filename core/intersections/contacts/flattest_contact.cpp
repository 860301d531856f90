#include "core/intersections/contacts/flattest_contact.h"

#include "core/intersections/contacts/passages.h"

#include <cmath>

namespace kriva {
namespace {

/// The first coefficients of a power series; products are cut off.
using Series = std::array<double, Arc::kMostDegree + 1>;

Series product(const Series& a, const Series& b) {
    Series result{};
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; i + j < b.size(); ++j)
            result[i + j] += a[i] * b[j];
    return result;
}

Series composed(const Series& outer, const Series& inner) {
    Series result{};
    for (std::size_t k = outer.size(); k-- > 0;) {
        result = product(result, inner);
        result[0] += outer[k];
    }
    return result;
}

/// One coordinate, seen along a direction, as a series around t.
Series seriesAt(const Arc& arc, double t, Point origin, Vector direction) {
    Series differences{};
    for (std::size_t i = 0; i <= arc.degree; ++i)
        differences[i] = dot(direction, arc.points[i] - origin);
    Series series{};
    double binomial = 1;
    for (std::size_t k = 0; k <= arc.degree; ++k) {
        series[k] = binomial * differences[0];
        for (std::size_t i = 0; i + k < arc.degree; ++i)
            differences[i] = differences[i + 1] - differences[i];
        binomial = binomial * static_cast<double>(arc.degree - k) / static_cast<double>(k + 1);
    }
    // Horner's scheme again and again moves the centre to t.
    for (std::size_t k = 0; k < arc.degree; ++k)
        for (std::size_t i = arc.degree; i-- > k;)
            series[i] += t * series[i + 1];
    return series;
}

/// The gap between two arcs as a series in the parameter of a, around two places beside each other.
std::optional<Series> gapSeries(const Arc& a, const Arc& b, Contact near) {
    const ArcPoint start = evaluate(a, near.a);
    const double speed = length(start.velocity);
    if (speed == 0)
        return {};
    const Vector along = start.velocity / speed;
    const Vector aside{-along.y, along.x};
    const Series xa = seriesAt(a, near.a, start.at, along);
    const Series xb = seriesAt(b, near.b, start.at, along);
    if (std::abs(xb[1]) <= 1e-6 * speed)
        return {};
    // The parameter of b at the same x: each round settles one more coefficient, the first ones the offset.
    Series tb{};
    for (std::size_t round = 0; round < tb.size() + 2; ++round) {
        const Series there = composed(xb, tb);
        for (std::size_t k = 0; k < tb.size(); ++k)
            tb[k] -= (there[k] - xa[k]) / xb[1];
    }
    Series gap = composed(seriesAt(b, near.b, start.at, aside), tb);
    const Series ya = seriesAt(a, near.a, start.at, aside);
    for (std::size_t k = 0; k < gap.size(); ++k)
        gap[k] -= ya[k];
    return gap;
}

} // namespace

Contact flattestContact(const Arc& a, const Arc& b, Contact near, double reach) {
    near.b = foot(b, evaluate(a, near.a).at, near.b);
    Contact contact = near;
    for (int step = 0; step < 4; ++step) {
        const std::optional<Series> gap = gapSeries(a, b, contact);
        if (!gap)
            break;
        std::size_t order = 1;
        for (std::size_t k = 2; k < gap->size(); ++k)
            if (std::abs((*gap)[k]) * std::pow(reach, k) > std::abs((*gap)[order]) * std::pow(reach, order))
                order = k;
        if ((*gap)[order] == 0)
            break;
        const double way = -(*gap)[order - 1] / (static_cast<double>(order) * (*gap)[order]);
        contact.a = std::clamp(contact.a + std::clamp(way, -reach, reach), 0.0, 1.0);
        contact.b = foot(b, evaluate(a, contact.a).at, contact.b);
    }
    // Beyond the end of a segment there is nothing to be flat against.
    return gapAt(a, b, contact) <= gapAt(a, b, near) ? contact : near;
}

} // namespace kriva
