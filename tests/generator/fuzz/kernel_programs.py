"""Kernels that do something beside using their views, each run by two neighbouring steps; and kernels that only compute.

A part is what stands at namespace scope before a kernel, and statements of its body that may change its number v. What a part
does on the side is seen in v: of two steps that are joined, the second would find it otherwise."""
from precision_programs import CHOSEN_IN_DOUBLE
from scene_programs import Block


def counter(name, text, head=""):
    """A part with a counter k_NAME, for which K stands."""
    return name, f"inline float k_{name} = 0;\n{head}".replace("K", f"k_{name}"), text.replace("K", f"k_{name}")


EFFECTS = [
    ("staticinbody", "", "static float n = 0;\nn += 1;\nv += n;"),
    ("staticinif", "", "if (static float n = 0; (n += 1) > 0) v += n;"),
    ("staticinfunction", "inline float k_static() { static float n = 0; return n += 1; }", "v += k_static();"),
    ("staticreference", "inline float& k_single() { static float n = 0; return n; }", "v += k_single() += 1;"),
    ("staticinlambda", "", "const auto f = [] { static float n = 0; return n += 1; };\nv += f();"),
    ("staticmember", "struct KStatic { static inline float n = 0; };", "const KStatic k;\nv += k.n += 1;"),
    ("threadlocal", "inline thread_local float k_thread = 0;", "v += k_thread += 1;"),
    ("threadlocalinbody", "", "thread_local float n = 0;\nv += n += 1;"),
    ("volatileglobal", "inline volatile float k_volatile = 0;", "k_volatile = k_volatile + 1;\nv += k_volatile;"),
    ("volatilelocal", "", "volatile float n = 1;\nn = n + 1;\nv += n;"),
    ("atomic", "inline std::atomic<int> k_atomic = 0;", "v += ++k_atomic;"),
    ("atomicadds", "inline std::atomic<int> k_adds = 0;", "v += k_adds.fetch_add(1);"),
    ("syncs", "inline int k_syncs = 0;", "v += __sync_fetch_and_add(&k_syncs, 1);"),
    ("table", "inline float k_table[2] = {};", "v += k_table[1] += 1;"),
    ("optional", "inline std::optional<float> k_optional = 0;", "v += *k_optional += 1;"),
    ("function", "inline std::function<float()> k_function = [n = 0.0F]() mutable { return n += 1; };", "v += k_function();"),
    ("vector", "inline std::vector<float> k_vector;", "k_vector.push_back(1);\nv += k_vector.size();"),
    ("prints", "", "v += std::cout.precision(std::cout.precision() + 1);"),
    ("printf", "", "v += std::printf(\"%s\", \"\");"),
    ("random", "", "v += std::rand() % 7;"),
    ("eigenrandom", "", "v += Eigen::Matrix<float, 2, 1>::Random()(0);"),
    ("rounds", "", "v += std::fegetround();\nstd::fesetround(v > 2 ? FE_TONEAREST : FE_UPWARD);"),
    ("errors", "", "errno = errno + 1;\nv += errno;"),
    ("environment", "", "v += std::getenv(\"K_ENVIRONMENT\") != nullptr;\nsetenv(\"K_ENVIRONMENT\", \"1\", 1);"),
    ("assembler", "", "asm volatile(\"\" : : : \"memory\");"),
    ("jumps", "", "int n = 0;\nagain: if (++n < 3) goto again;\nv += n;"),
    ("throws", "", "try { throw 1; } catch (int n) { v += n; }"),
    ("statementexpression", "", "v += ({ static float n = 0; n += 1; n; });"),
    ("pointercast", "inline float k_cast = 0;\nstruct KAddress { std::uintptr_t n; };\ninline const KAddress k_address{reinterpret_cast<std::uintptr_t>(&k_cast)};",
     "v += *reinterpret_cast<float*>(k_address.n) += 1;"),
    counter("global", "v += K += 1;"),
    counter("called", "v += K_next();", "inline float K_next() { return K += 1; }"),
    counter("calleddeeper", "v += K_outer();", "inline float K_next() { return K += 1; }\ninline float K_outer() { return K_next() * 2; }"),
    counter("reference", "v += K_same += 1;", "inline float& K_same = K;"),
    counter("localreference", "float& n = K;\nv += n += 1;"),
    counter("boundreference", "auto& [n] = K_pair;\nv += n += 1;", "struct KBound { float n; };\ninline KBound K_pair{0};"),
    counter("pointer", "v += *K_at += 1;", "inline float* const K_at = &K;"),
    counter("constexprpointer", "v += *K_at += 1;", "constexpr float* K_at = &K;"),
    counter("heldpointer", "v += *K_held.at += 1;", "struct KHeld { float* at; };\ninline const KHeld K_held{&K};"),
    counter("functionpointer", "float (*const f)() = K_next;\nv += f();", "inline float K_next() { return K += 1; }"),
    counter("globalfunctionpointer", "v += K_at();", "inline float K_next() { return K += 1; }\ninline float (*const K_at)() = K_next;"),
    counter("memberpointer", "const KMember k;\nfloat (KMember::*const f)() const = &KMember::next;\nv += (k.*f)();",
            "struct KMember { float next() const { return K += 1; } };"),
    counter("templatereference", "v += KBump<K>::next();", "template <auto& n>\nstruct KBump { static float next() { return n += 1; } };"),
    counter("templatefunction", "v += KCall<K_next>::next();", "inline float K_next() { return K += 1; }\n"
            "template <float (*f)()>\nstruct KCall { static float next() { return f(); } };"),
    counter("comma", "v += (K += 1, K);"),
    counter("condition", "v += v > 0 ? K += 1 : 2;"),
    counter("loop", "for (; K < 2 + v; K += 1) v += K;"),
    counter("conversion", "v += KConverts();", "struct KConverts { operator float() const { return K += 1; } };"),
    counter("operation", "v += KPlus() + 1;", "struct KPlus { float operator+(int) const { return K += 1; } };"),
    counter("subscript", "v += KElements()[1];", "struct KElements { float operator[](int) const { return K += 1; } };"),
    counter("literalword", "v += 1.0_K;", "inline float operator\"\"_K(long double) { return K += 1; }"),
    counter("constructor", "v += KMade(1).n;", "struct KMade { float n; KMade(int) : n(K += 1) {} };"),
    counter("defaultconstructor", "const KBegun k;\nv += k.n;", "struct KBegun { float n; KBegun() { n = K += 1; } };"),
    counter("inheritedconstructor", "v += KHeir(1).n;", "struct KFirst { float n; KFirst(int) : n(K += 1) {} };\nstruct KHeir : KFirst { using KFirst::KFirst; };"),
    counter("baseconstructor", "v += KOver().n;", "struct KUnder { float n; KUnder() : n(K += 1) {} };\nstruct KOver : KUnder {};"),
    counter("copyconstructor", "const KCopied k;\nconst KCopied c = k;\nv += c.n;",
            "struct KCopied { float n = 0; KCopied() = default; KCopied(const KCopied&) : n(K += 1) {} };"),
    counter("initialiser", "v += KInitialised{}.n;", "struct KInitialised { float n = K += 1; };"),
    counter("filler", "const KFills k[2] = {};\nv += k[1].n;", "struct KFills { float n; KFills() : n(K += 1) {} };"),
    counter("fillerinitialiser", "const KFilled k[2] = {};\nv += k[1].n;", "struct KFilled { float n = K += 1; };"),
    counter("argument", "v += K_default();", "inline float K_default(float n = K += 1) { return n; }"),
    counter("destructor", "{ const KEnded k; }\nv += K;", "struct KEnded { ~KEnded() { K += 1; } };"),
    counter("memberdestructor", "{ const KHas k; }\nv += K;", "struct KPart { ~KPart() { K += 1; } };\nstruct KHas { KPart part; };"),
    counter("temporarydestructor", "v += KTemporary().n;\nv += K;", "struct KTemporary { float n = 1; ~KTemporary() { K += 1; } };"),
    counter("cleanup", "{ [[gnu::cleanup(K_clean)]] float n = 1; v += n; }\nv += K;", "inline void K_clean(float*) { K += 1; }"),
    counter("assignment", "KAssigned k;\nk = 3;\nv += K;", "struct KAssigned { void operator=(int) { K += 1; } };"),
    counter("virtualcall", "const KDerived d;\nconst KAbstract& b = d;\nv += b.next();",
            "struct KAbstract { virtual float next() const { return 1; } };\nstruct KDerived : KAbstract { float next() const override { return K += 1; } };"),
    counter("lambda", "v += [&] { return K += 1; }();"),
    counter("genericlambda", "const auto f = [](auto by) { return K += by; };\nv += f(1);"),
    counter("initcapture", "v += [n = K += 1] { return n; }();"),
    counter("invoked", "v += std::invoke([] { return K += 1; });"),
    counter("applied", "v += std::apply([](float by) { return K += by; }, std::tuple(1.0F));"),
    counter("compared", "v += std::max(1.0F, 2.0F, [](float a, float b) { K += 1; return a < b; });\nv += K;"),
    counter("less", "v += std::max(KLess{1}, KLess{2}).n + K;", "struct KLess { float n; bool operator<(const KLess& o) const { K += 1; return n < o.n; } };"),
    counter("unary", "v += Eigen::Matrix<float, 2, 1>(1, 2).unaryExpr([](float x) { return x + (K += 1); }).sum();"),
    counter("mapped", "v += Eigen::Map<Eigen::Matrix<float, 1, 1>>(&K)(0) += 1;"),
    counter("recursion", "v += K_times(3);", "inline float K_times(int n) { return n == 0 ? K += 1 : K_times(n - 1); }"),
    counter("allocates", "const float* n = new float(K += 1);\nv += *n;\ndelete n;"),
    counter("placement", "new (&K) float(K + 1);\nv += K;"),
    counter("rangefor", "for (const float n : KRange()) v += n;", "struct KRange { float n = K += 1; const float* begin() const { return &n; } const float* end() const { return &n + 1; } };"),
    counter("friendfunction", "v += next(KFriend());", "struct KFriend { friend float next(KFriend) { return K += 1; } };"),
    counter("localclass", "struct Local { static float next() { return K += 1; } };\nv += Local::next();"),
    counter("directive", "\n#ifndef K_NO_MACRO\nv += K += 1;\n#endif"),
    counter("conceptual", "v += K_any(1);", "template <class T> requires(sizeof(T) > 0)\ninline float K_any(T by) { return K += by; }"),
]

