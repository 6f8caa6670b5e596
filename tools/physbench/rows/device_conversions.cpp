// Rows of the GPU: copies between layouts and formats on the device, and between host and device from pinned and
// pageable memory and from objects allocated one by one.
#include <cuda_runtime_api.h>
#include <physgen/cuda/check.h>
#include <physgen/gather.h>
#include <physgen/parallel_for.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "../conversions.h"
#include "../cuda_timing.h"
#include "../errors.h"
#include "../groups.h"
#include "../timing.h"

namespace physgen::bench {

namespace {

/// All entries of the 48-byte objects, or of the 36-byte ones, in half.
struct HalfFormats {
  using F = format::Half<>;
  using x1111 = format::Half<>;
  using x2211 = format::Half<>;
  using x3311 = format::Half<>;
  using x2222 = format::Half<>;
  using x3322 = format::Half<>;
  using x3333 = format::Half<>;
  using x2121 = format::Half<>;
  using x2112 = format::Half<>;
  using x3131 = format::Half<>;
  using x3113 = format::Half<>;
  using x3232 = format::Half<>;
  using x3223 = format::Half<>;
};

/// On the device.
template <class Source, class Target>
class DeviceConversionCase final : public TimedCudaCase {
 public:
  explicit DeviceConversionCase(index_t objects)
      : TimedCudaCase(static_cast<double>(objects) * (Source::record_bytes + Target::record_bytes)),
        host_(objects),
        from_(objects),
        to_(objects) {
    fill_random(host_);
    physgen::copy(from_, host_);
  }
  double run() override {
    watch().start();
    physgen::copy(to_, from_);
    return watch().stop();
  }
  Accuracy check() override {
    poison_device(to_.storage());
    run();
    Host_ result(to_.size());
    physgen::copy(result, to_);
    synchronize();
    return compare_copies(result, host_);
  }

 private:
  using Host_ = Array<typename Source::Object, float, Host, Aos>;
  Host_ host_;
  Source from_;
  Target to_;
};

/// As poison() of errors.h, in any space.
void poison_anywhere(const Storage& storage) {
  if (storage.space == SpaceKind::cuda) {
    TimedCudaCase::poison_device(storage);
  } else {
    poison(storage);
  }
}

/// Between host and device, with a plain transfer of the bytes that travel beside it.
template <class Source, class Target>
class TransferCase final : public Case {
 public:
  TransferCase(index_t objects, index_t travelling_bytes, bool up)
      : host_(objects),
        from_(objects),
        to_(objects),
        pinned_(SpaceKind::pinned, objects * travelling_bytes, "the host's side of a transfer"),
        device_(SpaceKind::cuda, objects * travelling_bytes, "the device's side of a transfer"),
        up_(up) {
    fill_random(host_);
    physgen::copy(from_, host_);
    synchronize();
  }
  double run() override {
    const Stopwatch watch;
    physgen::copy(to_, from_);
    synchronize();
    return watch.seconds();
  }
  double copy() override {
    const Stopwatch watch;
    const auto bytes = static_cast<std::size_t>(pinned_.bytes());
    cuda::check(up_ ? cudaMemcpyAsync(device_.data(), pinned_.data(), bytes, cudaMemcpyHostToDevice)
                    : cudaMemcpyAsync(pinned_.data(), device_.data(), bytes, cudaMemcpyDeviceToHost),
                "transferring");
    synchronize();
    return watch.seconds();
  }
  Accuracy check() override {
    poison_anywhere(to_.storage());
    run();
    Host_ result(to_.size());
    physgen::copy(result, to_);
    synchronize();
    return compare_copies(result, host_);
  }

 private:
  using Host_ = Array<typename Source::Object, float, Host, Aos>;
  Host_ host_;
  Source from_;
  Target to_;
  Buffer pinned_, device_;
  bool up_;
};

/// From objects that were allocated one by one, in the order in which a simulator may come to hold them. Beside it:
/// packing them into an array of the host, with all cores.
template <class Object, class Layout>
class ScatteredCase final : public Case {
  using Value = typename Object::template Value<float>;
  struct Item {
    Value value;
    char other[64];  // what a simulator keeps beside it
  };

 public:
  explicit ScatteredCase(index_t objects) : expected_(objects), packed_(objects) {
    fill_random(expected_);
    items_.reserve(static_cast<std::size_t>(objects));
    for (index_t i = 0; i < objects; ++i) {
      items_.push_back(std::make_unique<Item>());
      items_.back()->value = expected_.view().get(i);
      pointers_.push_back(items_.back().get());
    }
    gather(std::span<Item* const>(pointers_), target_, value_of);
  }
  double run() override {
    const Stopwatch watch;
    gather(std::span<Item* const>(pointers_), target_, value_of);
    synchronize();
    return watch.seconds();
  }
  double copy() override {
    const Stopwatch watch;
    const auto view = packed_.view();
    parallel_for<1>(Host{}, view.size(),
                    [&](index_t i) { view.put(i, value_of(*pointers_[static_cast<std::size_t>(i)])); });
    return watch.seconds();
  }
  Accuracy check() override {
    poison_anywhere(target_.storage());
    run();
    Array<Object, float, Host, Aos> result(target_.size());
    physgen::copy(result, target_);
    synchronize();
    return compare_copies(result, expected_);
  }

