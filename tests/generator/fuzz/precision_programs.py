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
    ("operatoramonglibrarys", "namespace Eigen { inline Matrix<double, 2, 1> operator*(const Matrix<double, 2, 1>& a, const Matrix<double, 1, 1>& b) {\n"
     "  static double n = 0; return Matrix<double, 2, 1>(a(0) * b(0) + (n += 1), 0);\n} }",
     "const Eigen::Matrix<Scalar, 2, 1> a(v, 1);\nconst Eigen::Matrix<Scalar, 1, 1> b(2);\nv = Eigen::Matrix<Scalar, 2, 1>(a * b)(0);"),
    ("negatesindouble", "namespace Eigen { inline Matrix<double, 2, 1> operator-(const Matrix<double, 2, 1>& a) {\n"
     "  static double n = 0; return Matrix<double, 2, 1>((n += 1) - a(0), 0);\n} }",
     "const Eigen::Matrix<Scalar, 2, 1> a(v, 1);\nv = Eigen::Matrix<Scalar, 2, 1>(-a)(0);"),
    ("compoundoperator", "namespace Eigen { inline Matrix<double, 2, 1>& operator+=(Matrix<double, 2, 1>& a, const Matrix<double, 2, 1>& b) {\n"
     "  static double n = 0; a(0) += b(0) + (n += 1); return a;\n} }",
     "Eigen::Matrix<Scalar, 2, 1> a(v, 1);\na += Eigen::Matrix<Scalar, 2, 1>(1, 1);\nv = a(0);"),
    ("functionamonglibrarys", "namespace Eigen { inline Matrix<double, 2, 1> abs(const Matrix<double, 2, 1>& a) {\n"
     "  static double n = 0; return Matrix<double, 2, 1>((n += 1) + a(0), 0);\n}\ninline Matrix<float, 2, 1> abs(const Matrix<float, 2, 1>& a) { return a; } }",
     "v = Eigen::Matrix<Scalar, 2, 1>(abs(Eigen::Matrix<Scalar, 2, 1>(v, 1)))(0);"),
    ("comparedoperator", "namespace Eigen { inline bool operator==(const Matrix<double, 2, 1>& a, const Matrix<double, 2, 1>& b) {\n"
     "  static int n = 0; return a(0) + b(0) > (n += 1);\n} }",
     "const Eigen::Matrix<Scalar, 2, 1> a(v, 1), b(v, 1);\nv += a == b ? 1 : 2;"),
    ("swapamonglibrarys", "namespace Eigen { inline void swap(Matrix<double, 2, 1>& a, Matrix<double, 2, 1>& b) {\n"
     "  static double n = 0; a(0) = b(0) + (n += 1);\n}\ninline void swap(Matrix<float, 2, 1>& a, Matrix<float, 2, 1>& b) { a(0) = b(0); } }",
     "Eigen::Matrix<Scalar, 2, 1> a(v, 1), b(2, 1);\nswap(a, b);\nv = a(0);"),
    ("memberindouble", "template <class T>\nstruct KaMember { static T next(T x) { return x; } };\n"
     "template <>\ninline double KaMember<double>::next(double x) { static double n = 0; return x + (n += 1); }", "v = KaMember<Scalar>::next(v);"),
    ("madeindouble", "template <class T>\nstruct KbMade { T n; KbMade(T x) : n(x) {} };\n"
     "template <>\ninline KbMade<double>::KbMade(double x) : n(x) { static double m = 0; n += m += 1; }", "v = KbMade<Scalar>(v).n;"),
    ("specialisedconversion", "template <class T>\nstruct KcGives { T n; operator T() const { return n; } };\n"
     "template <>\ninline KcGives<double>::operator double() const { static double m = 0; return n + (m += 1); }", "v = KcGives<Scalar>{v};"),
    ("innerindouble", "template <class T>\nstruct KdOuter { struct Inner { static T next(T x) { return x; } }; };\n"
     "template <>\nstruct KdOuter<double>::Inner { static double next(double x) { static double n = 0; return x + (n += 1); } };",
     "v = KdOuter<Scalar>::Inner::next(v);"),
    ("specialisedinnerobject", "template <class T>\nstruct KeOuter { struct Inner { T next(T x) const { return x; } }; T next(T x) const { return Inner().next(x); } };\n"
     "template <>\nstruct KeOuter<double>::Inner { double next(double x) const { static double n = 0; return x + (n += 1); } };",
     "v = KeOuter<Scalar>().next(v);"),
    ("specialisedmembertemplate", "template <class T>\nstruct KfMember { template <class U> static U next(U x) { return x; } };\n"
     "template <>\ntemplate <>\ninline double KfMember<double>::next<double>(double x) { static double n = 0; return x + (n += 1); }",
     "v = KfMember<Scalar>::next(v);"),
    ("specialisedfriend", "template <class T> struct KhBox { T x; template <class U> friend U kh_read(KhBox<U> b); };\n"
     "template <class U> U kh_read(KhBox<U> b) { return b.x; }\n"
     "template <> inline double kh_read<double>(KhBox<double> b) { static double n = 0; return b.x + (n += 1); }",
     "v = kh_read(KhBox<Scalar>{v});"),
    ("enumofmember", "template <class T> struct KiHas { enum { effects = 0 }; };\ntemplate <> struct KiHas<double> { enum { effects = 1 }; };\n"
     "template <class T> T ki_next(T x) { static T n = 0; return KiHas<T>::effects != 0 ? x + (n += 1) : x; }", "v = ki_next(v);"),
    ("subscriptoperator", "template <class T> struct KjList { T n[2]; T operator[](int k) const { return n[k]; } };\n"
     "template <> inline double KjList<double>::operator[](int k) const { static double m = 0; return n[k] + (m += 1); }",
     "v = KjList<Scalar>{{v, 1}}[0];"),
    ("outerspecialised", "template <class T> struct KkOuter { template <class U> struct Inner { static U next(U x) { return x; } }; };\n"
     "template <> template <class U> struct KkOuter<double>::Inner { static U next(U x) { static U n = 0; return x + (n += 1); } };",
     "v = KkOuter<Scalar>::template Inner<Scalar>::next(v);"),
    ("unlistedlibrary", "namespace kl_own { inline float gamma(float x) { return x; } }",
     "using ::gamma;\nusing kl_own::gamma;\nv = gamma(v);"),
    laws("secondcall", "namespace K_space {\ntemplate <class T> struct K_V { T x; operator T() const { return x; } };\n"
         "inline double fabs(K_V<double> p) { static double n = 0; return p.x + (n += 1); }\n}",
         "using std::fabs;\nv += fabs(v);\nv = fabs(K_space::K_V<Scalar>{v});"),
]
