// Rows of the CPU: copies between layouts.
#include "../conversions.h"

#include "../errors.h"
#include "../groups.h"
#include "../timing.h"

namespace physgen::bench {

namespace {

template <class Type, class From, class To>
class HostConversionCase final : public TimedHostCase {
  using Source = Array<typename Type::Object, float, Host, From>;
  using Target = Array<typename Type::Object, float, Host, To>;

 public:
  explicit HostConversionCase(index_t objects)
      : TimedHostCase(2.0 * static_cast<double>(objects) * Source::record_bytes), from_(objects), to_(objects) {
    fill_random(from_);
  }
  double run() override {
    const Stopwatch watch;
    physgen::copy(to_, from_);
    return watch.seconds();
  }
  Accuracy check() override {
    poison(to_.storage());
    run();
    return compare_copies(to_, from_);
  }

 private:
  Source from_;
  Target to_;
};

template <class Type, class From, class To>
void add_row(std::vector<Row>& rows, index_t objects) {
  Row row = conversion_row<Type>("convert_", layout_name<From>() + "_to_" + layout_name<To>(), "float", SpaceKind::host,
                                 objects, 2.0 * Array<typename Type::Object, float, Host, From>::record_bytes);
  row.make = [objects] { return std::make_unique<HostConversionCase<Type, From, To>>(objects); };
  rows.push_back(std::move(row));
}

template <class Type>
void add_rows(std::vector<Row>& rows, index_t objects) {
  add_row<Type, Aos, Soa>(rows, objects);
  add_row<Type, Aos, Aosoa<16>>(rows, objects);
  add_row<Type, Soa, Aos>(rows, objects);
  add_row<Type, Soa, Aosoa<16>>(rows, objects);
  add_row<Type, Aosoa<16>, Aos>(rows, objects);
  add_row<Type, Aosoa<16>, Soa>(rows, objects);
}

}  // namespace

void add_host_conversion_rows(std::vector<Row>& rows, index_t objects) {
  add_rows<Bytes36>(rows, objects);
  add_rows<Bytes48>(rows, objects);
}

}  // namespace physgen::bench