 private:
  static constexpr auto value_of = [](const Item& item) noexcept { return item.value; };
  Array<Object, float, Host, Aos> expected_, packed_;
  Array<Object, float, Cuda, Layout> target_;
  std::vector<std::unique_ptr<Item>> items_;
  std::vector<Item*> pointers_;
};

template <class Type>
struct Rows {
  std::vector<Row>& rows;
  index_t objects;
  using Object = typename Type::Object;

  template <class From, class To, class ToFormats = FormatsOf<Object, Cuda>>
  void device(const char* storage = "float") const {
    using Source = Array<Object, float, Cuda, From>;
    using Target = Array<Object, float, Cuda, To, ToFormats>;
    add<DeviceConversionCase<Source, Target>>("convert_", layout_name<From>() + "_to_" + layout_name<To>(), storage,
                                              Source::record_bytes + Target::record_bytes);
  }
  template <class Space, class From, class To, class CudaFormats = FormatsOf<Object, Cuda>>
  void up(const char* storage = "float") const {
    using Source = Array<Object, float, Space, From>;
    using Target = Array<Object, float, Cuda, To, CudaFormats>;
    transfer<Space, Source, Target>(layout_name<From>() + "_to_" + layout_name<To>(), storage, Source::record_bytes,
                                    Target::record_bytes, true);
  }
  template <class Space, class From, class To, class CudaFormats = FormatsOf<Object, Cuda>>
  void down(const char* storage = "float") const {
    using Source = Array<Object, float, Cuda, From, CudaFormats>;
    using Target = Array<Object, float, Space, To>;
    transfer<Space, Source, Target>(layout_name<From>() + "_to_" + layout_name<To>(), storage, Target::record_bytes,
                                    Source::record_bytes, false);
  }
  template <class Layout>
  void scattered() const {
    add<ScatteredCase<Object, Layout>>("transfer_scattered_", "objects_to_" + layout_name<Layout>(), "float",
                                       2.0 * Array<Object, float, Cuda, Layout>::record_bytes);
  }

 private:
  template <class MeasuredCase, class... More>
  void add(const char* kernel, const std::string& layouts, const char* storage, double bytes, More... more) const {
    Row row = conversion_row<Type>(kernel, layouts, storage, SpaceKind::cuda, objects, bytes);
    const index_t n = objects;
    row.make = [n, more...]() -> std::unique_ptr<Case> { return std::make_unique<MeasuredCase>(n, more...); };
    rows.push_back(std::move(row));
  }
  // What travels: from and to pinned memory the host's form, else the smaller one.
  template <class Space, class Source, class Target>
  void transfer(const std::string& layouts, const char* storage, int host_bytes, int cuda_bytes, bool is_up) const {
    constexpr bool pinned = Space::kind == SpaceKind::pinned;
    const int bytes = pinned ? host_bytes : std::min(host_bytes, cuda_bytes);
    add<TransferCase<Source, Target>>(pinned ? "transfer_pinned_" : "transfer_pageable_", layouts, storage, bytes,
                                      index_t{bytes}, is_up);
  }
};

template <class Type>
void add_rows(std::vector<Row>& rows, index_t objects) {
  const Rows<Type> of{rows, objects};
  of.template device<Aos, Soa>();
  of.template device<Aos, Aosoa<32>>();
  of.template device<Soa, Aos>();
  of.template device<Soa, Aosoa<32>>();
  of.template device<Aosoa<32>, Aos>();
  of.template device<Aosoa<32>, Soa>();
  of.template device<AosPadded, Aosoa<32>>();
  of.template device<Aosoa<32>, AosPadded>();
  of.template device<Aosoa<32>, Aosoa<32>, HalfFormats>("half");
  of.template device<Aos, Aosoa<32>, HalfFormats>("half");
  const Rows<Type> between{rows, objects / 2};
  between.template up<PinnedHost, Aos, Aosoa<32>>();
  between.template up<PinnedHost, Soa, Aosoa<32>>();
  between.template up<Host, Aos, Aosoa<32>>();
  between.template down<PinnedHost, Aosoa<32>, Aos>();
  between.template down<Host, Aosoa<32>, Aos>();
  // The rule by which transfer.cu chooses who converts: pinned memory travels whole, the host narrows pageable memory.
  between.template up<PinnedHost, Aos, Aosoa<32>, HalfFormats>("half");
  between.template up<Host, Aos, Aosoa<32>, HalfFormats>("half");
  between.template down<PinnedHost, Aosoa<32>, Aos, HalfFormats>("half");
  between.template down<Host, Aosoa<32>, Aos, HalfFormats>("half");
  between.template scattered<Aosoa<32>>();
}

}  // namespace

void add_cuda_conversion_rows(std::vector<Row>& rows, index_t objects) {
  add_rows<Bytes36>(rows, objects);
  add_rows<Bytes48>(rows, objects);
}

}  // namespace physgen::bench
