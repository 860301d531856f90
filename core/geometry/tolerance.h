#pragma once

namespace kriva {

/// How far a result may be from the exact one: a distance in document units, never squared.
struct Tolerance {
    double distance = 0;
};

/// A change by this part of a figure's size is rounding: for a person, none.
inline constexpr double kRoundingPart = 1e-12;

} // namespace kriva
