#pragma once

#include "core/bezier/measures/hodograph_factors.h"

#include <optional>

namespace kriva {

/// An interval around the real part a of a zero a + ib of c that is next to [0, 1], where |c| nearly has a kink, as
/// t = a + b/2 C(C(..C(z))) with C(z) = z^3 + 3 z and -top <= z <= top. As C(z)^2 + 4 = (z^2 + 1)^2 (z^2 + 4), what was
/// a singularity at +-ib in t is one at +-2i in z alone, however small b is, and the rest of it is a polynomial: a
/// single Gauss rule in z integrates |c|.
///
/// The substitution is a sinh, 2 sinh(3 u) = C(2 sinh u), after Johnston, Elliott, A sinh transformation for evaluating
/// nearly singular boundary element integrals, Int. J. Numer. Meth. Eng. 62 (2005).
struct CuspWindow {
    double middle = 0;    ///< a
    double imaginary = 0; ///< b
    double top = 0;
    int depth = 0;        ///< how often C is applied
    double halfWidth = 0; ///< in t
    std::size_t rule = 0; ///< index into CentredRule::kSizes
    double error = 0;     ///< a bound of that rule's
};

/// C^depth(z), and the slope times its derivative.
template <class Number>
[[gnu::always_inline]] inline void substitute(int depth, Number& z, Number& slope) {
    for (int i = 0; i < depth; ++i) {
        const Number square = z * z;
        slope *= 3.0 * square + 3.0;
        z *= square + 3.0;
    }
}

/// The window inside (0, 1) around a zero of c with an error of at most `error`; nothing where none of them is so near
/// that halving the interval towards it would take longer.
[[nodiscard]] std::optional<CuspWindow> cuspWindow(const HodographFactors& factors, double error);

} // namespace kriva
