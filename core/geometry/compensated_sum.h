#pragma once

#include <cmath>

namespace kriva {

/// Adds any number of terms with the error of a few additions, where a plain loop gathers one rounding per term: a
/// hundred thousand equal terms then lose 1e-12 of their sum.
/// Source: Neumaier, Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, ZAMM 54 (1974).
class CompensatedSum {
  public:
    void add(double term) {
        const double total = sum_ + term;
        lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - total) + term : (term - total) + sum_;
        sum_ = total;
    }
    [[nodiscard]] double value() const { return sum_ + lost_; }

  private:
    double sum_ = 0;
    double lost_ = 0;
};

} // namespace kriva
