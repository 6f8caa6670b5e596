// Kernels whose bytes cannot be counted: a compiler must refuse them, with words that say why. refused.py compares what
// it reports.
#include <fem/solver/linear/count_bytes.h>

using namespace physgen;

namespace {

/// A kernel with a constructor, so that nobody sees its members.
class Hidden {
 public:
  explicit Hidden(float x) : x_(x) {}
  [[nodiscard]] float x() const { return x_; }

 private:
  float x_;
};

struct Seventeen {
  int a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q;
};
struct Sixteen {
  int a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p;
};

}  // namespace

/// refused a_kernel_with_hidden_members: the members of this type cannot be looked at
void a_kernel_with_hidden_members(fem::ByteCounter<Host>& on) { on.run(1, Hidden(1.0F)); }
/// refused a_kernel_of_seventeen_members: a kernel of more members needs its own line here
void a_kernel_of_seventeen_members(fem::ByteCounter<Host>& on) { on.run(1, Seventeen{}); }

// ---- What is not refused ----
void accepted(fem::ByteCounter<Host>& on) { on.run(1, Sixteen{}); }
