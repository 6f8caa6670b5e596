// Schemas with C++ constructs that a schema does not have, and what is said about them: see
// frontend_diagnostics_test.cpp.
#pragma once

#include "frontend_case.h"

namespace physgen::test {

inline const std::vector<DiagnosticCase> constructs_cases = {
    {"a_reference",
     object("Scalar& r;"),
     {"4:3: error: field 'r' is a reference, which an array of objects cannot store; write 'Scalar r;', or an Index "
      "into another array"}},
    {"an_rvalue_reference",
     object("Vector<3>&& r;"),
     {"4:3: error: field 'r' is a reference, which an array of objects cannot store; write 'Vector<3> r;', or an Index "
      "into another array"}},
    {"a_pointer",
     object("Scalar* p;"),
     {"4:3: error: field 'p' is a pointer, which means nothing in another memory space; write an Index into another "
      "array, or the value itself"}},
    {"a_pointer_to_a_function",
     object("void (*p)(int);"),
     {"4:3: error: field 'p' is a pointer, which means nothing in another memory space; write an Index into another "
      "array, or the value itself"}},
    {"a_pointer_to_a_member",
     "struct B;\n" + object("Scalar B::*p;"),
     {"5:3: error: field 'p' is a pointer, which means nothing in another memory space; write an Index into another "
      "array, or the value itself"}},
    {"an_array_of_pointers",
     object("Scalar* p[4];"),
     {"4:3: error: field 'p' is an array of pointers, which mean nothing in another memory space; write 'Index "
      "p[...];'"}},
    {"a_bit_field",
     object("int n : 3;"),
     {"4:11: error: field 'n' is a bit-field, whose bits have no address of their own; write 'int n;'"}},
    {"a_bit_field_of_scalars", object("Scalar s : 3;"), {"4:10: error: bit-field 's' has non-integral type 'Scalar'"}},
    {"a_virtual_function",
     object("Scalar x; virtual void f();"),
     {"4:26: error: virtual function in object 'A'; an object is a record of numbers, remove it"}},
    {"a_virtual_destructor",
     object("Scalar x; virtual ~A();"),
     {"4:21: error: virtual function in object 'A'; an object is a record of numbers, remove it"}},
    {"a_member_function",
     object("Scalar x; int size() const;"),
     {"4:17: error: member function in object 'A'; an object is a record of numbers, write a function beside it that "
      "takes the generated value"}},
    {"a_constructor",
     object("Scalar x; A();"),
     {"4:13: error: member function in object 'A'; an object is a record of numbers, write a function beside it that "
      "takes the generated value"}},
    {"a_member_function_template",
     object("Scalar x; template <class T> void f();"),
     {"4:37: error: member function in object 'A'; an object is a record of numbers, write a function beside it that "
      "takes the generated value"}},
    {"a_static_member",
     object("Scalar x; static const int n = 3;"),
     {"4:30: error: static member in object 'A'; write a constexpr constant beside the object"}},
    {"a_base_class",
     "struct B {};\nstruct PHYSGEN_OBJECT() A : B {\n  Scalar x;\n};\n",
     {"4:29: error: object 'A' has a base class; write a field of the base's type instead"}},
    {"a_virtual_base_class",
     "struct B {};\nstruct PHYSGEN_OBJECT() A : virtual public B {\n  Scalar x;\n};\n",
     {"4:29: error: object 'A' has a base class; write a field of the base's type instead"}},
    {"an_object_that_is_a_union",
     "union PHYSGEN_OBJECT() A {\n  int x;\n  float y;\n};\n",
     {"3:24: error: object 'A' is a union, whose members share memory; write a struct with one field per member"}},
    {"a_field_that_is_a_union",
     "union B {\n  int x;\n};\n" + object("B b;"),
     {"7:3: error: field 'b' is a union, whose members share memory; write one field per member"}},
    {"an_anonymous_union_in_an_object",
     object("union { int x; float y; };"),
     {"4:3: error: anonymous union is defined in object 'A'; write it as an object of its own before this one and nest "
      "it by name"}},
    {"an_anonymous_struct_as_field_type",
     object("struct { Scalar x; } b;"),
     {"4:3: error: anonymous struct is defined in object 'A'; write it as an object of its own before this one and "
      "nest it by name"}},
    {"a_nested_definition",
     object("struct B { Scalar x; }; B b;"),
     {"4:10: error: struct 'B' is defined in object 'A'; write it as an object of its own before this one and nest it "
      "by name"}},
    {"an_enumeration_in_an_object",
     object("enum E { e }; Scalar x;"),
     {"4:8: error: declaration in object 'A' that is not a field; write it beside the object"}},
    {"an_alias_in_an_object",
     object("using T = Scalar; T x;"),
     {"4:9: error: declaration in object 'A' that is not a field; write it beside the object"}},
    {"a_friend",
     object("Scalar x; friend struct B;"),
     {"4:20: error: declaration in object 'A' that is not a field; write it beside the object"}},
    {"private_fields",
     "class PHYSGEN_OBJECT() A {\n  Scalar x;\n};\n",
     {"4:10: error: field 'x' is private, but generated code must reach it; write 'struct' and no 'private:'"}},
    {"protected_fields",
     "struct PHYSGEN_OBJECT() A {\n  Scalar x;\n protected:\n  Scalar y, z;\n};\n",
     {"6:10: error: field 'y' is protected, but generated code must reach it; write 'struct' and no 'protected:'",
      "6:13: error: field 'z' is protected, but generated code must reach it; write 'struct' and no 'protected:'"}},
    {"an_object_that_contains_itself",
     object("Scalar x; A a;"),
     {"4:15: error: field has incomplete type 'A'",
      "3:25: note: definition of 'A' is not complete until the closing '}'",
      "4:15: error: object 'A' contains itself in field 'a'; store an Index of the other object instead"}},
    {"an_object_that_contains_an_array_of_itself",
     object("A a[2];"),
     {"4:5: error: field has incomplete type 'A'",
      "3:25: note: definition of 'A' is not complete until the closing '}'",
      "4:5: error: object 'A' contains itself in field 'a'; store an Index of the other object instead"}},
    {"an_object_used_before_its_declaration",
     "struct B;\n" + object("B b;"),
     {"5:5: error: field has incomplete type 'B'", "3:8: note: forward declaration of 'B'"}},
};

}  // namespace physgen::test
