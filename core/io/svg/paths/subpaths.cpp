#include "core/io/svg/paths/subpaths.h"

#include <utility>

namespace kriva {

void Subpaths::moveTo(Point to) {
    finish();
    start_ = at_ = to;
}

void Subpaths::arcTo(const EllipticalArc& arc, Point to) {
    if (isLine(arc))
        return lineTo(to);
    for (const auto& cubic : cubicsOf(arc, at_, to))
        cubicTo(cubic[1], cubic[2], cubic[3]);
}

void Subpaths::close() {
    if (at_ != start_)
        lineTo(start_);
    open_.isClosed = true;
    finish();
    at_ = start_;
}

void Subpaths::add(std::initializer_list<Point> further) {
    if (open_.points.empty())
        open_.points.push_back(at_);
    open_.points.insert(open_.points.end(), further);
    open_.degrees.push_back(static_cast<int>(further.size()));
    at_ = open_.points.back();
    ++pieces_;
}

void Subpaths::finish() {
    if (!open_.degrees.empty())
        done_.push_back(std::move(open_));
    open_ = {};
}

std::vector<Path> Subpaths::take() && {
    finish();
    return std::move(done_);
}

} // namespace kriva