# Those do it in double alone, which is not the precision that physgen reads.
IN_DOUBLE = [
    ("overloaded", "inline float k_chosen(float x) { return x; }\ninline double k_chosen(double x) { static double n = 0; return x + (n += 1); }", "v += k_chosen(v);"),
    ("overloadstemplate", "template <class T> T k_templated(T x) { return x; }\ninline double k_templated(double x) { static double n = 0; return x + (n += 1); }",
     "v += k_templated(v);"),
    ("specialised", "template <class T>\nstruct KSpecial { static T next() { return 1; } };\n"
     "template <>\nstruct KSpecial<double> { static double next() { static double n = 0; return n += 1; } };", "v += KSpecial<Scalar>::next();"),
    ("alias", "struct KSingle { template <class T> static T read(T x) { return x; } };\n"
     "struct KDouble { template <class T> static T read(T x) { static T n = 0; return x + (n += 1); } };",
     "using Law = std::conditional_t<sizeof(Scalar) == 8, KDouble, KSingle>;\nv = Law::read(v);"),
    ("argument", "template <bool kDouble, class T>\nT k_given(T x) {\n  if constexpr (kDouble) { static T n = 0; x += n += 1; }\n  return x;\n}",
     "v = k_given<sizeof(Scalar) == 8>(v);"),
    ("defaultargument", "template <class T, bool kDouble = sizeof(T) == 8>\nT k_defaulted(T x) {\n"
     "  if constexpr (kDouble) { static T n = 0; x += n += 1; }\n  return x;\n}", "v = k_defaulted(v);"),
    ("branches", "template <class T>\nT k_branch(T x) {\n  if constexpr (sizeof(T) == 8) { static T n = 0; x += n += 1; }\n  return x;\n}", "v += k_branch(v);"),
    ("constrained", "template <class T> T k_constrained(T x) { return x; }\n"
     "template <class T> requires(sizeof(T) == 8) T k_constrained(T x) { static T n = 0; return x + (n += 1); }", "v += k_constrained(v);"),
    ("converts", "struct KTwo { operator float() const { return 1; } operator double() const { static double n = 0; return n += 1; } };", "v += Scalar(KTwo());"),
    ("constructs", "struct KBuilt { float n; KBuilt(float x) : n(x) {} KBuilt(double) { static float m = 0; n = m += 1; } };", "v += KBuilt(v).n;"),
    ("dependentalias", "struct HaS { template <class T> static T read(T x) { return x; } };\n"
     "struct HaD { template <class T> static T read(T x) { static T n = 0; return x + (n += 1); } };\n"
     "template <class T> struct HaPick { using type = HaS; };\n"
     "template <> struct HaPick<double> { using type = HaD; };",
     "using Law = typename HaPick<Scalar>::type;\nv = Law::read(v);"),
    ("aliastemplate", "struct HbS { template <class T> static T read(T x) { return x; } };\n"
     "struct HbD { template <class T> static T read(T x) { static T n = 0; return x + (n += 1); } };\n"
     "template <class T> struct HbPick { using type = HbS; };\n"
     "template <> struct HbPick<double> { using type = HbD; };\n"
     "template <class T> using HbLaw = typename HbPick<T>::type;",
     "v = HbLaw<Scalar>::read(v);"),
    ("aliastemplatelocal", "struct HcS { template <class T> static T read(T x) { return x; } };\n"
     "struct HcD { template <class T> static T read(T x) { static T n = 0; return x + (n += 1); } };\n"
     "template <class T> struct HcPick { using type = HcS; };\n"
     "template <> struct HcPick<double> { using type = HcD; };",
     "const typename HcPick<Scalar>::type law{};\nv = law.read(v);"),
    ("tagdispatch", "struct HeS {}; struct HeD {};\n"
     "template <class T> struct HeTag { using type = HeS; };\n"
     "template <> struct HeTag<double> { using type = HeD; };\n"
     "template <class T> T he_read(T x, HeS) { return x; }\n"
     "template <class T> T he_read(T x, HeD) { static T n = 0; return x + (n += 1); }",
     "v = he_read(v, typename HeTag<Scalar>::type());"),
    ("methodofreturned", "struct HgS { float read(float x) const { return x; } };\n"
     "struct HgD { double read(double x) const { static double n = 0; return x + (n += 1); } };\n"
     "inline HgS hg_of(float) { return {}; }\n"
     "inline HgD hg_of(double) { return {}; }",
     "v = hg_of(v).read(v);"),
    ("autolocal", "struct HhS { float read(float x) const { return x; } };\n"
     "struct HhD { double read(double x) const { static double n = 0; return x + (n += 1); } };\n"
     "inline HhS hh_of(float) { return {}; }\n"
     "inline HhD hh_of(double) { return {}; }",
     "const auto law = hh_of(v);\nv = law.read(v);"),
    ("usingtwo", "namespace hi_one { inline float hi_read(float x) { return x; } }\n"
     "namespace hi_two { inline double hi_read(double x) { static double n = 0; return x + (n += 1); } }",
     "using hi_one::hi_read;\nusing hi_two::hi_read;\nv = hi_read(v);"),
    ("adl", "namespace hj_one { struct S { float x; }; inline float hj_read(S s) { return s.x; } }\n"
     "namespace hj_two { struct D { double x; }; inline double hj_read(D s) { static double n = 0; return s.x + (n += 1); } }\n"
     "inline hj_one::S hj_of(float x) { return {x}; }\n"
     "inline hj_two::D hj_of(double x) { return {x}; }",
     "v = hj_read(hj_of(v));"),
    ("adltemplate", "namespace hk_one { struct S {}; template <class B> float hk_read(B s) { return s.x; } }\n"
     "namespace hk_two { struct D {}; template <class B> double hk_read(B s) { static double n = 0; return s.x + (n += 1); } }\n"
     "template <class T, class Tag> struct HkBox { T x; };\n"
     "inline HkBox<float, hk_one::S> hk_of(float x) { return {x}; }\n"
     "inline HkBox<double, hk_two::D> hk_of(double x) { return {x}; }",
     "v = hk_read(hk_of(v));"),
    ("libraryorown", "namespace hl { inline double fabs(double x) { static double n = 0; return x + (n += 1); } inline double max(double x, double) { static double n = 0; return x + (n += 1); } }",
     "using std::max;\nusing hl::max;\nv = max(v, Scalar(1));"),
    ("friendindouble", "template <class T> struct HvBox { T x; friend T hv_read(HvBox b) { return b.x; } };\n"
     "template <> struct HvBox<double> { double x; friend double hv_read(HvBox b) { static double n = 0; return b.x + (n += 1); } };",
     "v = hv_read(HvBox<Scalar>{v});"),
    ("variabletemplate", "struct HwS { template <class T> T operator()(T x) const { return x; } };\n"
     "struct HwD { template <class T> T operator()(T x) const { static T n = 0; return x + (n += 1); } };\n"
     "template <class T> inline constexpr HwS hw_law{};\n"
     "template <> inline constexpr HwD hw_law<double>{};",
     "v = hw_law<Scalar>(v);"),
    ("operators", "namespace hy_one { struct S { float x; }; inline float operator+(S s, float y) { return s.x + y; } }\n"
     "namespace hy_two { struct D { double x; }; inline double operator+(D s, double y) { static double n = 0; return s.x + y + (n += 1); } }\n"
     "inline hy_one::S hy_of(float x) { return {x}; }\n"
     "inline hy_two::D hy_of(double x) { return {x}; }",
     "v = hy_of(v) + Scalar(1);"),
    ("membertype", "struct HzS { template <class T> static T read(T x) { return x; } };\n"
     "struct HzD { template <class T> static T read(T x) { static T n = 0; return x + (n += 1); } };\n"
     "template <class T> struct HzLaws { using Law = HzS; };\n"
     "template <> struct HzLaws<double> { using Law = HzD; };\n"
     "template <class T> T hz_read(T x) { using Law = typename HzLaws<T>::Law; return Law::read(x); }",
     "v = hz_read(v);"),
    ("memberofclass", "struct HoS { template <class T> static T read(T x) { return x; } };\n"
     "struct HoD { template <class T> static T read(T x) { static T n = 0; return x + (n += 1); } };\n"
     "template <class T> struct HoPick { using type = HoS; };\n"
     "template <> struct HoPick<double> { using type = HoD; };\n"
     "template <class T> struct HoHolds { typename HoPick<T>::type law; };",
     "const HoHolds<Scalar> holds{};\nv = holds.law.read(v);"),
    ("baseofclass", "struct HpS { template <class T> T read(T x) const { return x; } };\n"
     "struct HpD { template <class T> T read(T x) const { static T n = 0; return x + (n += 1); } };\n"
     "template <class T> struct HpPick { using type = HpS; };\n"
     "template <> struct HpPick<double> { using type = HpD; };\n"
     "template <class T> struct HpIs : HpPick<T>::type {};",
     "v = HpIs<Scalar>().read(v);"),
]
EFFECTS += [("indouble" + name, head, text) for name, head, text in IN_DOUBLE + CHOSEN_IN_DOUBLE]

