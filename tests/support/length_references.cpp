// Writes the lengths of a data set that arc_length_test compares with, one a line, worked out in quadruple precision:
//
//   length_references cubics > tests/data/lengths/cubics.txt
//   length_references cusps > tests/data/lengths/cusps.txt

#include "tests/support/data_sets.h"
#include "tests/support/reference_length.h"

#include <array>
#include <charconv>
#include <iostream>
#include <string_view>

int main(int argc, char** argv) {
    using namespace kriva;
    const std::string_view name = argc == 2 ? argv[1] : "";
    if (name != "cubics" && name != "cusps") {
        std::cerr << "usage: length_references cubics | cusps\n";
        return 1;
    }
    __extension__ using Quadruple = __float128;
    const test::ReferenceLength<Quadruple> lengthOf(1e-20);
    for (const Points& cubic : name == "cubics" ? test::randomCubics() : test::nearCusps()) {
        std::array<char, 32> text{};
        const auto end = std::to_chars(text.begin(), text.end(), lengthOf(cubic)).ptr;
        std::cout << std::string_view(text.data(), end) << '\n';
    }
}
