// Copies between layouts and formats on the device, and between host and device from pinned and pageable memory and
// from objects that lie scattered.
#include <cuda_runtime_api.h>
#include <physgen/cuda/check.h>
#include <physgen/gather.h>

#include <algorithm>
#include <random>

#include "groups/conversions.h"
#include "measure/cuda.h"
#include "measure/host.h"

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

/// A plain transfer of so many bytes between pinned memory and the device. @return what gives its time [s]
std::function<double()> plain_transfer(index_t bytes, bool up) {
  const auto pinned = std::make_shared<Buffer>(SpaceKind::pinned, bytes, "the host's side of a transfer");
  const auto device = std::make_shared<Buffer>(SpaceKind::cuda, bytes, "the device's side of a transfer");
  return [pinned, device, up] {
    return HostDevice::time([&] {
      const auto size = static_cast<std::size_t>(pinned->bytes());
      cuda::check(up ? cudaMemcpyAsync(device->data(), pinned->data(), size, cudaMemcpyHostToDevice)
                     : cudaMemcpyAsync(pinned->data(), device->data(), size, cudaMemcpyDeviceToHost),
                  "transferring");
      synchronize();
    });
  };
}

/// Wall clock around work of the host and the device.
struct Between {
  template <class Work>
  static double time(const Work& work) {
    return HostDevice::time([&] {
      work();
      synchronize();
    });
  }
  static std::function<double()> copy(double /*bytes*/) { return {}; }
  static void poison(const UntypedArray& array) {
    array.space == SpaceKind::cuda ? CudaDevice::poison(array) : HostDevice::poison(array);
  }
};

/// Between host and device, with a plain transfer beside it of the bytes that copy_range() says have travelled.
template <class Source, class Target>
Case transfer_case(index_t objects, bool up) {
  Case made = conversion_case<Between, Source, Target>(objects, 0);
  Source from(objects);
  Target to(objects);
  const index_t travelled = copy_range(to.untyped(), from.untyped(), 0, objects);
  synchronize();
  made.bytes = static_cast<double>(travelled);
  made.copy = plain_transfer(travelled, up);
  return made;
}

/// From objects that were allocated one by one, in an order in which they do not lie, as a simulator comes to hold them
/// after a while. Beside it: packing them into an array of the host, with all cores.
template <class Object, class Layout>
Case scattered_case(index_t objects) {
  using Value = typename Object::template Value<float>;
  struct Item {
    Value value;
    char other[64];  // what a simulator keeps beside it
  };
  struct State {
    Array<Object, float, Host, Aos> expected, packed;
    Array<Object, float, Cuda, Layout> target;
    std::vector<std::unique_ptr<Item>> items;
    std::vector<Item*> pointers;
  };
  const auto value_of = [](const Item& item) { return item.value; };
  const auto state = std::make_shared<State>();
  state->expected.resize(objects);
  state->packed.resize(objects);
  fill_random(state->expected);
  for (index_t i = 0; i < objects; ++i) {
    state->items.push_back(std::make_unique<Item>());
    state->pointers.push_back(state->items.back().get());
  }
  std::shuffle(state->pointers.begin(), state->pointers.end(), std::mt19937_64(20100622));
  for (index_t i = 0; i < objects; ++i) {
    state->pointers[static_cast<std::size_t>(i)]->value = state->expected.view().get(i);
  }
  gather(state->target, std::span<Item* const>(state->pointers), value_of);
  Case made;
  made.bytes = 2.0 * static_cast<double>(objects) * Array<Object, float, Cuda, Layout>::record_bytes;
  made.run = [state, value_of] {
    return Between::time([&] { gather(state->target, std::span<Item* const>(state->pointers), value_of); });
  };
  made.copy = [state, value_of] {
    const auto view = state->packed.view();
    return HostDevice::time([&] {
      parallel_for(Host{}, view.size(),
                   lanes<1>([&](index_t i) { view.put(i, value_of(*state->pointers[static_cast<std::size_t>(i)])); }));
    });
  };
  made.check = [state, run = made.run] {
    CudaDevice::poison(state->target.untyped());
    run();
    Array<Object, float, Host, Aos> result(state->target.size());
    copy(result, state->target);
    synchronize();
    return compare_copies(result, state->expected);
  };
  return made;
}