# Kernels whose members do it: what they have beside their views, and how the steps give it.
MEMBERS = [
    ("pointermember", "float* n;", "&s", "v += *n += 1;", "float*"),
    ("referencemember", "float& n;", "s", "v += n += 1;", "float&"),
    ("lambdamember", "F f;", "tick", "v += f();", "F"),
    ("functionmember", "std::function<float()> f;", "tick", "v += f();", "std::function<float()>"),
    ("mutablemember", "mutable float n;", "1", "v += n += 1;", "float"),
    ("constcast", "float n;", "1", "v += const_cast<float&>(n) += 1;", "float"),
    ("plaincast", "float n;", "1", "v += (float&)n += 1;", "float"),
    ("functionalcast", "float n;", "1", "using R = float&;\nv += R(n) += 1;", "float"),
    ("keptview", "float n;", "1", "static std::optional<To> kept;\nv += kept.has_value();\nkept.emplace(to);", "float"),
]

HARMLESS = [
    ("computes", "", "v = v * 2 + 1;"),
    ("constants", "inline constexpr float h_constants[3] = {1, 2, 3};\ninline const float h_constant = 3;", "v += h_constants[1] + h_constant;"),
    ("branches", "", "if (v > 2) { v -= 1; } else v += 3;\nswitch (int(v)) { case 1: v = 4; break; default: v += 1; }"),
    ("loops", "", "for (int n = 0; n < 3; ++n) v += n;\nint n = 0;\nwhile (n < 2) v += ++n;\ndo { --n; } while (n > 0);"),
    ("tabulates", "", "float n[3] = {1, 2, 3};\nn[1] += v;\nv = n[1] + n[2];"),
    ("swaps", "inline void h_swap(float& a, float& b) { const float c = a; a = b; b = c; }", "float n = 3, m = v;\nh_swap(n, m);\nv = n - m;"),
    ("calls", "template <class T> constexpr T h_twice(T x) { T y = x; y += x; return y; }", "v = h_twice(v);"),
    ("recurses", "constexpr float h_sum(int n) { return n == 0 ? 0 : n + h_sum(n - 1); }", "v += h_sum(4);"),
    ("objects", "struct HPair { float x, y = 2; float sum() const { return x + y; } HPair operator+(const HPair& o) const { return {x + o.x, y + o.y}; } };",
     "HPair p{v};\np.x += 1;\nv = (p + HPair{1, 1}).sum();"),
    ("makes", "struct HMade { float n; explicit HMade(float x) : n(x + 1) {} operator float() const { return n; } };", "v = HMade(v);"),
    ("captures", "", "float n = 1;\nconst auto f = [&](auto by) { n += by; };\nf(2);\nf(v);\nv = n;"),
    ("invokes", "struct HAdds { float operator()(float x) const { return x + 1; } };", "v = std::invoke(HAdds(), v);"),
    ("compares", "", "v = std::max(v, Scalar(2)) + std::min<Scalar>(v, 3) + (v < 1 ? 1 : 2);"),
    ("mathematics", "", "v = std::sqrt(std::abs(v)) + std::floor(v);"),
    ("vectors", "", "Eigen::Matrix<float, 2, 1> n(1, 2);\nn *= 2;\nv += n.dot(n) + n.sum();"),
    ("applies", "", "v += Eigen::Matrix<float, 2, 1>(1, 2).unaryExpr([](float x) { return x * 2; }).sum();"),
    ("readspointer", "inline float hn_sum(const float* p) { return p[0] + p[1]; }",
     "float n[2] = {1, 2};\nv += hn_sum(n);"),
    ("writespointer", "inline void ho_set(float* p) { p[1] = 3; }",
     "float n[2] = {1, 2};\nho_set(n);\nv += n[1];"),
    ("binds", "struct HrPair { float x, y; };",
     "auto [a, b] = HrPair{v, 2};\nv = a + b;"),
    ("choosesobjects", "struct HsA { float f() const { return 1; } };",
     "v += (v > 0 ? HsA() : HsA()).f();"),
    ("stdarrays", "",
     "std::array<float, 2> n{1, 2};\nn[1] += v;\nv = n[0] + n[1];"),
    ("enumerates", "enum class Ht { one = 1, two };",
     "const Ht t = v > 0 ? Ht::one : Ht::two;\nv += static_cast<int>(t);"),
    ("puns", "union HqU { float f; unsigned n; };",
     "HqU u{v};\nu.n += 0;\nv = u.f;"),
    ("membersconstant", "template <class T>\nstruct KgMember { static const int n; };\ntemplate <class T>\nconst int KgMember<T>::n = 1;\n"
     "inline int kg_next() { static int n = 0; return n += 1; }\ntemplate <>\ninline const int KgMember<double>::n = kg_next();", "v += KgMember<Scalar>::n;"),
    ("commas", "", "int n = 0, m = 0;\nfor (; n < 3; ++n, --m) v += m;"),
]


