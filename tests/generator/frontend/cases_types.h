// Schemas with field types, sizes and whole objects that cannot be, and what is said about them: see
// diagnostics_test.cpp.
#pragma once

#include "case.h"

namespace physgen::test {

inline const std::vector<DiagnosticCase> types_cases = {
    {"a_vector_of_zero_elements",
     object("Vector<0> v;"),
     {"4:3: error: field 'v' has the type Vector<0>, which stores nothing; sizes must be at least 1"}},
    {"a_vector_of_negative_size",
     object("Vector<-3> v;"),
     {"4:3: error: field 'v' has the type Vector<-3>, which stores nothing; sizes must be at least 1"}},
    {"a_matrix_of_zero_columns",
     object("Matrix<3, 0> m;"),
     {"4:3: error: field 'm' has the type Matrix<3, 0>, which stores nothing; sizes must be at least 1"}},
    {"a_symmetric_matrix_of_size_zero",
     object("Symmetric<0> s;"),
     {"4:3: error: field 's' has the type Symmetric<0>, which stores nothing; sizes must be at least 1"}},
    {"a_skew_matrix_of_size_one",
     object("Skew<1> s;"),
     {"4:3: error: field 's' has the type Skew<1>, which stores nothing; a skew-symmetric matrix has at least size 2"}},
    {"a_vector_that_is_too_long",
     object("Vector<1025> v;"),
     {"4:3: error: field 'v' has the type Vector<1025>, whose sizes must be from 1 to 1024; keep larger matrices in "
      "objects of blocks"}},
    {"a_matrix_too_large_for_the_stack",
     object("Matrix<200, 200> m;"),
     {"4:3: error: field 'm' has the type Matrix<200, 200>, whose value takes 320000 bytes in double, and Eigen keeps "
      "no "
      "more than 131072 on the stack; write blocks, such as 'Matrix<64, 64> m[...]'"}},
    {"an_array_of_zero_entries",
     object("Scalar x[0];"),
     {"4:3: error: field 'x' is an array of no entries; write an extent of at least 1, or remove it"}},
    {"an_array_of_unknown_extent",
     object("Scalar x[];"),
     {"4:3: error: field 'x' is an array without a fixed extent; write the number of entries, such as 'x[4]', or keep "
      "a varying number in an array of objects of their own"}},
    {"an_array_that_is_too_long",
     object("Scalar x[65537];"),
     {"4:3: error: array 'x' has an extent outside 1 to 65536; keep large or varying numbers of entries in an array of "
      "objects of their own"}},
    {"an_array_longer_than_an_int_can_say",
     object("Scalar x[5000000000];"),
     {"4:3: error: array 'x' has an extent outside 1 to 65536; keep large or varying numbers of entries in an array of "
      "objects of their own"}},
    {"an_array_of_arrays",
     object("Scalar x[2][3];"),
     {"4:3: error: field 'x' is an array of arrays; write 'Matrix<R, C> x;' or one array of the product of the "
      "extents"}},
    {"an_array_of_arrays_behind_an_alias",
     "using Row = Scalar[3];\n" + object("Row x[2];"),
     {"5:3: error: field 'x' is an array of arrays; write 'Matrix<R, C> x;' or one array of the product of the "
      "extents"}},
    {"too_many_elements_in_one_object",
     object("Matrix<128, 128> m[64]; Scalar x;"),
     {"3:25: error: object 'A' has more than 1048576 elements; split it, or keep its large parts in arrays of objects "
      "of their own"}},
    {"an_object_without_fields",
     "struct PHYSGEN_OBJECT() A {};\n",
     {"3:25: error: object 'A' has no fields; declare at least one, such as 'Scalar x;'"}},
    {"an_object_declared_twice",
     "struct PHYSGEN_OBJECT() A {\n  Scalar x;\n};\nstruct PHYSGEN_OBJECT() A {\n  Scalar y;\n};\n",
     {"6:25: error: redefinition of 'A'", "3:25: note: previous definition is here"}},
    {"a_field_declared_twice",
     object("Scalar x, x;"),
     {"4:13: error: duplicate member 'x'", "4:10: note: previous declaration is here"}},
    {"an_object_that_is_a_template",
     "template <class T>\n" + object("T x;"),
     {"4:25: error: object 'A' is a template, and the generator needs its sizes; write a struct for each set of "
      "arguments"}},
    {"a_specialization_of_a_template",
     "template <class T>\nstruct A;\ntemplate <>\nstruct PHYSGEN_OBJECT() A<int> {\n  Scalar x;\n};\n",
     {"6:25: error: object 'A' is a specialization of a template; write a struct"}},
    {"a_field_whose_type_is_a_template",
     "template <class T>\nstruct B {\n  T x;\n};\n" + object("B<Scalar> b;"),
     {"8:3: error: field 'b' has a template as its type, which a schema does not have; write a struct with "
      "PHYSGEN_OBJECT()"}},
    {"an_object_without_a_name",
     "struct PHYSGEN_OBJECT() {\n  Scalar x;\n} variable;\n",
     {"3:1: error: an object needs a name, which the generated classes get; write 'struct PHYSGEN_OBJECT() Name'"}},
    {"an_object_in_an_anonymous_namespace",
     "namespace {\nstruct PHYSGEN_OBJECT() A {\n  Scalar x;\n};\n}\n",
     {"4:25: error: object 'A' is in an anonymous namespace, where generated code cannot name it; give the namespace a "
      "name"}},
    {"a_field_without_a_name",
     object("Scalar x; int : 0;"),
     {"4:17: error: field without a name; write one, or remove it"}},
    {"a_const_field",
     object("const Scalar x;"),
     {"4:9: error: field 'x' is const, but whether an element may be written is the kernel's choice; write 'Scalar "
      "x;'"}},
    {"a_const_array",
     object("const Scalar x[2];"),
     {"4:9: error: field 'x' is const, but whether an element may be written is the kernel's choice; write 'Scalar "
      "x;'"}},
    {"a_volatile_field",
     object("volatile Vector<3> x;"),
     {"4:12: error: field 'x' is volatile, but whether an element may be written is the kernel's choice; write "
      "'Vector<3> x;'"}},
    {"a_mutable_field",
     object("mutable Scalar x;"),
     {"4:11: error: field 'x' is mutable, but whether an element may be written is the kernel's choice; write 'Scalar "
      "x;'"}},
    {"an_unsigned_field",
     object("unsigned x;"),
     {"4:3: error: field 'x' has the type 'unsigned int', which a schema does not have; write Index, int, "
      "std::int64_t, "
      "std::uint64_t or bool"}},
    {"a_long_double_field",
     object("long double x;"),
     {"4:3: error: field 'x' has the type 'long double', which a schema does not have; write Scalar, float or double"}},
    {"a_char_field",
     object("char x;"),
     {"4:3: error: field 'x' has the type 'char', which a schema does not have; write Index, int, std::int64_t, "
      "std::uint64_t or bool"}},
    {"a_short_field",
     object("short x;"),
     {"4:3: error: field 'x' has the type 'short', which a schema does not have; write Index, int, std::int64_t, "
      "std::uint64_t or bool"}},
    {"an_integer_of_128_bits",
     object("__int128 x;"),
     {"4:3: error: field 'x' has the type '__int128', which a schema does not have; write Index, int, std::int64_t, "
      "std::uint64_t or bool"}},
    {"a_skew_matrix_of_bool",
     object("Skew<3, bool> x;"),
     {"4:3: error: field 'x' has the type Skew<3>, half of whose entries are the negatives of stored ones, which "
      "bool does not have; write a Matrix"}},
    {"a_skew_matrix_of_unsigned_integers",
     object("Skew<3, unsigned long> x;"),
     {"4:3: error: field 'x' has the type Skew<3>, half of whose entries are the negatives of stored ones, "
      "which std::uint64_t does not have; write a Matrix"}},
    {"an_enumeration_as_field_type",
     "enum class Kind { soft, hard };\n" + object("Kind kind;"),
     {"5:3: error: field 'kind' has the type 'Kind', which a schema does not have; write Index and keep the "
      "enumeration for the values"}},
    {"a_complex_field",
     object("_Complex float z;"),
     {"4:12: error: field 'z' has the type '_Complex float', which a schema does not have; write Scalar, Vector<N>, "
      "Matrix<R, C>, Symmetric<N>, Diagonal<N>, Skew<N>, Rotation, Index, float, double, int, std::int64_t, "
      "std::uint64_t, bool or an object"}},
    {"elements_of_an_unsupported_type",
     object("Vector<3, unsigned> v;"),
     {"4:3: error: field 'v' has elements of type 'unsigned int'; write one of Scalar, Index, float, double, int, "
      "std::int64_t, std::uint64_t and bool"}},
    {"elements_that_are_const",
     object("Matrix<3, 3, const float> m;"),
     {"4:3: error: field 'm' has elements of type 'const float'; write one of Scalar, Index, float, double, int, "
      "std::int64_t, std::uint64_t and bool"}},
    {"an_option_type_as_field_type",
     object("detail::Range r;"),
     {"4:3: error: field 'r' has the type 'Range', which is an option and not a field type; write Scalar, Vector<N>, "
      "Matrix<R, C>, Symmetric<N>, Diagonal<N>, Skew<N>, Rotation, Index, float, double, int, std::int64_t, "
      "std::uint64_t, bool or an object"}},
    {"a_struct_that_is_not_an_object_as_field_type",
     "struct B {\n  Scalar x;\n};\n" + object("B b;"),
     {"7:3: error: field 'b' has the type 'B', which is not an object; write 'struct PHYSGEN_OBJECT() B'",
      "3:8: note: 'B' is declared here"}},
    {"a_cpp_initializer",
     object("int n = 3;"),
     {"4:11: error: field 'n' has a C++ initializer; write PHYSGEN(initial(...)) before its type"}},
    {"alignas_on_a_field",
     object("alignas(16) Scalar x;"),
     {"4:3: error: field 'x' has an alignment, which is the layout's choice; remove alignas, or write "
      "PHYSGEN_OBJECT(align(...)) for the whole record"}},
    {"alignas_on_an_object",
     "struct alignas(16) PHYSGEN_OBJECT() A {\n  Scalar x;\n};\n",
     {"3:8: error: alignas has no effect on generated records; write PHYSGEN_OBJECT(align(...))"}},
    {"a_packed_object",
     "struct __attribute__((packed)) PHYSGEN_OBJECT() A {\n  Scalar x;\n};\n",
     {"3:23: error: generated records have no gaps to pack; remove the attribute"}},
};

}  // namespace physgen::test
