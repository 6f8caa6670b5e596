"""What another precision of a scene finds in place of what float finds: these do something on the side in double alone."""
D = "static double n = 0; return x + (n += 1);"
LAWS = "struct KS { template <class T> T read(T x) const { return x; } };\nstruct KD { template <class T> T read(T x) const { static T n = 0; return x + (n += 1); } };\n"


def laws(name, head, text):
    """A part with two classes, of which the second does something when it reads: KS and KD, where K is the name's."""
    return name, (LAWS + head).replace("KS", f"{name}_S").replace("KD", f"{name}_D").replace("K_", f"{name}_"), text.replace("K_", f"{name}_")


# What another precision finds: operators, overloads, calls of a library, classes, and members that are specialised for it.
CHOSEN_IN_DOUBLE = [
    laws("specialisedbase", "template <class T> struct K_Is : KS {};\ntemplate <> struct K_Is<double> : KD {};", "v = K_Is<Scalar>().read(v);"),
    laws("specialisedfield", "template <class T> struct K_Has { KS law; };\ntemplate <> struct K_Has<double> { KD law; };", "v = K_Has<Scalar>().law.read(v);"),
    laws("partialbase", "template <class T, class U> struct K_Is : KS {};\ntemplate <class U> struct K_Is<double, U> : KD {};", "v = K_Is<Scalar, int>().read(v);"),
    laws("specialisedfunction", "template <class T> struct K_Law { T read(T x) const { return x; } };\n"
         "template <> inline double K_Law<double>::read(double x) const { " + D + " }", "v = K_Law<Scalar>().read(v);"),
    laws("specialisedstatic", "template <class T> struct K_Law { static T read(T x) { return x; } };\n"
         "template <> inline double K_Law<double>::read(double x) { " + D + " }", "v = K_Law<Scalar>::read(v);"),
    laws("specialisedmethod", "struct K_Law { template <class T> T read(T x) const { return x; } };\n"
         "template <> inline double K_Law::read(double x) const { " + D + " }", "v = K_Law().read(v);"),
    laws("specialisedconstructor", "template <class T> struct K_Made { T n; K_Made(T x) : n(x) {} };\n"
         "template <> inline K_Made<double>::K_Made(double x) : n(x) { static double m = 0; n += m += 1; }", "v = K_Made<Scalar>(v).n;"),
    laws("specialisedinner", "template <class T> struct K_Outer { struct Inner { T read(T x) const { return x; } }; Inner inner() const { return {}; } };\n"
         "template <> struct K_Outer<double>::Inner { double read(double x) const { " + D + " } };", "v = K_Outer<Scalar>().inner().read(v);"),
    laws("specialisedinnerfield", "template <class T> struct K_Outer { struct Inner { KS law; }; Inner inner() const { return {}; } };\n"
         "template <> struct K_Outer<double>::Inner { KD law; };", "v = K_Outer<Scalar>().inner().law.read(v);"),
    laws("specialisedinnertemplate", "template <class T> struct K_Outer { template <class U> struct In : KS {}; In<int> in() const { return {}; } };\n"
         "template <> template <class U> struct K_Outer<double>::In : KD {};", "v = K_Outer<Scalar>().in().read(v);"),
    laws("specialisedmembervariable", "struct K_Laws { template <class T> static constexpr KS law{}; };\n"
         "template <> inline constexpr KD K_Laws::law<double>{};", "v = K_Laws::law<Scalar>.read(v);"),
    laws("specialisedinlibrary", "namespace Eigen::internal {\ntemplate <> struct scalar_min_op<double, double, 0> : binary_op_base<double, double> {\n"
         "  double operator()(double a, double) const { static double n = 0; return a + (n += 1); }\n};\n}",
         "const Eigen::Matrix<Scalar, 1, 1> a(v);\nv += a.cwiseMin(a).sum();"),
    laws("guides", "template <class L> struct K_Box { L law; K_Box(float) {} K_Box(double) {} };\nK_Box(float) -> K_Box<KS>;\nK_Box(double) -> K_Box<KD>;",
         "const K_Box b(v);\nv = b.law.read(v);"),
    laws("decltypeofcall", "KS K_of(float);\nKD K_of(double);", "const decltype(K_of(Scalar())) law{};\nv = law.read(v);"),
    laws("decltypeinfunction", "KS K_of(float);\nKD K_of(double);\ntemplate <class T> T K_read(T x) { decltype(K_of(x)) law{}; return law.read(x); }", "v = K_read(v);"),
    laws("invokeresult", "struct K_Of { KS operator()(float) const; KD operator()(double) const; };",
         "const std::invoke_result_t<K_Of, Scalar> law{};\nv = law.read(v);"),
    laws("commontype", "struct K_X {};\ntemplate <> struct std::common_type<float, K_X> { using type = KS; };\n"
         "template <> struct std::common_type<double, K_X> { using type = KD; };", "const std::common_type_t<Scalar, K_X> law{};\nv = law.read(v);"),
    laws("libraryoperator", "namespace Eigen { inline Matrix<double, 2, 1> operator*(const Matrix<double, 2, 1>& a, double b) {\n"
         "  static double n = 0; return {a(0) * b + (n += 1), a(1)}; } }", "const Eigen::Matrix<Scalar, 2, 1> a(v, v);\nv += (a * Scalar(2))(0);"),
    laws("libraryfunction", "namespace Eigen { inline Array<double, 2, 1> sqrt(const Array<double, 2, 1>& a) {\n"
         "  static double n = 0; return {a(0) + (n += 1), a(1)}; } }", "const Eigen::Array<Scalar, 2, 1> a(v, v);\nv += sqrt(a)(0);"),
    laws("libraryintag", "namespace K_space { struct Tag { bool operator<(Tag) const { return false; } };\n"
         "inline std::pair<double, Tag> max(const std::pair<double, Tag>& a, const std::pair<double, Tag>&) { static double n = 0; return {a.first + (n += 1), {}}; } }",
         "const std::pair<Scalar, K_space::Tag> a(v, {});\nusing std::max;\nv = max(a, a).first;"),
    laws("methodorfree", "namespace K_space {\nstruct K_P { float x; float operator+(float y) const { return x + y; } };\n"
         "inline double operator+(const K_P& p, double y) { static double n = 0; return p.x + y + (n += 1); }\n}", "v = K_space::K_P{1} + v;"),
    laws("freeormethod", "namespace K_space {\nstruct K_P { float x; double operator+(double y) const { static double n = 0; return x + y + (n += 1); } };\n"
         "inline float operator+(const K_P& p, float y) { return p.x + y; }\n}", "v = K_space::K_P{1} + v;"),
    laws("friends", "namespace K_space {\nstruct K_P { float x; friend float operator+(K_P p, float y) { return p.x + y; }\n"
         "  friend double operator+(K_P p, double y) { static double n = 0; return p.x + y + (n += 1); } };\n}", "v = K_space::K_P{1} + v;"),
    laws("friendfunctions", "struct K_P { float x; friend float K_read(K_P p, float y) { return p.x + y; }\n"
         "  friend double K_read(K_P p, double y) { static double n = 0; return p.x + y + (n += 1); } };", "v = K_read(K_P{1}, v);"),
    laws("builtinoperator", "namespace K_space {\nstruct K_P { float x; operator float() const { return x; } };\ntemplate <class T> requires(sizeof(T) == 8)\n"
         "T operator+(K_P p, T y) { static T n = 0; return p.x + y + (n += 1); }\n}", "v = K_space::K_P{1} + v;"),
    laws("enumoperator", "namespace K_space {\nenum K_E { K_one = 1 };\ntemplate <class T> requires(sizeof(T) == 8)\n"
         "T operator+(K_E p, T y) { static T n = 0; return int(p) + y + (n += 1); }\n}", "v = K_space::K_one + v;"),
    laws("defaultofargument", "inline float K_by(float) { return 1; }\ninline double K_by(double x) { " + D + " }\ntemplate <class T> T K_read(T x, T y = K_by(T(1))) { return x + y; }",
         "v = K_read(v);"),
    laws("initialiser", "inline float K_by(float) { return 1; }\ninline double K_by(double x) { " + D + " }\ntemplate <class T> struct K_Begun { T n = K_by(T(1)); };",
         "v += K_Begun<Scalar>().n;"),
    laws("unaryoperator", "namespace K_space {\ntemplate <class T> struct K_V { T x; };\ninline float operator-(K_V<float> p) { return -p.x; }\n"
         "inline double operator-(K_V<double> p) { static double n = 0; return p.x + (n += 1); }\n}", "v = -K_space::K_V<Scalar>{v};"),
]
