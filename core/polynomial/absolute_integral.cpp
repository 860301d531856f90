#include "core/polynomial/absolute_integral.h"

#include "core/polynomial/casteljau.h"

#include <cmath>
#include <utility>

namespace kriva {
namespace {

constexpr double kRelativeError = 1e-11;
constexpr int kMostHalvings = 60; // roots closer than 2^-60 of a piece are one to doubles

struct Enclosed {
    BernsteinPiece piece;
    double lower = 0;
    double upper = 0;

    [[nodiscard]] double gap() const { return upper - lower; }
};

Enclosed enclose(BernsteinPiece piece) {
    double sum = 0;
    double absolute = 0;
    for (const double c : piece.coefficients) {
        sum += c;
        absolute += std::abs(c);
    }
    const double scale = piece.width / static_cast<double>(piece.coefficients.size());
    return {std::move(piece), std::abs(sum) * scale, absolute * scale};
}

/// Leaves the right half in the piece and returns the left one.
BernsteinPiece cutLeftHalf(BernsteinPiece& piece) {
    piece.width /= 2;
    BernsteinPiece left{std::vector<double>(piece.coefficients.size()), piece.width};
    splitInPlace<double>(piece.coefficients, left.coefficients, 0.5);
    return left;
}

} // namespace

double absoluteIntegral(std::vector<BernsteinPiece> pieces) {
    double known = 0; // of pieces on which f keeps its sign
    std::vector<Enclosed> open;
    const auto add = [&](std::vector<Enclosed>& list, BernsteinPiece piece) {
        Enclosed enclosed = enclose(std::move(piece));
        if (enclosed.gap() == 0)
            known += enclosed.lower;
        else
            list.push_back(std::move(enclosed));
    };
    for (BernsteinPiece& piece : pieces)
        add(open, std::move(piece));
    for (int round = 0;; ++round) {
        double lower = known;
        double gap = 0;
        for (const Enclosed& enclosed : open) {
            lower += enclosed.lower;
            gap += enclosed.gap();
        }
        if (round == kMostHalvings || !(gap > kRelativeError * lower))
            return lower + gap / 2;
        std::vector<Enclosed> next;
        for (Enclosed& enclosed : open) {
            if (enclosed.gap() * static_cast<double>(open.size()) <= kRelativeError * lower / 2) {
                next.push_back(std::move(enclosed));
                continue;
            }
            add(next, cutLeftHalf(enclosed.piece));
            add(next, std::move(enclosed.piece));
        }
        open = std::move(next);
    }
}

} // namespace kriva
