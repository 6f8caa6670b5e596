// Schemas whose options state numbers that C++ changes on their way, and what is said about them: see
// diagnostics_test.cpp.
#pragma once

#include "case.h"

namespace physgen::test {

inline const std::vector<DiagnosticCase> numbers_cases = {
    {"a_division_of_integers_that_drops_its_remainder",
     object("PHYSGEN(range(0, 2 / 3), initial(1 / 2)) Scalar x;"),
     {"4:20: error: this integer division gives 0 and drops the remainder; write 2.0 / 3, or 0 if that is meant",
      "4:36: error: this integer division gives 0 and drops the remainder; write 1.0 / 2, or 0 if that is meant"}},
    {"such_a_division_in_a_constant_and_in_a_macro",
     "#define HALF 1 / 2\nconstexpr double third = 1 / 3;\n" +
         object("PHYSGEN(range(0, third), initial(HALF)) Scalar x;"),
     {"4:26: error: this integer division gives 0 and drops the remainder; write 1.0 / 3, or 0 if that is meant",
      "6:36: error: this integer division gives 0 and drops the remainder; write 1.0 / 2, or 0 if that is meant"}},
    {"once_of_a_constant_that_two_options_name",
     "constexpr double third = 1 / 3;\n" +
         object("PHYSGEN(range(0, third)) Scalar x;\n  PHYSGEN(range(0, third)) Scalar y;"),
     {"3:26: error: this integer division gives 0 and drops the remainder; write 1.0 / 3, or 0 if that is meant"}},
    {"an_alignment_and_a_tile_that_are_no_integers",
     "struct PHYSGEN_OBJECT(align(8.5), layout(host, aosoa(16.5))) A {\n  Scalar x;\n};\n",
     {"3:29: error: 8.5 becomes 8 in the type 'int'; write a number that it can hold",
      "3:54: error: 16.5 becomes 16 in the type 'int'; write a number that it can hold"}},
    {"an_alignment_of_more_than_32_bits",
     "struct PHYSGEN_OBJECT(align(4294967312)) A {\n  Scalar x;\n};\n",
     {"3:29: error: 4294967312 becomes 16 in the type 'int'; write a number that it can hold"}},
    {"an_integer_that_no_double_holds",
     object("PHYSGEN(initial(9007199254740993)) double x;"),
     {"4:19: error: 9007199254740993 becomes 9007199254740992 in the type 'double'; write a number that it can hold"}},
    {"a_negative_number_that_becomes_unsigned",
     object("PHYSGEN(initial(-1 * 2U)) double x;"),
     {"4:19: error: -1 becomes 4294967295 in the type 'unsigned int'; write a number that it can hold"}},
};

}  // namespace physgen::test