def kernel(name, text, member="", type_="", by=""):
    """The head of a kernel NAME of this body, and the text of two steps that run it."""
    f = ", class F" if type_ == "F" else ""
    given = f", {by}" if member else ""
    guide = (f"template <class A, class B{f}>\n{name}(A, B, {type_}) -> {name}<A, B{', F' if f else ''}>;" if member else
             f"template <class... V>\n{name}(V...) -> {name}<V...>;")
    return (f"template <class From, class To{f}>\nstruct {name} {{\n  using Scalar = typename To::Precision;\n  From from;\n  To to;\n  {member}\n"
            f"  template <class I>\n  PHYSGEN_FUNCTION void operator()(I i) const {{\n    using S = lanes_t<Scalar, I>;\n    Scalar v = 1;\n    {text}\n"
            f"    to[i].a() = S(from[i].a()) * S(Scalar(0.5)) + S(v);\n  }}\n}};\n{guide}\n",
            f"on.run(N, {name}{{IN.const_view(), MID.view(){given}}});\non.run(N, {name}{{MID.view(), OUT.view(){given}}});")


def of_part(name, _, text, joined):
    made, steps = kernel("Kernel" + name, text)
    return Block("k" + name, steps, made, joined)


def of_member(name, member, by, text, type_):
    made, steps = kernel("Kernel" + name, text, member, type_, by)
    declared = "float s = 1; const auto tick = [&] { return s += 1; };\n" if by in ("s", "&s", "tick") else ""
    return Block("k" + name, declared + steps, made)


KERNELS = ([of_part(*part, False) for part in EFFECTS] + [of_member(*part) for part in MEMBERS] + [of_part(*part, True) for part in HARMLESS])
