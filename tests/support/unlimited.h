#pragma once

#include "core/budget/work_budget.h"

namespace kriva::test {

// What takes a budget, for tests that set no limit.

template <class C>
[[nodiscard]] auto plotsOf(const C& curve) {
    return withoutLimit([&](WorkBudget& budget) { return plotsOf(curve, budget); });
}

template <class C>
[[nodiscard]] auto tablesOf(const C& curve) {
    return withoutLimit([&](WorkBudget& budget) { return tablesOf(curve, budget); });
}

template <class C>
[[nodiscard]] auto compareMethods(const C& curve) {
    return withoutLimit([&](WorkBudget& budget) { return compareMethods(curve, budget); });
}

} // namespace kriva::test