template <class Type>
struct Transfers {
  std::vector<Row>& rows;
  index_t objects;
  using Object = typename Type::Object;

  /// @tparam Space of the host's side @tparam CudaFormats of the device's
  template <class Space, class From, class To, class CudaFormats = FormatsOf<Object, Cuda>>
  void up(const char* storage = "float") const {
    add<Space, Array<Object, float, Space, From>, Array<Object, float, Cuda, To, CudaFormats>>(
        layout_name<From>() + "_to_" + layout_name<To>(), storage, true);
  }
  template <class Space, class From, class To, class CudaFormats = FormatsOf<Object, Cuda>>
  void down(const char* storage = "float") const {
    add<Space, Array<Object, float, Cuda, From, CudaFormats>, Array<Object, float, Space, To>>(
        layout_name<From>() + "_to_" + layout_name<To>(), storage, false);
  }

 private:
  template <class Space, class Source, class Target>
  void add(const std::string& layouts, const char* storage, bool is_up) const {
    const char* kernel = Space::kind == SpaceKind::pinned ? "transfer_pinned_" : "transfer_pageable_";
    add_conversion<Type>(rows, kernel, layouts, storage, SpaceKind::cuda, objects,
                         [n = objects, is_up] { return transfer_case<Source, Target>(n, is_up); });
  }
};

template <class Type>
void add_type(std::vector<Row>& rows, index_t objects) {
  add_copy<CudaDevice, Type, Aos, Soa>(rows, objects);
  add_copy<CudaDevice, Type, Aos, Aosoa<32>>(rows, objects);
  add_copy<CudaDevice, Type, Soa, Aos>(rows, objects);
  add_copy<CudaDevice, Type, Soa, Aosoa<32>>(rows, objects);
  add_copy<CudaDevice, Type, Aosoa<32>, Aos>(rows, objects);
  add_copy<CudaDevice, Type, Aosoa<32>, Soa>(rows, objects);
  add_copy<CudaDevice, Type, AosPadded, Aosoa<32>>(rows, objects);
  add_copy<CudaDevice, Type, Aosoa<32>, AosPadded>(rows, objects);
  add_copy<CudaDevice, Type, Aosoa<32>, Aosoa<32>, HalfFormats>(rows, objects, "half");
  add_copy<CudaDevice, Type, Aos, Aosoa<32>, HalfFormats>(rows, objects, "half");
  const index_t half = objects / 2;
  const Transfers<Type> between{rows, half};
  between.template up<PinnedHost, Aos, Aosoa<32>>();
  between.template up<PinnedHost, Soa, Aosoa<32>>();
  between.template up<Host, Aos, Aosoa<32>>();
  between.template down<PinnedHost, Aosoa<32>, Aos>();
  between.template down<Host, Aosoa<32>, Aos>();
  between.template up<PinnedHost, Aos, Aosoa<32>, HalfFormats>("half");
  between.template up<Host, Aos, Aosoa<32>, HalfFormats>("half");
  between.template down<PinnedHost, Aosoa<32>, Aos, HalfFormats>("half");
  between.template down<Host, Aosoa<32>, Aos, HalfFormats>("half");
  add_conversion<Type>(rows, "transfer_scattered_", "objects_to_aosoa32", "float", SpaceKind::cuda, half,
                       [half] { return scattered_case<typename Type::Object, Aosoa<32>>(half); });
}

[[maybe_unused]] const bool rows =
    add(Part{"conversions", 0, "", "cuda", [](std::vector<Row>& rows, const Sizes& sizes) {
               add_type<Bytes36>(rows, sizes.cuda);
               add_type<Bytes48>(rows, sizes.cuda);
             }});

}  // namespace

}  // namespace physgen::bench
