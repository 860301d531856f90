#pragma once

namespace kriva {

/// How far a result may be from the exact one: a distance in document units, never squared.
struct Tolerance {
    double distance = 0;
};

} // namespace kriva
