#include "calc/meshes/mesh_gltf_accessor.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <utility>

namespace calc::gltf {
namespace {

struct NumberType {
  std::size_t bytes;
  double largest;  // of the normalised form; 0 = it has none
};

NumberType number_type(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return {1, 127.0};
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return {1, 255.0};
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return {2, 32767.0};
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return {2, 65535.0};
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return {4, 0.0};
    default:
      fail("accessor with component type {}", component_type);
  }
}

template <class T>
double copied(const unsigned char* data) {
  T number;
  std::memcpy(&number, data, sizeof number);
  return static_cast<double>(number);
}

double number_at(const unsigned char* data, int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copied<std::int8_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copied<std::uint8_t>(data);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copied<std::int16_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copied<std::uint16_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copied<std::uint32_t>(data);
    default:
      return copied<float>(data);
  }
}

// `count` elements of `components` numbers each, as they stand in a buffer view; all of it is
// there.
struct Elements {
  const unsigned char* data;
  std::size_t stride, count, components;
  int component_type;

  double number(std::size_t element, std::size_t component) const {
    const std::size_t size = number_type(component_type).bytes;
    return number_at(data + element * stride + component * size, component_type);
  }
};

Elements elements_in(const tinygltf::Model& model, int view_index, std::size_t offset,
                     std::size_t count, std::size_t components, int component_type,
                     bool may_stride) {
  const tinygltf::BufferView& view = checked(model.bufferViews, view_index, "buffer view");
  const std::vector<unsigned char>& bytes = checked(model.buffers, view.buffer, "buffer").data;
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
    fail("buffer view {} reaches beyond its buffer of {} bytes", view_index, bytes.size());
  }
  const std::size_t size = components * number_type(component_type).bytes;
  const std::size_t stride = may_stride && view.byteStride > 0 ? view.byteStride : size;
  const std::size_t room = offset <= view.byteLength ? view.byteLength - offset : 0;
  if (stride < size || count == 0 || room < size || count - 1 > (room - size) / stride) {
    fail("an accessor of {} elements does not fit into buffer view {} of {} bytes", count,
         view_index, view.byteLength);
  }
  return {bytes.data() + view.byteOffset + offset, stride, count, components, component_type};
}

// tinygltf has int before 2.9, and std::size_t for some since.
template <std::integral Number>
std::size_t whole(Number number, const char* what) {
  if (std::cmp_less(number, 0)) fail("sparse accessor: {} is {}", what, number);
  return static_cast<std::size_t>(number);
}

void replace_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                    std::size_t components, std::vector<double>& numbers) {
  const auto& sparse = accessor.sparse;
  const std::size_t count = whole(sparse.count, "the count");
  const Elements index =
      elements_in(model, sparse.indices.bufferView, whole(sparse.indices.byteOffset, "an offset"),
                  count, 1, sparse.indices.componentType, false);
  const Elements value =
      elements_in(model, sparse.values.bufferView, whole(sparse.values.byteOffset, "an offset"),
                  count, components, accessor.componentType, false);
  for (std::size_t i = 0; i < count; ++i) {
    const double at = index.number(i, 0);
    if (!(at >= 0.0 && at < static_cast<double>(accessor.count))) {
      fail("sparse accessor: element {} of {} is replaced", at, accessor.count);
    }
    for (std::size_t c = 0; c < components; ++c) {
      numbers[static_cast<std::size_t>(at) * components + c] = value.number(i, c);
    }
  }
}

}  // namespace

std::vector<double> read_accessor(const tinygltf::Model& model, int index, int type,
                                  std::size_t components, std::size_t most) {
  const tinygltf::Accessor& accessor = checked(model.accessors, index, "accessor");
  if (accessor.type != type) fail("accessor {} has another type than its use needs", index);
  if (accessor.count > most) fail("accessor {} has {} elements", index, accessor.count);
  if (accessor.bufferView < 0) fail("accessor {} has no data", index);
  const Elements elements = elements_in(model, accessor.bufferView, accessor.byteOffset,
                                        accessor.count, components, accessor.componentType, true);
  std::vector<double> numbers;
  numbers.reserve(elements.count * components);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t c = 0; c < components; ++c) numbers.push_back(elements.number(i, c));
  }
  if (accessor.sparse.isSparse) replace_sparse(model, accessor, components, numbers);
  const double largest = number_type(accessor.componentType).largest;
  if (accessor.normalized && largest > 0.0) {
    for (double& number : numbers) number = std::max(number / largest, -1.0);
  }
  return numbers;
}

}  // namespace calc::gltf
